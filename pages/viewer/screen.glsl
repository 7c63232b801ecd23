// How a viewer shows light and numbers on a screen. Not part of the reference: only what is shown is decided by it.
// Needs hash.glsl.

vec3 srgb_from_linear(vec3 light) {
  vec3 clamped = clamp(light, 0.0, 1.0);
  return mix(clamped * 12.92, pow(clamped, vec3(1.0 / 2.4)) * 1.055 - 0.055, step(vec3(0.0031308), clamped));
}

// A color that tells one number from the next.
vec3 color_of(uint number) {
  uint bits = pcg(number);
  return vec3(float(bits & 255u), float((bits >> 8u) & 255u), float((bits >> 16u) & 255u)) / 255.0 * 0.8 + 0.1;
}
