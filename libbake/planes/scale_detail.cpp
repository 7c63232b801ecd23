#include "libbake/planes/scale_detail.h"

#include <algorithm>
#include <cmath>

#include "libbake/color/luv.h"
#include "libbake/planes/prepare.h"

namespace texbake {

size_t classes_of(const StackScale& scale) {
  return scale.input.colors ? scale.input.colors->palette.classes.size() : 1;
}

std::vector<V3f> dominant_colors(const StackScale& scale) {
  std::vector<V3f> colors;
  if (scale.input.colors)
    for (const ColorClass& c : scale.input.colors->palette.classes)
      colors.push_back(linear_from_luv(c.dominant) * scale.strength);
  return colors;
}

namespace {

Image<V3f> times(ImageView<const V3f> colors, const V3f& factor) {
  Image<V3f> products(colors.width(), colors.height());
  for (int y = 0; y < products.height(); ++y)
    for (int x = 0; x < products.width(); ++x) products(x, y) = colors(x, y) * factor;
  return products;
}

Imath::V3d mean_of(ImageView<const V3f> colors) {
  Imath::V3d mean(0);
  for (int y = 0; y < colors.height(); ++y) {
    Imath::V3d row(0);
    for (int x = 0; x < colors.width(); ++x) row += Imath::V3d(colors(x, y));
    mean += row / (double{1} * colors.width() * colors.height());
  }
  return mean;
}

/// The base, with what its noises add on the average.
Image<V3f> mean_base(const EvaluatorInput& input) {
  Image<V3f> base = times(input.base, V3f(1));
  if (!input.noise) return base;
  const NoiseMean noise(input.noise->tiles, input.noise->space);
  for (int y = 0; y < base.height(); ++y)
    for (int x = 0; x < base.width(); ++x) {
      Imath::V4f weights(0);
      for (size_t k = 0; k < input.noise->masks.size(); ++k) weights[static_cast<int>(k)] = input.noise->masks[k](x, y);
      base(x, y) += V3f(noise.change(base(x, y), weights));
    }
  return base;
}

/// What a noise is multiplied with where its light is by `strength`.
V3f in_space(const V3f& strength, NoiseSpace space) {
  if (space == NoiseSpace::linear) return strength;
  return {std::sqrt(strength.x), std::sqrt(strength.y), std::sqrt(strength.z)};
}

/// With the gains of the scale's classes.
Image<V3f> gained(const StackScale& scale, Image<V3f> detail) {
  const bool gains = scale.transfer && scale.input.colors && !scale.transfer->detail_gains.empty();
  const std::vector<V3f> dominants = gains ? dominant_colors(scale) : std::vector<V3f>();
  if (!gains) return detail;
  for (int y = 0; y < detail.height(); ++y)
    for (int x = 0; x < detail.width(); ++x) {
      const size_t k = scale.input.colors->index(x, y);
      const float gain = scale.transfer->detail_gains[k];
      if (gain != 1.0f) detail(x, y) = dominants[k] + (detail(x, y) - dominants[k]) * gain;
    }
  return detail;
}

}  // namespace

TilePlanes strong_planes(const StackScale& scale) {
  EvaluatorInput input = scale.input;
  input.maps.clear();        // a stack passes colors alone
  input.soft_border_px = 0;  // their levels are made of the base with its gains
  const Image<V3f> base = times(input.base, scale.strength);
  input.base = base;
  std::vector<Image<V3f>> noises;
  if (input.noise) {
    for (const auto& tile : input.noise->tiles)
      noises.push_back(times(tile, in_space(scale.strength, input.noise->space)));
    input.noise->tiles.assign(noises.begin(), noises.end());
  }
  return prepare_tile(input);
}

Image<V3f> detail_of(const StackScale& scale) { return gained(scale, times(scale.input.base, scale.strength)); }

Image<V3f> mean_detail_of(const StackScale& scale) {
  return gained(scale, times(mean_base(scale.input), scale.strength));
}

Image<V3f> dominant_of(const StackScale& scale) {
  const V2i size = size_of(scale);
  const std::vector<V3f> dominants = dominant_colors(scale);
  Image<V3f> image(size.x, size.y);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      image(x, y) =
          dominants.empty() ? scale.input.base(x, y) * scale.strength : dominants[scale.input.colors->index(x, y)];
  return image;
}

TileMeans tile_means(const StackScale& scale, const Image<V3f>& detail) {
  Imath::V3d dominant(0), whole(0);
  const std::vector<V3f> dominants = dominant_colors(scale);
  for (int y = 0; y < detail.height(); ++y) {
    Imath::V3d dominant_row(0), whole_row(0);
    for (int x = 0; x < detail.width(); ++x) {
      whole_row += Imath::V3d(detail(x, y));
      if (!dominants.empty()) dominant_row += Imath::V3d(dominants[scale.input.colors->index(x, y)]);
    }
    dominant += dominant_row;
    whole += whole_row;
  }
  const double texels = static_cast<double>(detail.size());
  return {V3f(dominant / texels), V3f(whole / texels)};
}

Image<glsl::FragmentTexel> fragment_plane(const StackScale& scale) {
  const V2i size = size_of(scale);
  Image<glsl::FragmentTexel> plane(size.x, size.y);
  const FragmentMap* fragments = scale.input.fragments;
  const PrincipalVariation* colors = scale.input.colors;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      glsl::FragmentTexel& texel = plane(x, y);
      if (colors) texel.class_idx = colors->index(x, y);
      if (!fragments) continue;
      const uint32_t idx = fragments->partition.idx(x, y);
      const OwnerOffset owner = fragments->partition.owner(x, y);
      const V2i way = fragments->partition.centers[idx] + V2i(owner.x * size.x - x, owner.y * size.y - y);
      texel.center_x = static_cast<int16_t>(way.x);
      texel.center_y = static_cast<int16_t>(way.y);
      texel.fragment_class = static_cast<int16_t>(fragments->fragments[idx].class_idx);
    }
  return plane;
}

void set_strengths(std::vector<StackScale>& scales) {
  constexpr double kMost = 16;  // as of gains
  for (StackScale& scale : scales) {
    scale.strength = V3f(1);
    if (!scale.transfer || scale.transfer->detail == DetailStrength::absolute) continue;
    const Imath::V3d coarse = mean_of(mean_base(scales.front().input)), own = mean_of(mean_base(scale.input));
    for (int c = 0; c < 3; ++c)
      scale.strength[c] = static_cast<float>(coarse[c] < kMost * own[c] ? std::max(coarse[c], 0.0) / own[c] : kMost);
  }
}

}  // namespace texbake
