#include "libbake/draw/deform.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "libbake/base/error.h"
#include "libbake/base/portable_math.h"

namespace texbake {
namespace {

constexpr double kDegree = 0.017453292519943295;  // π / 180
constexpr int kOne = 65536;

void check(const char* option, const char* unit, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw Error(ErrorKind::usage, fmt::format("--{}: expected {} to {}{}, found {}", option, low, high, unit, value));
}

int32_t fixed(double value) { return static_cast<int32_t>(std::lround(value * kOne)); }

int64_t floor_div(int64_t a, int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

}  // namespace

bool Deformation::is_identity() const {
  return matrix[0] == kOne && matrix[1] == 0 && matrix[2] == 0 && matrix[3] == kOne && turbulence_256 == 0;
}

Deformation deformation_of(const DeformationRequest& request) {
  check("rotate", " degrees", request.rotate_degrees, -360, 360);
  check("stretch", " times", request.stretch_x, 0.5, 64);
  check("stretch", " times", request.stretch_y, 0.5, 64);
  check("turbulence", " texels", request.turbulence_texels, 0, 64);
  check("turbulence-cell", " texels", request.turbulence_cell, 64, 1024);
  const auto cell = static_cast<uint32_t>(request.turbulence_cell);
  if (!std::has_single_bit(cell))
    throw Error(ErrorKind::usage,
                fmt::format("--turbulence-cell: expected a power of two, found {}", request.turbulence_cell));
  const double c = portable_cos(request.rotate_degrees * kDegree), s = portable_sin(request.rotate_degrees * kDegree);
  Deformation deformation;
  deformation.matrix[0] = fixed(c / request.stretch_x);
  deformation.matrix[1] = fixed(s / request.stretch_x);
  deformation.matrix[2] = fixed(-s / request.stretch_y);
  deformation.matrix[3] = fixed(c / request.stretch_y);
  deformation.turbulence_256 = static_cast<int>(std::lround(request.turbulence_texels * 256));
  deformation.turbulence_cell_log2 = std::countr_zero(cell);
  return deformation;
}

DeformedFootprint footprint_of(const Deformation& deformation, double texels, int most_halvings, int level_count) {
  const double size = std::max(1.0, texels) / kOne;
  const double xx = deformation.matrix[0] * size, xy = deformation.matrix[1] * size;
  const double yx = deformation.matrix[2] * size, yy = deformation.matrix[3] * size;
  // Eigenvectors of J Jᵀ.
  const double across = xx * xx + xy * xy, along = yx * yx + yy * yy, both = xx * yx + xy * yy;
  const double half_difference = (across - along) / 2;
  const double root = std::sqrt(half_difference * half_difference + both * both);
  const double major = std::sqrt((across + along) / 2 + root);
  const double minor = major > 0 ? std::abs(xx * yy - xy * yx) / major : 0;
  const double width = std::max(minor, major / (1 << most_halvings));

  DeformedFootprint footprint;
  if (width > 1) {
    const double level = portable_log(width) / portable_log(2);
    footprint.level_256 = std::min(static_cast<int>(std::lround(256 * level)), 256 * (level_count + 1));
  }
  constexpr double kEnough = 0.999;  // of the axis
  for (double seen = std::max(1.0, width); footprint.halvings < most_halvings && seen < major * kEnough; seen *= 2)
    ++footprint.halvings;
  if (footprint.halvings == 0) return footprint;
  const double x = across < along ? both : half_difference + root;
  const double y = across < along ? root - half_difference : both;
  const double scale = 256 * major / std::sqrt(x * x + y * y);
  footprint.axis_256[0] = static_cast<int>(std::lround(x * scale));
  footprint.axis_256[1] = static_cast<int>(std::lround(y * scale));
  return footprint;
}

DeformationAnchor anchor_of(const Deformation& deformation, V2i tile_size, const uint32_t (&tile)[2], V2i texel) {
  int64_t at[2];
  for (int axis = 0; axis < 2; ++axis)
    at[axis] = int64_t{static_cast<int32_t>(tile[axis])} * tile_size[axis] + texel[axis];
  DeformationAnchor anchor;
  for (int axis = 0; axis < 2; ++axis) {
    const int64_t to_x = deformation.matrix[2 * axis], to_y = deformation.matrix[2 * axis + 1];
    // The center is half a texel further: half the matrix, rounded down. |sum| < 2^63 for tiles up to 2^14 texels.
    const int64_t place_65536 = to_x * at[0] + to_y * at[1] + ((to_x + to_y) >> 1);
    const int64_t whole = place_65536 >> 16;
    const int64_t repetition = floor_div(whole, tile_size[axis]);
    anchor.tile[axis] = static_cast<uint32_t>(static_cast<uint64_t>(repetition));
    anchor.texel[axis] = static_cast<int>(whole - repetition * tile_size[axis]);
    anchor.fraction_65536[axis] = static_cast<int>(place_65536 & 65535);
  }
  return anchor;
}

}  // namespace texbake
