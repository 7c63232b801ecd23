// Draws a window of a stack of scales for the eye, as viewer.frag does of one tile: the scale that shows, and how it is put
// together.
uniform uvec2 origin_tile;   // as in stack.frag, as are the next seven
uniform ivec2 origin_offset;
uniform uint step_256;
uniform int view_scale;
uniform int level_256;
uniform float fading;
uniform float variation;
uniform vec3 slant;
uniform int samples;         // as in viewer.frag, as are the next two
uniform int height_px;
uniform int show;

out vec4 screen;

vec3 sample_color(Position at) {
  if (show == 0) {
    StackProbes seen;
    seen.row.at = at;
    seen.row.axis_256 = ivec2(0, 0);
    seen.row.halvings = 0;
    seen.row.level_256 = level_256;
    seen.scale = view_scale;
    seen.coarser_halvings = 0;
    seen.fading = fading;
    seen.variation = variation;
    return sight_value(window_sight(seen, slant), kFilterBilinear).rgb;
  }
  Texel texel = texel_at(at);
  Decision decision = decide(texel);
  Source source = source_of(texel, decision);
  if (show == 1) return color_of(uint(decision.patch_idx));
  if (show == 3) return color_of(uint(decision.content));
  // A fragment has no number here, but a center of its own.
  ivec2 way = texelFetch(fragment_plane, ivec2(source.nearest.x, source.nearest.y + plane_row), 0).xy;
  int x = wrap_any(source.nearest.x + way.x, tile_size.x);
  int y = wrap_any(source.nearest.y + way.y, tile_size.y);
  return color_of(uint(x + y * tile_size.x));
}

void main() {
  uvec2 pixel = uvec2(uint(gl_FragCoord.x), uint(height_px - 1) - uint(gl_FragCoord.y));
  Position origin;
  origin.tile = origin_tile;
  origin.offset = origin_offset;
  vec3 sum = vec3(0.0);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      uvec2 place = pixel * uint(samples) + uvec2(uint(i), uint(j));
      use_scale(scale_count - 1);
      Position at = pixel_position(origin, step_256, place);
      sum += sample_color(position_in_scale(at, scale_count - 1, view_scale));
    }
  screen = vec4(srgb_from_linear(sum / float(samples * samples)), 1.0);
}
