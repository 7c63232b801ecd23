#include "libbake/planes/box_mean.h"

#include "libbake/base/parallel.h"

namespace texbake {
namespace {

using V3d = Imath::V3d;

/// Sums of `side` neighbors along x: the first by adding them, the next by what enters and leaves. Values are halves,
/// or floats near 1: their sums are exact in double, or as good as.
Image<V3d> sums_along_x(const Image<V3d>& image, int side) {
  const int width = image.width();
  Image<V3d> sums(width, image.height());
  parallel_for(0, image.height(), [&](int y) {
    V3d sum(0);
    for (int i = 0; i < side; ++i) sum += image(wrap(i - side / 2, width), y);
    for (int x = 0; x < width; ++x) {
      sums(x, y) = sum;
      sum += image(wrap(x + side - side / 2, width), y) - image(wrap(x - side / 2, width), y);
    }
  });
  return sums;
}

Image<V3d> transposed(const Image<V3d>& image) {
  Image<V3d> turned(image.height(), image.width());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) turned(y, x) = image(x, y);
  return turned;
}

}  // namespace

Image<glsl::vec4> box_means(const Image<V3f>& tile, int side) {
  Image<V3d> values(tile.width(), tile.height());
  for (size_t i = 0; i < tile.size(); ++i) values.data()[i] = V3d(tile.data()[i]);
  const Image<V3d> sums = transposed(sums_along_x(transposed(sums_along_x(values, side)), side));
  const double area = static_cast<double>(side) * side;
  Image<glsl::vec4> means(tile.width(), tile.height(), {0, 0, 0, 0});
  for (size_t i = 0; i < means.size(); ++i) {
    const V3f mean(sums.data()[i] / area);
    means.data()[i] = {mean.x, mean.y, mean.z, 0};
  }
  return means;
}

}  // namespace texbake
