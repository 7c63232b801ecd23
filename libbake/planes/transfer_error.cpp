#include "libbake/planes/transfer_error.h"

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

/// Of one coarse texel.
struct Violation {
  V3d mean{0};  ///< of the fine texels inside it, less its color
  int below_black = 0;
};

Violation violation(glsl::Program& program, const StackPlanes& planes, int scale, V2i q) {
  constexpr double kBlack = -1.0 / 255;
  const int ratio = planes.transfers[static_cast<size_t>(scale)].ratio;
  Violation found;
  for (int j = 0; j < ratio; ++j)
    for (int i = 0; i < ratio; ++i) {
      const glsl::Texel fine = texel_at(q.x * ratio + i, q.y * ratio + j, planes.sizes[static_cast<size_t>(scale)]);
      const V3d color = color_of(program.scale_texel(scale, fine, 1));
      found.mean += color;
      found.below_black += std::min({color.x, color.y, color.z}) < kBlack;
    }
  const glsl::Texel coarse = texel_at(q.x, q.y, planes.sizes[static_cast<size_t>(scale) - 1]);
  found.mean = found.mean / (static_cast<double>(ratio) * ratio) - color_of(program.scale_texel(scale - 1, coarse, 1));
  return found;
}

}  // namespace

TransferError transfer_error(const StackPlanes& planes, int scale, int side) {
  const glsl::Program bound = program_of(planes, 0, {0, 0});
  Image<Violation> violations(side, side);
  parallel_for(0, side, [&](int y) {
    glsl::Program program = bound;
    for (int x = 0; x < side; ++x) violations(x, y) = violation(program, planes, scale, {x, y});
  });
  TransferError error;
  double squares = 0;
  int64_t below_black = 0;
  for (const Violation& v : violations) {
    below_black += v.below_black;
    for (int c = 0; c < 3; ++c) {
      squares += v.mean[c] * v.mean[c];
      error.worst = std::max(error.worst, std::abs(v.mean[c]));
    }
  }
  error.coarse_texels = side * side;
  const double ratio = planes.transfers[static_cast<size_t>(scale)].ratio;
  error.below_black = static_cast<double>(below_black) / (ratio * ratio * error.coarse_texels);
  error.rms = std::sqrt(squares / (3.0 * error.coarse_texels));
  return error;
}

}  // namespace texbake
