#include "libbake/report/reduced_tile.h"

#include <algorithm>

#include "libbake/base/half.h"
#include "libbake/planes/noise_levels.h"
#include "libbake/quality/low_pass.h"

namespace texbake {
namespace {

// x / factor, rounded to the nearest, halves up.
int divided(int x, int factor) {
  const int shifted = 2 * x + factor;
  return shifted >= 0 ? shifted / (2 * factor) : -((-shifted + 2 * factor - 1) / (2 * factor));
}
V2i divided(V2i p, int factor) { return {divided(p.x, factor), divided(p.y, factor)}; }

template <class T>
Image<T> middle_texels(ImageView<const T> image, int factor) {
  Image<T> reduced(image.width() / factor, image.height() / factor);
  for (int y = 0; y < reduced.height(); ++y)
    for (int x = 0; x < reduced.width(); ++x) reduced(x, y) = image(x * factor + factor / 2, y * factor + factor / 2);
  return reduced;
}

PatchMap reduced_patches(const PatchMap& patches, int factor) {
  PatchMap reduced;
  reduced.partition.idx = middle_texels(patches.partition.idx.view(), factor);
  reduced.partition.owner = middle_texels(patches.partition.owner.view(), factor);
  const V2i size = reduced.partition.size();
  for (const V2i& center : patches.partition.centers) reduced.partition.centers.push_back(wrap(center / factor, size));
  for (const uint32_t area : patches.partition.areas_px)
    reduced.partition.areas_px.push_back(area / static_cast<uint32_t>(factor * factor));
  return reduced;
}

ContentTable reduced_contents(const ContentTable& contents, int factor, V2i size) {
  ContentTable reduced = contents;
  for (Content& content : reduced.contents) content.translation = shortest(divided(content.translation, factor), size);
  return reduced;
}

/// The box means over factor × factor texels, a power of two, which are a noise of fewer values.
Image<V3f> reduced_noise(ImageView<const V3f> tile, int row_step, int factor) {
  Image<Imath::V3d> values(tile.width(), tile.height());
  std::copy(tile.begin(), tile.end(), values.begin());
  for (int side = 1; side < factor && values.size() > 1; side *= 2) values = halved_noise(values, row_step);
  Image<V3f> reduced(values.width(), values.height());
  for (size_t i = 0; i < values.size(); ++i) reduced.data()[i] = half_exact(V3f(values.data()[i]));
  return reduced;
}

V3f mean_square(ImageView<const V3f> values) {
  Imath::V3d sum(0);
  for (const V3f& v : values) sum += Imath::V3d(v) * Imath::V3d(v);
  return V3f(sum / static_cast<double>(values.size()));
}

/// Of noise in the square root of light a mean over texels keeps the light of its squares, which belongs to the base
/// once the noise itself has less of it.
void add_lost_light(const NoiseInput& noise, ReducedTile& reduced) {
  for (size_t k = 0; k < noise.tiles.size(); ++k) {
    const V3f lost = mean_square(noise.tiles[k]) - mean_square(reduced.noise_tiles[k]);
    for (size_t i = 0; i < reduced.base.size(); ++i) reduced.base.data()[i] += lost * reduced.masks[k].data()[i];
  }
}

}  // namespace

EvaluatorInput ReducedTile::input() const {
  EvaluatorInput input;
  input.base = base;
  input.soft_border_px = soft_border_px;
  if (patches) input.patches = &*patches;
  if (contents) input.contents = &*contents;
  if (!masks.empty()) {
    input.noise.emplace();
    for (const Image<float>& mask : masks) input.noise->masks.push_back(mask);
    for (const Image<V3f>& tile : noise_tiles) input.noise->tiles.push_back(tile);
    input.noise->row_step = noise_step;
    input.noise->space = noise_space;
  }
  return input;
}

int reduction_to(V2i size, int largest_side) {
  const int side = std::max(size.x, size.y);
  for (int factor = (side + largest_side - 1) / largest_side; factor <= side / 8; ++factor)
    if (size.x % factor == 0 && size.y % factor == 0) return factor;
  return 1;
}

int reduction_to(const EvaluatorInput& input, int largest_side) {
  const V2i size(input.base.width(), input.base.height());
  if (!input.noise) return reduction_to(size, largest_side);
  int factor = 1;
  while (std::max(size.x, size.y) > factor * largest_side && size.x % (2 * factor) == 0 && size.y % (2 * factor) == 0)
    factor *= 2;
  return factor;
}

ReducedTile reduced_tile(const EvaluatorInput& input, int factor) {
  ReducedTile reduced;
  reduced.factor = factor;
  reduced.base = reduce(input.base, factor);
  if (input.patches) reduced.patches = reduced_patches(*input.patches, factor);
  const V2i size(reduced.base.width(), reduced.base.height());
  if (input.contents) reduced.contents = reduced_contents(*input.contents, factor, size);
  reduced.soft_border_px = std::min(divided(input.soft_border_px, factor), max_soft_border_px(size));
  if (!input.noise) return reduced;
  for (const auto& mask : input.noise->masks) reduced.masks.push_back(middle_texels(mask, factor));
  reduced.noise_step = input.noise->row_step;
  for (const auto& tile : input.noise->tiles)
    reduced.noise_tiles.push_back(reduced_noise(tile, reduced.noise_step, factor));
  reduced.noise_space = input.noise->space;
  if (reduced.noise_space == NoiseSpace::root) add_lost_light(*input.noise, reduced);
  return reduced;
}

}  // namespace texbake
