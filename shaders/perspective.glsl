// What a pixel of a perspective view sees of the infinite texture, as an endless plane: floating-point arithmetic that
// comes before the exact path and ends in integers (Probes).
// Based on: Heckbert 1989 (the footprint of a pixel as an ellipse). Needs levels.glsl and, bound as README.md says,
// view_corner, view_right, view_down, view_height, view_filter.

// Whether a pixel sees the plane, and where.
struct Sight {
  bool hits;
  Probes probes;
};

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

// What a pixel sees of the plane: the way there from the point under the camera, and how its sides map to the plane, in
// texels.
struct Ground {
  bool hits;
  vec2 to;
  vec2 right;
  vec2 down;
};

// x and y are pixels from the upper left corner of the view, pixel (0, 0) having its center at (0.5, 0.5).
Ground ground_at(float x, float y) {
  float dx = ray(view_corner.x, view_right.x, view_down.x, x, y);
  float dy = ray(view_corner.y, view_right.y, view_down.y, x, y);
  float dz = ray(view_corner.z, view_right.z, view_down.z, x, y);
  Ground ground;
  ground.hits = dz > 0.000001f;
  float reach = view_height / (ground.hits ? dz : 1.0f);
  ground.to = vec2(dx * reach, dy * reach);
  // The derivatives of (dx, dy) / dz, times the height.
  float change = reach / (ground.hits ? dz : 1.0f);
  ground.right = vec2(crossed(view_right.x, dz, dx, view_right.z) * change, crossed(view_right.y, dz, dy, view_right.z) * change);
  ground.down = vec2(crossed(view_down.x, dz, dx, view_down.z) * change, crossed(view_down.y, dz, dy, view_down.z) * change);
  return ground;
}

// The ellipse that the unit circle becomes, in texels; the vector is as long as it likes along the longer axis.
struct Ellipse {
  float major;
  float minor;
  vec2 direction;
  float squared;  // of the vector
};

Ellipse ellipse_of(vec2 right, vec2 down) {
  // Eigenvectors of J J^T.
  float xx = sum_of_squares(right.x, down.x);
  float yy = sum_of_squares(right.y, down.y);
  float xy = crossed(right.x, right.y, -down.x, down.y);
  float half_difference = (xx - yy) * 0.5f;
  float root = sqrt(sum_of_squares(half_difference, xy));
  Ellipse ellipse;
  ellipse.major = sqrt((xx + yy) * 0.5f + root);
  ellipse.minor = abs(crossed(right.x, down.y, right.y, down.x)) / ellipse.major;
  ellipse.direction = vec2(xx < yy ? xy : half_difference + root, xx < yy ? root - half_difference : xy);
  ellipse.squared = sum_of_squares(ellipse.direction.x, ellipse.direction.y);
  return ellipse;
}

// At most so often is a row of probes doubled.
int most_halvings() { return view_filter == kFilterAnisotropic ? 4 : 0; }

// How wide the probes of a footprint are: its shorter axis, or more where the row would have too many.
float probe_width(Ellipse ellipse) {
  float least = ellipse.major / float(1 << most_halvings());
  return ellipse.minor < least ? least : ellipse.minor;
}

// One probe for each `width` along an axis of `major`, 2^h of them.
int halvings_of(float major, float width) {
  int halvings = 0;
  float seen = width;
  for (int i = 0; i < most_halvings(); ++i)
    if (seen < major * 0.999f) {
      seen = seen * 2.0f;
      halvings += 1;
    }
  return halvings;
}

// The longer axis from its one end to the other, in 1/256 texel, where a texel is `size` of the ellipse's.
ivec2 axis_of(Ellipse ellipse, float size) {
  float scale = ellipse.major * 256.0f / sqrt(ellipse.squared) / size;
  return ivec2(int(ellipse.direction.x * scale), int(ellipse.direction.y * scale));
}

// Level, axis and number of probes of a footprint.
Probes footprint_probes(Position at, vec2 right, vec2 down) {
  Ellipse ellipse = ellipse_of(right, down);
  Probes probes;
  probes.at = at;
  probes.halvings = 0;
  probes.axis_256 = ivec2(0, 0);
  float width = probe_width(ellipse);
  int level_256 = log2_256(width);
  int last_256 = 256 * (level_count + 1);
  probes.level_256 = level_256 < 0 ? 0 : level_256 > last_256 ? last_256 : level_256;
  if (ellipse.major > 65535.0f || ellipse.squared < 1e-30f) return probes;
  // Bilinear filtering is a texel wide at least.
  probes.halvings = halvings_of(ellipse.major, width < 1.0f ? 1.0f : width);
  probes.axis_256 = axis_of(ellipse, 1.0f);
  return probes;
}

// Beyond four million texels only the mean is left.
bool within_reach(vec2 to) { return abs(to.x) < 4000000.0f && abs(to.y) < 4000000.0f; }

Position ground_position(Position below, vec2 to) {
  return moved_position(below, ivec2(int(floor(to.x * 256.0f + 0.5f)), int(floor(to.y * 256.0f + 0.5f))));
}

// `below` is the point of the texture under the camera; x and y as of ground_at.
Sight sight_at(Position below, float x, float y) {
  Sight sight;
  sight.probes.at = below;
  sight.probes.axis_256 = ivec2(0, 0);
  sight.probes.halvings = 0;
  sight.probes.level_256 = 256 * (level_count + 1);
  Ground ground = ground_at(x, y);
  sight.hits = ground.hits;
  if (!sight.hits || !within_reach(ground.to)) return sight;
  sight.probes.at = ground_position(below, ground.to);
  sight.probes.level_256 = 0;
  if (view_filter >= kFilterTrilinear) sight.probes = footprint_probes(sight.probes.at, ground.right, ground.down);
  return sight;
}
