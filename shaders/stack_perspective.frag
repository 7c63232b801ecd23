// Draws a stack of scales as an endless plane in perspective: its values, and what was found before the exact path.
uniform uvec2 origin_tile;    // as in perspective.frag, of the finest scale
uniform ivec2 origin_offset;
uniform ivec2 first_row;      // as in reference.frag
uniform vec4 sky;             // where the plane is not seen

layout(location = 0) out vec4 value;
layout(location = 1) out uvec4 decided;  // decided_of; 0 for the sky

void main() {
  uvec2 line = uvec2(gl_FragCoord.xy);
  int row = first_row.x + first_row.y * int(line.y);
  Position below;
  below.tile = origin_tile;
  below.offset = origin_offset;
  StackSight sight = stack_sight_at(below, float(line.x) + 0.5f, float(row) + 0.5f);
  value = sky;
  decided = uvec4(0u, 0u, 0u, 0u);
  if (!sight.hits) return;
  decided = decided_of(sight);
  value = sight_value(sight, view_filter);
}
