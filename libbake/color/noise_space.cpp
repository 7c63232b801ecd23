#include "libbake/color/noise_space.h"

#include <algorithm>
#include <cmath>

namespace texbake {
namespace {

template <class Change>
Image<V3f> changed(ImageView<const V3f> image, const Change& change) {
  Image<V3f> result(image.width(), image.height());
  std::transform(image.begin(), image.end(), result.begin(), change);
  return result;
}

}  // namespace

Imath::V3d roots(const Imath::V3d& light) {
  const auto root = [](double channel) { return std::sqrt(std::max(channel, 0.0)); };
  return {root(light.x), root(light.y), root(light.z)};
}

Image<V3f> in_noise_space(ImageView<const V3f> light, NoiseSpace space) {
  return changed(light, [&](const V3f& c) { return space == NoiseSpace::linear ? c : V3f(roots(Imath::V3d(c))); });
}

Image<V3f> to_light(ImageView<const V3f> values, NoiseSpace space) {
  return changed(values, [&](const V3f& c) { return space == NoiseSpace::linear ? c : c * c; });
}

}  // namespace texbake
