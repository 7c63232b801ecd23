#include "libbake/eval/scale_detail.h"

#include <algorithm>

#include "libbake/color/luv.h"

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

Image<V3f> strong_base(const StackScale& scale) {
  Image<V3f> base(scale.input.base.width(), scale.input.base.height());
  for (int y = 0; y < base.height(); ++y)
    for (int x = 0; x < base.width(); ++x) base(x, y) = scale.input.base(x, y) * scale.strength;
  return base;
}

Image<V3f> detail_of(const StackScale& scale) {
  Image<V3f> detail = strong_base(scale);
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

namespace {

Imath::V3d mean_of(const ImageView<const V3f>& base) {
  Imath::V3d mean(0);
  for (int y = 0; y < base.height(); ++y) {
    Imath::V3d row(0);
    for (int x = 0; x < base.width(); ++x) row += Imath::V3d(base(x, y));
    mean += row / (double{1} * base.width() * base.height());
  }
  return mean;
}

}  // namespace

void set_strengths(std::vector<StackScale>& scales) {
  constexpr double kMost = 16;  // as of gains
  for (StackScale& scale : scales) {
    scale.strength = V3f(1);
    if (!scale.transfer || scale.transfer->detail == DetailStrength::absolute) continue;
    const Imath::V3d coarse = mean_of(scales.front().input.base), own = mean_of(scale.input.base);
    for (int c = 0; c < 3; ++c)
      scale.strength[c] = static_cast<float>(coarse[c] < kMost * own[c] ? std::max(coarse[c], 0.0) / own[c] : kMost);
  }
}

}  // namespace texbake
