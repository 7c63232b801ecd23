// Draws a window of the infinite texture: its values, and the decisions behind them.
uniform uvec2 origin_tile;    // repetition in which the window's upper left corner lies, modulo 2^32
uniform ivec2 origin_offset;  // its place there, in 1/256 texel
uniform uint step_256;        // 1/256 texels to a pixel
uniform ivec2 first_row;      // row of the window on the target's lowest line, and the step to the line above: 1 or -1
uniform int filter_kind;      // kFilterNearest, or kFilterBilinear for trilinear too
uniform int level_256;        // the level of detail in 1/256, 0 ... 256 (level_count + 1); bilinear: 0
uniform int plane_kind;       // what `base` holds: kPlanePlain ... kPlaneStructure

layout(location = 0) out vec4 value;
layout(location = 1) out uvec4 decided;  // patch idx, content, source texel of labels

void main() {
  uvec2 line = uvec2(gl_FragCoord.xy);
  uvec2 pixel = uvec2(line.x, uint(first_row.x + first_row.y * int(line.y)));
  Position origin;
  origin.tile = origin_tile;
  origin.offset = origin_offset;
  Position at = pixel_position(origin, step_256, pixel);

  Texel texel = texel_at(at);
  Decision decision = decide(texel);
  Source source = source_of(texel, decision);
  decided = uvec4(uint(decision.patch_idx), uint(decision.content), uint(source.nearest.x), uint(source.nearest.y));
  if (deformed == 1) value = deformed_value(base, plane_kind, base_levels, at, filter_kind, level_256);
  else if (filter_kind == kFilterNearest) value = texel_value(base, plane_kind, base_levels, texel);
  else value = trilinear_value(base, plane_kind, base_levels, at, level_256);
}
