#include "libbake/planes/prepare_noise.h"

#include <fmt/format.h>

#include <bit>

#include "libbake/base/error.h"
#include "libbake/base/half.h"
#include "libbake/base/parallel.h"
#include "libbake/planes/noise_levels.h"
#include "libbake/planes/noise_mean.h"

namespace texbake {

using Imath::V3d;

namespace {

constexpr int kSteps = 2048;  // of a weight: 2^11, so that its product with a half float is exact in a float
constexpr size_t kMaxNoises = 4;

bool is_power_of_two(int n) { return n > 0 && std::has_single_bit(static_cast<uint32_t>(n)); }

int log2_of(int n) { return std::countr_zero(static_cast<uint32_t>(n)); }

void check_input(const NoiseInput& input, V2i size) {
  const size_t count = input.masks.size();
  if (count < 1 || count > kMaxNoises || input.tiles.size() != count)
    throw Error(ErrorKind::bad_data,
                fmt::format("noise: expected 1 to {} masks and the same number of tiles, found {} and {}", kMaxNoises,
                            count, input.tiles.size()));
  for (const auto& mask : input.masks)
    if (mask.width() != size.x || mask.height() != size.y)
      throw Error(ErrorKind::bad_data, fmt::format("masks: expected {} x {} texels, as in the base, found {} x {}",
                                                   size.x, size.y, mask.width(), mask.height()));
  for (const auto& tile : input.tiles)
    if (!same_size(tile, input.tiles.front()) || !is_power_of_two(tile.width()) || !is_power_of_two(tile.height()))
      throw Error(
          ErrorKind::bad_data,
          fmt::format("noise tiles: expected the same size for all, with sides that are powers of two, found {} x {}",
                      tile.width(), tile.height()));
  if (input.row_step < 1 || input.row_step % 2 == 0)
    throw Error(ErrorKind::bad_data,
                fmt::format("noise tiles: expected an odd step between rows, found {}", input.row_step));
}

Image<glsl::MaskTexel> mask_plane(const NoiseInput& input, V2i size) {
  Image<glsl::MaskTexel> plane(size.x, size.y);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      int sum = 0;
      glsl::MaskTexel texel{{0, 0, 0, 0}};
      for (size_t k = 0; k < input.masks.size(); ++k) {
        const float steps = input.masks[k](x, y) * kSteps;
        const int whole = steps >= 0 && steps <= kSteps ? static_cast<int>(steps) : -1;
        if (static_cast<float>(whole) != steps)
          throw Error(ErrorKind::bad_data, fmt::format("masks: texel ({}, {}): expected multiples of 1/{}, found {}", x,
                                                       y, kSteps, input.masks[k](x, y)));
        texel.weights[k] = static_cast<uint16_t>(whole);
        sum += whole;
      }
      if (sum != kSteps)
        throw Error(ErrorKind::bad_data, fmt::format("masks: texel ({}, {}): expected weights whose sum is 1, found {}",
                                                     x, y, static_cast<double>(sum) / kSteps));
      plane(x, y) = texel;
    }
  return plane;
}

/// The noises, one below the other, with room for their levels: one column, and where they are added to the square
/// root of light, another one for their squares'.
Image<glsl::vec4> stacked(const NoiseInput& input) {
  const V2i size(input.tiles.front().width(), input.tiles.front().height());
  const int columns = input.space == NoiseSpace::root ? 3 : 2;
  Image<glsl::vec4> stack(columns * size.x, size.y * static_cast<int>(input.tiles.size()), {0, 0, 0, 0});
  for (size_t k = 0; k < input.tiles.size(); ++k) {
    const int first_row = static_cast<int>(k) * size.y;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const V3f color = half_exact(input.tiles[k](x, y));
        stack(x, first_row + y) = {color.x, color.y, color.z, 0};
      }
  }
  return stack;
}

/// What a block of a level has for √s is √(s + c), s the structure's mean there and c what noise adds to it on the
/// average: √s / √(s + c), over all texels by their weight of noise k.
V3d root_share(const TilePlanes& planes, size_t k) {
  V3d structure(0);
  V3d whole(0);
  Imath::V4f alone(0);
  alone[static_cast<int>(k)] = 1;
  for (size_t i = 0; i < planes.masks.size(); ++i) {
    const double weight = planes.masks.data()[i].weights[k];
    if (weight == 0) continue;
    const glsl::vec4& v = planes.base.texels.data()[i];
    const V3f light(v.x, v.y, v.z);
    structure += roots(V3d(light)) * weight;
    whole += roots(V3d(light) + planes.noise_mean.change(light, alone)) * weight;
  }
  const auto ratio = [](double part, double all) { return all > 0 ? part / all : 1.0; };
  return {ratio(structure.x, whole.x), ratio(structure.y, whole.y), ratio(structure.z, whole.z)};
}

/// Where the grain is apart, a block of a root adds Σ w_k n_k², the squares' levels: right where each texel has one
/// noise. Where masks blend, (Σ w_k n_k)² is less. By how much on the average over the tile: the means of the two.
V3d square_share(const TilePlanes& planes, const NoiseMean& mean) {
  V3d blended(0);
  V3d apart(0);
  for (const glsl::MaskTexel& texel : planes.masks) {
    Imath::V4f weights(0);
    for (int k = 0; k < static_cast<int>(kMaxNoises); ++k) {
      if (texel.weights[k] == 0) continue;
      Imath::V4f alone(0);
      alone[k] = 1;
      weights[k] = static_cast<float>(texel.weights[k]) / kSteps;
      apart += mean.change(V3f(0), alone) * double{weights[k]};
    }
    blended += mean.change(V3f(0), weights);
  }
  const auto ratio = [](double part, double all) { return all > 0 ? part / all : 1.0; };
  return {ratio(blended.x, apart.x), ratio(blended.y, apart.y), ratio(blended.z, apart.z)};
}

void fill_levels(int count, const NoiseMean& mean, TilePlanes& planes) {
  const V2i size(1 << planes.noise_log2.x, 1 << planes.noise_log2.y);
  const V3d squares = planes.grain_apart && planes.noise_root != 0 ? square_share(planes, mean) : V3d(1);
  parallel_for(0, count, [&](int k) {
    const bool in_root = planes.noise_root != 0;
    const V3d share = in_root ? root_share(planes, static_cast<size_t>(k)) : V3d(1);
    const int row = k * size.y;
    const NoiseLevels of{size, planes.noise_step, planes.grain_apart};
    fill_noise_levels(planes.noise_tiles, of, {size.x, row}, [&](const V3d& v) { return v * share; });
    if (in_root)
      fill_noise_levels(planes.noise_tiles, of, {2 * size.x, row}, [&](const V3d& v) { return v * v * squares; });
  });
}

}  // namespace

void add_noise(const std::optional<NoiseInput>& input, TilePlanes& planes) {
  if (!input) {
    planes.masks = Image<glsl::MaskTexel>(1, 1);
    planes.noise_tiles = Image<glsl::vec4>(1, 1, {0, 0, 0, 0});
    return;
  }
  check_input(*input, planes.size);
  planes.base.kind = MapKind::structure;
  planes.noise_log2 = {log2_of(input->tiles.front().width()), log2_of(input->tiles.front().height())};
  planes.noise_step = input->row_step;
  planes.noise_root = input->space == NoiseSpace::root ? 1 : 0;
  const NoiseMean mean(input->tiles, input->space);
  if (!planes.grain_apart) planes.noise_mean = mean;
  planes.masks = mask_plane(*input, planes.size);
  planes.noise_tiles = stacked(*input);
  fill_levels(static_cast<int>(input->tiles.size()), mean, planes);
}

}  // namespace texbake
