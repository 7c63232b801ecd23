#include "libbake/content/low_passed.h"

#include <algorithm>

#include "libbake/base/gaussian.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

constexpr int kCells = 64;            // along the shorter side
constexpr double kSigmaShare = 16.0;  // σ is this part of the shorter side

// The mean of the texels of a cell.
V3f cell_mean(ImageView<const V3f> luv, V2i cell, const CellGrid& grid) {
  const V2i begin = grid.first_px(cell), end = grid.first_px(cell + V2i(1, 1));
  V3f sum(0);
  for (int y = begin.y; y < end.y; ++y)
    for (int x = begin.x; x < end.x; ++x) sum += luv(x, y);
  return sum / static_cast<float>((end.x - begin.x) * (end.y - begin.y));
}

V3f mean_of(ImageView<const V3f> image) {
  double sum[3] = {};
  for (const V3f& c : image)
    for (int i = 0; i < 3; ++i) sum[i] += static_cast<double>(c[i]);
  const auto n = static_cast<double>(image.size());
  return {static_cast<float>(sum[0] / n), static_cast<float>(sum[1] / n), static_cast<float>(sum[2] / n)};
}

}  // namespace

LowPassed low_passed(ImageView<const V3f> luv, float scale) {
  const int side = std::min(luv.width(), luv.height());
  const auto cells_along = [&](int n) { return std::min(n, (n * kCells + side / 2) / side); };
  LowPassed low;
  low.grid = {{luv.width(), luv.height()}, {cells_along(luv.width()), cells_along(luv.height())}};
  const V2i cells = low.grid.cells;

  Image<V3f> means(cells.x, cells.y);
  parallel_for(0, cells.y, [&](int y) {
    for (int x = 0; x < cells.x; ++x) means(x, y) = cell_mean(luv, {x, y}, low.grid);
  });

  const double sigma = std::min(cells.x, cells.y) / (kSigmaShare * static_cast<double>(scale));
  low.color = gaussian_blur(means, sigma, Wrap::repeat);
  const V3f mean = mean_of(low.color);
  for (V3f& c : low.color) {
    c -= mean;
    low.energy += static_cast<double>(c.length2()) / static_cast<double>(low.color.size());
  }
  return low;
}

}  // namespace texbake
