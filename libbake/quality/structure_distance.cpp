// F_structure of fidelity.h: nearest windows by FLANN's linear index, exact and faster than a tree in 192 dimensions.
#include <algorithm>
#include <cmath>
#include <flann/flann.hpp>

#include "libbake/base/random.h"
#include "libbake/quality/fidelity.h"

namespace texbake {
namespace {

constexpr int kWindow = 8;
constexpr int kLeastStride = 4;
constexpr int kWindowsPerSide = 128;
constexpr int kSamples = 400;
constexpr int kDimension = kWindow * kWindow * 3;

void append_window(ImageView<const V3f> image, int x0, int y0, std::vector<float>& out) {
  for (int y = y0; y < y0 + kWindow; ++y)
    for (int x = x0; x < x0 + kWindow; ++x) {
      const V3f& c = image(x, y);
      out.insert(out.end(), {c.x, c.y, c.z});
    }
}

bool holds_window(ImageView<const V3f> image) { return image.width() >= kWindow && image.height() >= kWindow; }

double median_nearest(const flann::Index<flann::L2<float>>& index, ImageView<const V3f> image, uint32_t seed) {
  Random random(seed);
  std::vector<float> windows;
  for (int i = 0; i < kSamples; ++i) {
    const int x = static_cast<int>(random.below(static_cast<uint32_t>(image.width() - kWindow + 1)));
    const int y = static_cast<int>(random.below(static_cast<uint32_t>(image.height() - kWindow + 1)));
    append_window(image, x, y, windows);
  }
  std::vector<size_t> nearest(kSamples);
  std::vector<float> squared(kSamples);
  flann::Matrix<float> queries(windows.data(), kSamples, kDimension);
  flann::Matrix<size_t> indices(nearest.data(), kSamples, 1);
  flann::Matrix<float> distances(squared.data(), kSamples, 1);
  index.knnSearch(queries, indices, distances, 1, flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
  std::nth_element(squared.begin(), squared.begin() + kSamples / 2, squared.end());
  return std::sqrt(static_cast<double>(squared[kSamples / 2]));
}

}  // namespace

std::optional<double> structure_distance(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv,
                                         ImageView<const V3f> periodic_luv, uint32_t seed) {
  if (!holds_window(exemplar_luv) || !holds_window(rendering_luv) || !holds_window(periodic_luv)) return std::nullopt;
  std::vector<float> windows;
  const int stride = std::max(kLeastStride, std::min(exemplar_luv.width(), exemplar_luv.height()) / kWindowsPerSide);
  for (int y = 0; y + kWindow <= exemplar_luv.height(); y += stride)
    for (int x = 0; x + kWindow <= exemplar_luv.width(); x += stride) append_window(exemplar_luv, x, y, windows);
  const flann::Matrix<float> dataset(windows.data(), windows.size() / kDimension, kDimension);
  flann::Index<flann::L2<float>> index(dataset, flann::LinearIndexParams());
  index.buildIndex();
  const double reference = median_nearest(index, periodic_luv, seed);
  if (reference <= 0.0) return std::nullopt;
  return median_nearest(index, rendering_luv, seed) / reference;
}

}  // namespace texbake
