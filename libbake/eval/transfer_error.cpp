#include "libbake/eval/transfer_error.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/parallel.h"

namespace texbake {
namespace {

using Imath::V3d;

V3d color_of(const glsl::vec4& value) { return {value.x, value.y, value.z}; }

glsl::Texel texel_at(int x, int y, V2i size) {
  return {{static_cast<uint32_t>(x / size.x), static_cast<uint32_t>(y / size.y)}, {x % size.x, y % size.y}};
}

/// The mean of the fine texels inside coarse texel (x, y), less its colour.
V3d violation(glsl::Program& program, const StackPlanes& planes, int scale, V2i q) {
  const int ratio = planes.transfers[static_cast<size_t>(scale)].ratio;
  V3d sum(0);
  for (int j = 0; j < ratio; ++j)
    for (int i = 0; i < ratio; ++i) {
      const glsl::Texel fine = texel_at(q.x * ratio + i, q.y * ratio + j, planes.sizes[static_cast<size_t>(scale)]);
      sum += color_of(program.scale_texel(scale, fine, 1));
    }
  const glsl::Texel coarse = texel_at(q.x, q.y, planes.sizes[static_cast<size_t>(scale) - 1]);
  return sum / (static_cast<double>(ratio) * ratio) - color_of(program.scale_texel(scale - 1, coarse, 1));
}

}  // namespace

TransferError transfer_error(const StackPlanes& planes, int scale, int side) {
  const glsl::Program bound = program_of(planes, 0, {0, 0});
  Image<V3d> violations(side, side);
  parallel_for(0, side, [&](int y) {
    glsl::Program program = bound;
    for (int x = 0; x < side; ++x) violations(x, y) = violation(program, planes, scale, {x, y});
  });
  TransferError error;
  double squares = 0;
  for (const V3d& v : violations)
    for (int c = 0; c < 3; ++c) {
      squares += v[c] * v[c];
      error.worst = std::max(error.worst, std::abs(v[c]));
    }
  error.coarse_texels = side * side;
  error.rms = std::sqrt(squares / (3.0 * error.coarse_texels));
  return error;
}

}  // namespace texbake
