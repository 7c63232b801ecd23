// Both passes walk rows, so that the inner loop runs over contiguous texels.
#include "libbake/base/gaussian.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"

namespace texbake {
namespace {

int border_index(int i, int n, Wrap border) { return border == Wrap::repeat ? wrap(i, n) : std::clamp(i, 0, n - 1); }

template <class T>
Image<T> blur(ImageView<const T> image, double sigma_px, Wrap border) {
  const std::vector<float> kernel = gaussian_kernel(sigma_px);
  const int radius = static_cast<int>(kernel.size()) / 2;
  const int width = image.width();
  const int height = image.height();

  // Horizontal pass, over a row that is extended by the radius on both sides.
  Image<T> horizontal(width, height);
  parallel_for(0, height, [&](int y) {
    std::vector<T> extended(static_cast<size_t>(width + 2 * radius));
    for (int x = -radius; x < width + radius; ++x)
      extended[static_cast<size_t>(x + radius)] = image(border_index(x, width, border), y);
    T* out = horizontal.row(y);
    for (int d = 0; d <= 2 * radius; ++d) {
      const float weight = kernel[static_cast<size_t>(d)];
      for (int x = 0; x < width; ++x) out[x] += extended[static_cast<size_t>(x + d)] * weight;
    }
  });

  // Vertical pass, one whole source row for each weight.
  Image<T> result(width, height);
  parallel_for(0, height, [&](int y) {
    T* out = result.row(y);
    for (int d = -radius; d <= radius; ++d) {
      const float weight = kernel[static_cast<size_t>(d + radius)];
      const T* in = horizontal.row(border_index(y + d, height, border));
      for (int x = 0; x < width; ++x) out[x] += in[x] * weight;
    }
  });
  return result;
}

}  // namespace

std::vector<float> gaussian_kernel(double sigma_px) {
  const int radius = static_cast<int>(std::ceil(3.0 * sigma_px));
  std::vector<double> weights;
  double sum = 0.0;
  for (int d = -radius; d <= radius; ++d) {
    weights.push_back(radius == 0 ? 1.0 : portable_exp(-0.5 * d * d / (sigma_px * sigma_px)));
    sum += weights.back();
  }
  std::vector<float> kernel;
  kernel.reserve(weights.size());
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

Image<float> gaussian_blur(ImageView<const float> image, double sigma_px, Wrap wrap) {
  return blur(image, sigma_px, wrap);
}
Image<V3f> gaussian_blur(ImageView<const V3f> image, double sigma_px, Wrap wrap) { return blur(image, sigma_px, wrap); }

}  // namespace texbake
