// What a pixel of a perspective view sees of the infinite texture, as an endless plane: floating-point arithmetic that
// comes before the exact path and ends in integers (Probes).
// Based on: Heckbert 1989 (the footprint of a pixel as an ellipse). Needs levels.glsl and, bound as README.md says,
// view_corner, view_right, view_down, view_height, view_filter.

// Whether a pixel sees the plane, and where.
struct Sight {
  bool hits;
  Probes probes;
};

// log2(x) in 1/256, 2 of them off at most; x is positive and not denormal.
int log2_256(float x) {
  uint bits = floatBitsToUint(x);
  int exponent = int(bits >> 23u) - 127;
  float t = uintBitsToFloat((bits & 8388607u) | 1065353216u) - 1.0f;  // x / 2^exponent - 1
  PRECISE float bow = (1.0f - t) * 0.3466f;
  PRECISE float fraction = t * (bow + 1.0f);
  return exponent * 256 + int(fraction * 256.0f);
}

// Along one axis: the ray at a place of the view, in pixels from its upper left corner.
float ray(float corner, float right, float down, float x, float y) {
  PRECISE float along_x = right * x;
  PRECISE float along_y = down * y;
  PRECISE float sum = along_x + along_y;
  PRECISE float all = corner + sum;
  return all;
}

// a b - c d, its products rounded
float crossed(float a, float b, float c, float d) {
  PRECISE float first = a * b;
  PRECISE float second = c * d;
  PRECISE float difference = first - second;
  return difference;
}

float sum_of_squares(float a, float b) {
  PRECISE float first = a * a;
  PRECISE float second = b * b;
  PRECISE float sum = first + second;
  return sum;
}

// Level, axis and number of probes of a footprint that maps a pixel's sides to (ax, ay) and (bx, by), in texels.
Probes footprint_probes(Position at, float ax, float ay, float bx, float by) {
  // The axes of the ellipse that the unit circle becomes: eigenvectors of J J^T.
  float xx = sum_of_squares(ax, bx);
  float yy = sum_of_squares(ay, by);
  float xy = crossed(ax, ay, -bx, by);
  float half_difference = (xx - yy) * 0.5f;
  float root = sqrt(sum_of_squares(half_difference, xy));
  float major = sqrt((xx + yy) * 0.5f + root);
  float minor = abs(crossed(ax, by, ay, bx)) / major;
  float direction_x = xx < yy ? xy : half_difference + root;
  float direction_y = xx < yy ? root - half_difference : xy;
  float squared = sum_of_squares(direction_x, direction_y);

  Probes probes;
  probes.at = at;
  probes.halvings = 0;
  probes.axis_256 = ivec2(0, 0);
  int most = view_filter == 3 ? 4 : 0;
  float least = major / float(1 << most);
  float width = minor < least ? least : minor;
  int level_256 = log2_256(width);
  int last_256 = 256 * (level_count + 1);
  probes.level_256 = level_256 < 0 ? 0 : level_256 > last_256 ? last_256 : level_256;
  if (major > 65535.0f || squared < 1e-30f) return probes;
  // One probe for each width along the longer axis; bilinear filtering is a texel wide at least.
  float seen = width < 1.0f ? 1.0f : width;
  for (int i = 0; i < most; ++i)
    if (seen < major * 0.999f) {
      seen = seen * 2.0f;
      probes.halvings += 1;
    }
  float scale = major * 256.0f / sqrt(squared);
  probes.axis_256 = ivec2(int(direction_x * scale), int(direction_y * scale));
  return probes;
}

// `below` is the point of the texture under the camera; x and y are pixels from the upper left corner of the view,
// pixel (0, 0) having its centre at (0.5, 0.5).
Sight sight_at(Position below, float x, float y) {
  Sight sight;
  sight.probes.at = below;
  sight.probes.axis_256 = ivec2(0, 0);
  sight.probes.halvings = 0;
  sight.probes.level_256 = 256 * (level_count + 1);
  float dx = ray(view_corner.x, view_right.x, view_down.x, x, y);
  float dy = ray(view_corner.y, view_right.y, view_down.y, x, y);
  float dz = ray(view_corner.z, view_right.z, view_down.z, x, y);
  sight.hits = dz > 0.000001f;
  if (!sight.hits) return sight;

  // Beyond four million texels only the mean is left.
  float reach = view_height / dz;
  float to_x = dx * reach;
  float to_y = dy * reach;
  if (!(abs(to_x) < 4000000.0f && abs(to_y) < 4000000.0f)) return sight;
  ivec2 by_256 = ivec2(int(floor(to_x * 256.0f + 0.5f)), int(floor(to_y * 256.0f + 0.5f)));
  sight.probes.at = moved_position(below, by_256);
  sight.probes.level_256 = 0;
  if (view_filter < 2) return sight;

  // The derivatives of (dx, dy) / dz, times the height.
  float change = reach / dz;
  sight.probes = footprint_probes(sight.probes.at, crossed(view_right.x, dz, dx, view_right.z) * change,
                                  crossed(view_right.y, dz, dy, view_right.z) * change,
                                  crossed(view_down.x, dz, dx, view_down.z) * change,
                                  crossed(view_down.y, dz, dy, view_down.z) * change);
  return sight;
}
