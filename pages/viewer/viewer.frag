// Draws a window of the infinite texture for the eye: sRGB for a screen, or how the texture is put together. What it
// shows is decided by the reference; only the last step, averaging and encoding, is its own.
uniform uvec2 origin_tile;     // as in reference.frag
uniform ivec2 origin_offset;
uniform uint step_256;         // 1/256 texels from one sample to the next
uniform int samples;           // samples to a pixel on each axis: more than one where something else than color is shown
uniform int level_256;         // level of detail of the color, as in reference.frag
uniform int height_px;         // of the window: row 0 is its top
uniform int show;              // 0 color, 1 patches, 2 fragments, 3 contents
uniform usampler2D fragments;  // R32UI, W x H: fragment idx of each texel

out vec4 screen;

vec3 sample_color(Position at) {
  if (show == 0) return trilinear_value(base, noise_step == 0 ? kPlanePlain : kPlaneStructure, base_levels, at, level_256).rgb;
  Texel texel = texel_at(at);
  Decision decision = decide(texel);
  Source source = source_of(texel, decision);
  if (show == 1) return color_of(uint(decision.patch_idx));
  if (show == 2) return color_of(texelFetch(fragments, source.nearest, 0).x);
  return color_of(uint(decision.content));
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
      sum += sample_color(pixel_position(origin, step_256, place));
    }
  screen = vec4(srgb_from_linear(sum / float(samples * samples)), 1.0);
}
