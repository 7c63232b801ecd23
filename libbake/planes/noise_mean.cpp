#include "libbake/planes/noise_mean.h"

#include "libbake/base/parallel.h"

namespace texbake {

using Imath::V3d;

NoiseMean::NoiseMean(std::span<const ImageView<const V3f>> noises, NoiseSpace space) : space_(space) {
  const size_t count = noises.size();
  means_.resize(count, V3d(0));
  products_.resize(count * count, V3d(0));
  parallel_for(0, static_cast<int>(count), [&](int i) {
    const auto k = static_cast<size_t>(i);
    const auto texels = static_cast<double>(noises[k].size());
    for (const V3f& value : noises[k]) means_[k] += V3d(value);
    means_[k] /= texels;
    for (size_t l = 0; l < count; ++l) {
      V3d& product = products_[k * count + l];
      for (size_t p = 0; p < noises[k].size(); ++p) product += V3d(noises[k].data()[p]) * V3d(noises[l].data()[p]);
      product /= texels;
    }
  });
}

V3d NoiseMean::change(const V3f& structure, const Imath::V4f& weights) const {
  V3d mean(0);
  V3d square(0);
  for (size_t k = 0; k < means_.size(); ++k) {
    const auto weight = static_cast<double>(weights[static_cast<int>(k)]);
    if (weight == 0) continue;
    mean += means_[k] * weight;
    for (size_t l = 0; l < means_.size(); ++l)
      square += products_[k * means_.size() + l] * (weight * static_cast<double>(weights[static_cast<int>(l)]));
  }
  if (space_ == NoiseSpace::linear) return mean;
  return roots(V3d(structure)) * mean * 2.0 + square;
}

}  // namespace texbake
