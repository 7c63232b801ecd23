#include "libbake/tile/seam_join.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/base/parallel.h"
#include "libbake/color/channels.h"

namespace texbake {
namespace {

constexpr double kLargestSigmaPx = 16;
constexpr float kLeastWeight = 1e-6f;  // further from the cut than its Gaussian reaches

double sigma_px(const Seam& seam) { return std::min(seam.overlap / 5.0, kLargestSigmaPx); }

// Smooths a strip: borders are clamped, but a closed strip goes on from its last row to its first.
template <class T>
Image<T> smooth_strip(const Image<T>& strip, const Seam& seam) {
  const double sigma = sigma_px(seam);
  if (seam.ends == CutEnds::open) return gaussian_blur(strip, sigma, Wrap::clamp);
  const int more = static_cast<int>(std::ceil(3 * sigma));
  Image<T> ring(strip.width(), strip.height() + 2 * more);
  for (int y = 0; y < ring.height(); ++y)
    std::copy_n(strip.row(wrap(y - more, strip.height())), strip.width(), ring.row(y));
  const Image<T> smooth = gaussian_blur(ring, sigma, Wrap::clamp);
  Image<T> result(strip.width(), strip.height());
  for (int y = 0; y < strip.height(); ++y) std::copy_n(smooth.row(y + more), strip.width(), result.row(y));
  return result;
}

// 1 at the texels of the strip beside the cut, 0 elsewhere.
Image<float> beside_cut(const Seam& seam) {
  const int rows = static_cast<int>(seam.column.size());
  Image<float> beside(seam.overlap, rows);
  for (int y = 0; y < rows; ++y) {
    const int x = seam.column[y];
    beside(x - 1, y) = beside(x, y) = 1;
    if (y + 1 == rows && seam.ends == CutEnds::open) break;
    const int next = (y + 1) % rows;
    const auto [low, high] = std::minmax(x, seam.column[next]);
    for (int i = low; i < high; ++i) beside(i, y) = beside(i, next) = 1;
  }
  return beside;
}

// The share of the mismatch that each texel of the strip takes: up to ± ½ at the cut, falling off to 0 with distance
// and towards the borders of the strip, beyond which there is nothing to level with.
Image<float> level_weights(const Seam& seam) {
  const int rows = static_cast<int>(seam.column.size());
  const int more = static_cast<int>(std::ceil(3 * sigma_px(seam)));
  Image<float> side(seam.overlap + 2 * more, rows);  // 1 where the further columns are shown
  for (int y = 0; y < rows; ++y) std::fill_n(side.row(y), seam.column[y] + more, 1.0f);
  const Image<float> smooth = smooth_strip(side, seam);

  Image<float> weights(seam.overlap, rows);
  const float ramp = static_cast<float>(std::max(sigma_px(seam) / 2, 1.0));
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < seam.overlap; ++x) {
      const float to_border = static_cast<float>(std::min(x, seam.overlap - 1 - x)) + 0.5f;
      weights(x, y) = (smooth(x + more, y) - side(x + more, y)) * std::min(to_border / ramp, 1.0f);
    }
  return weights;
}

// How much the further columns differ from the nearer ones along the cut, smoothed: the mean over the cut's texels.
template <class T>
Image<T> smooth_mismatch(ImageView<const T> image, const Seam& seam) {
  const Image<float> beside = beside_cut(seam);
  Image<T> mismatch(seam.overlap, image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int i = 0; i < seam.overlap; ++i)
      mismatch(i, y) = (image(seam.begin + seam.period + i, y) - image(seam.begin + i, y)) * beside(i, y);
  Image<T> smooth = smooth_strip(mismatch, seam);
  const Image<float> weight = smooth_strip(beside, seam);
  for (size_t i = 0; i < smooth.size(); ++i)
    smooth.data()[i] *= weight.data()[i] > kLeastWeight ? 1 / weight.data()[i] : 0;
  return smooth;
}

template <class T>
Image<T> join(ImageView<const T> image, const Seam& seam) {
  assert(seam.overlap >= 2 && seam.overlap <= seam.period && image.height() == static_cast<int>(seam.column.size()));
  const Image<T> mismatch = smooth_mismatch(image, seam);
  const Image<float> weights = level_weights(seam);
  const std::pair<T, T> range = channel_range(image);
  Image<T> joined(seam.period, image.height());
  parallel_for(0, image.height(), [&](int y) {
    for (int x = 0; x < seam.period; ++x)
      joined(x, y) = image(seam.begin + x + (x < seam.column[y] ? seam.period : 0), y);
    for (int x = 0; x < seam.overlap; ++x)
      if (weights(x, y) != 0)
        joined(x, y) = clamp_channels(T(joined(x, y) + mismatch(x, y) * weights(x, y)), range.first, range.second);
  });
  return joined;
}

}  // namespace

Image<V3f> join_along_x(ImageView<const V3f> image, const Seam& seam) { return join(image, seam); }
Image<float> join_along_x(ImageView<const float> image, const Seam& seam) { return join(image, seam); }

}  // namespace texbake
