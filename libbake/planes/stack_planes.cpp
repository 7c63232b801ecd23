#include "libbake/planes/stack_planes.h"

#include <algorithm>

#include "libbake/planes/program_of.h"

namespace texbake {

int64_t StackPlanes::texels_in(int scale) const {
  int64_t texels = 1;
  for (int s = scale + 1; s < scale_count(); ++s) texels *= transfers[static_cast<size_t>(s)].ratio;
  return texels;
}

void set_detail_mean(StackPlanes& planes, int scale, DetailMean mean) {
  planes.transfers[static_cast<size_t>(scale)].detail_mean = mean;
  int& bits = planes.scale_entry(1, scale).w;
  bits = mean == DetailMean::local ? bits | glsl::kLocalMean : bits & ~glsl::kLocalMean;
}

Nesting nesting_at(const StackPlanes& planes, glsl::uvec2 reference) {
  const auto floor_div = [](int64_t a, int64_t b) { return a / b - (a % b < 0 ? 1 : 0); };
  Nesting nesting;
  glsl::uvec2 tile = reference;
  for (int s = planes.finest(); s > 0; --s) {
    const auto at = static_cast<size_t>(s);
    const V2i size = planes.sizes[at], coarse = planes.sizes[at - 1] * planes.transfers[at].ratio;
    // Repetitions count from −2^31: the texture is continuous around 0, and wraps far away.
    const int64_t x = int64_t{static_cast<int32_t>(tile.x)} * size.x,
                  y = int64_t{static_cast<int32_t>(tile.y)} * size.y;
    const int64_t kx = floor_div(x, coarse.x), ky = floor_div(y, coarse.y);
    const glsl::uvec2 outer(static_cast<uint32_t>(kx), static_cast<uint32_t>(ky));
    nesting.tiles[at] = {tile.x, tile.y, outer.x, outer.y};
    nesting.offsets[at] = {static_cast<int>(x - kx * coarse.x), static_cast<int>(y - ky * coarse.y)};
    tile = outer;
  }
  return nesting;
}

glsl::Program program_of(const StackPlanes& planes, uint32_t seed, glsl::uvec2 reference) {
  glsl::Program program;
  for_each_texture(planes, sampler_binder(program));
  program.centers = program.level_table = program.scale_table;  // small tables share a texture
  bind_uniforms<glsl::NoiseUniforms>(planes, program);
  program.finest_noise_step = planes.noise_step;
  program.scale_count = planes.scale_count();
  program.stack_seed = seed;
  const Nesting nesting = nesting_at(planes, reference);
  std::copy(nesting.tiles.begin(), nesting.tiles.end(), program.nesting);
  std::copy(nesting.offsets.begin(), nesting.offsets.end(), program.nesting_offset);
  program.use_scale(planes.finest());
  return program;
}

}  // namespace texbake
