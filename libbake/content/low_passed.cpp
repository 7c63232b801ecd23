#include "libbake/content/low_passed.h"

#include <algorithm>

#include "libbake/base/gaussian.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

constexpr int kCells = 64;            // along the shorter side
constexpr double kSigmaShare = 16.0;  // σ is this part of the shorter side

// The mean of the texels of a cell.
V3f cell_mean(ImageView<const V3f> luv, V2i cell, V2i cells) {
  V3f sum(0);
  int count = 0;
  for (int y = cell.y * luv.height() / cells.y; y < (cell.y + 1) * luv.height() / cells.y; ++y)
    for (int x = cell.x * luv.width() / cells.x; x < (cell.x + 1) * luv.width() / cells.x; ++x, ++count)
      sum += luv(x, y);
  return sum / static_cast<float>(count);
}

V3f mean_of(ImageView<const V3f> image) {
  double sum[3] = {};
  for (const V3f& c : image)
    for (int i = 0; i < 3; ++i) sum[i] += static_cast<double>(c[i]);
  const auto n = static_cast<double>(image.size());
  return {static_cast<float>(sum[0] / n), static_cast<float>(sum[1] / n), static_cast<float>(sum[2] / n)};
}

}  // namespace

V2i LowPassed::shift(V2i translation) const {
  const V2i t = wrap(translation, size_px);
  return {(t.x * cells().x + size_px.x / 2) / size_px.x % cells().x,
          (t.y * cells().y + size_px.y / 2) / size_px.y % cells().y};
}

LowPassed low_passed(ImageView<const V3f> luv) {
  const int side = std::min(luv.width(), luv.height());
  const auto cells_along = [&](int n) { return std::min(n, (n * kCells + side / 2) / side); };
  const V2i cells(cells_along(luv.width()), cells_along(luv.height()));

  Image<V3f> means(cells.x, cells.y);
  parallel_for(0, cells.y, [&](int y) {
    for (int x = 0; x < cells.x; ++x) means(x, y) = cell_mean(luv, {x, y}, cells);
  });

  LowPassed low;
  low.size_px = {luv.width(), luv.height()};
  low.color = gaussian_blur(means, std::min(cells.x, cells.y) / kSigmaShare, Wrap::repeat);
  const V3f mean = mean_of(low.color);
  for (V3f& c : low.color) {
    c -= mean;
    low.energy += static_cast<double>(c.length2()) / static_cast<double>(low.color.size());
  }
  return low;
}

}  // namespace texbake
