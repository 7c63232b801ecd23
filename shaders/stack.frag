// Draws a window of a stack of scales: its values, and the decisions of the scale that shows; or, with relief, what was
// found before the exact path.
uniform uvec2 origin_tile;    // as in reference.frag, of the finest scale, as is the step
uniform ivec2 origin_offset;
uniform uint step_256;
uniform ivec2 first_row;
uniform int filter_kind;      // kFilterNearest, or kFilterBilinear for trilinear too
uniform int view_scale;       // the scale that shows
uniform int level_256;        // its level of detail in 1/256, 0 ... 256 (level_count + 1)
uniform float fading;         // 0 ... 1: how far it has faded into the one before it
uniform float variation;      // 0 ... 1: share of its variation that it still has
uniform vec3 slant;           // of window_sight

layout(location = 0) out vec4 value;
layout(location = 1) out uvec4 decided;  // patch idx, content, source texel of labels; with relief decided_of

void main() {
  uvec2 line = uvec2(gl_FragCoord.xy);
  uvec2 pixel = uvec2(line.x, uint(first_row.x + first_row.y * int(line.y)));
  Position origin;
  origin.tile = origin_tile;
  origin.offset = origin_offset;
  use_scale(scale_count - 1);
  Position at = position_in_scale(pixel_position(origin, step_256, pixel), scale_count - 1, view_scale);

  Texel texel = texel_at(at);
  Decision decision = decide(texel);
  Source source = source_of(texel, decision);
  decided = uvec4(uint(decision.patch_idx), uint(decision.content), uint(source.nearest.x), uint(source.nearest.y));
  StackProbes seen;
  seen.row.at = at;
  seen.row.axis_256 = ivec2(0, 0);
  seen.row.halvings = 0;
  seen.row.level_256 = level_256;
  seen.scale = view_scale;
  seen.coarser_halvings = 0;
  seen.fading = fading;
  seen.variation = variation;
  StackSight sight = window_sight(seen, slant);
  if (relief_depth != 0.0f) decided = decided_of(sight);
  value = sight_value(sight, filter_kind);
}
