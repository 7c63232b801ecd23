// Draws a window of the infinite texture: its values, and the decisions behind them.
uniform uvec2 origin_tile;    // repetition in which the window's upper left corner lies, modulo 2^32
uniform ivec2 origin_offset;  // its place there, in 1/256 texel
uniform uint step_256;        // 1/256 texels to a pixel
uniform ivec2 first_row;      // row of the window on the target's lowest line, and the step to the line above: 1 or -1
uniform int filter_kind;      // 0 nearest, 1 bilinear
uniform int plane_kind;       // what `base` holds: 0 plain values, 1 normals with +y up, 2 normals with +y down, 3 height,
                              // 4 the structure, with noise

layout(location = 0) out vec4 value;
layout(location = 1) out uvec4 decided;  // patch idx, content, source texel of labels

vec4 nearest_value(Texel texel, Source source) {
  if (plane_kind == 1) return source_normal(base, source, 1.0f);
  if (plane_kind == 2) return source_normal(base, source, -1.0f);
  if (plane_kind == 3) return source_height(base, source);
  if (plane_kind == 4) return layered_value(base, texel, source);
  return source_value(base, source);
}

vec4 blended_value(Footprint footprint, Position at) {
  if (plane_kind == 1) return footprint_normal(base, footprint, 1.0f);
  if (plane_kind == 2) return footprint_normal(base, footprint, -1.0f);
  if (plane_kind == 3) return footprint_height(base, footprint);
  if (plane_kind == 4) return footprint_layers(base, footprint, at);
  return footprint_value(base, footprint);
}

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
  if (deformed == 1) value = filter_kind == 0 ? deformed_value(base, texel) : deformed_footprint(base, at);
  else if (filter_kind == 0) value = nearest_value(texel, source);
  else value = blended_value(footprint_at(at), at);
}
