#include "libbake/segment/denoised_colors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libbake/base/gaussian.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

Image<V3f> luv_of(const PrincipalVariation& colors) {
  Image<V3f> luv(colors.index.width(), colors.index.height());
  parallel_for(0, luv.height(), [&](int y) {
    for (int x = 0; x < luv.width(); ++x) {
      const ColorClass& c = colors.palette.classes[colors.index(x, y)];
      luv(x, y) = c.dominant + c.variation * colors.variation(x, y);
    }
  });
  return luv;
}

/// Classes are loops inside, texels outside: 64 classes fit the first cache.
void classify(const Palette& palette, const V3f& luv, uint8_t& index, float& variation) {
  float least = std::numeric_limits<float>::infinity();
  for (size_t k = 0; k < palette.classes.size(); ++k) {
    const ColorClass& c = palette.classes[k];
    const V3f d = luv - c.dominant;
    const float v = d.x * c.variation.x + d.y * c.variation.y + d.z * c.variation.z;
    const float distance = d.x * d.x + d.y * d.y + d.z * d.z - v * v;
    if (distance >= least) continue;
    least = distance;
    index = static_cast<uint8_t>(k);
    variation = v;
  }
}

}  // namespace

DenoisedColors denoised_colors(const PrincipalVariation& colors, float denoise_px) {
  DenoisedColors denoised{luv_of(colors), colors.index.clone(), colors.variation.clone()};
  if (denoise_px <= 0) return denoised;
  denoised.luv = gaussian_blur(denoised.luv, static_cast<double>(denoise_px), Wrap::repeat);
  parallel_for(0, denoised.luv.height(), [&](int y) {
    for (int x = 0; x < denoised.luv.width(); ++x)
      classify(colors.palette, denoised.luv(x, y), denoised.index(x, y), denoised.variation(x, y));
  });
  return denoised;
}

float median_variation(const Image<float>& variation) {
  std::vector<float> magnitudes;
  magnitudes.reserve(variation.size());
  for (const float v : variation) magnitudes.push_back(std::fabs(v));
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  return *middle;
}

}  // namespace texbake
