// Draws an endless plane in perspective: its values, and what was found before the exact path.
uniform uvec2 origin_tile;    // the point under the camera: repetition, modulo 2^32
uniform ivec2 origin_offset;  // and its place there, in 1/256 texel
uniform ivec2 first_row;      // as in reference.frag
uniform vec4 sky;             // where the plane is not seen
uniform int plane_kind;       // as in reference.frag

layout(location = 0) out vec4 value;
// Of the probes: offset of the middle; level_256 | (halvings + 1) << 16, 0 for the sky; axis, 16 bits of each part.
layout(location = 1) out uvec4 decided;

void main() {
  uvec2 line = uvec2(gl_FragCoord.xy);
  int row = first_row.x + first_row.y * int(line.y);
  Position below;
  below.tile = origin_tile;
  below.offset = origin_offset;
  Sight sight = sight_at(below, float(line.x) + 0.5f, float(row) + 0.5f);
  value = sky;
  decided = uvec4(0u, 0u, 0u, 0u);
  if (!sight.hits) return;
  decided = uvec4(uint(sight.probes.at.offset.x), uint(sight.probes.at.offset.y), uint(sight.probes.level_256) | (uint(sight.probes.halvings) + 1u) << 16u,
                  (uint(sight.probes.axis_256.x) & 65535u) | uint(sight.probes.axis_256.y) << 16u);
  if (view_filter == kFilterNearest) value = texel_value(base, plane_kind, base_levels, texel_at(sight.probes.at));
  else value = probes_value(base, plane_kind, base_levels, sight.probes);
}
