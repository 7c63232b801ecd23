#include "libbake/draw/perspective_view.h"

#include <fmt/format.h>

#include "libbake/base/error.h"
#include "libbake/base/portable_math.h"

namespace texbake {
namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295;

/// A direction in the texture's axes and towards it, as its float.
glsl::vec3 direction(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

void check_range(const char* name, double value, double min, double max) {
  if (!(value >= min && value <= max))
    throw Error(ErrorKind::usage, fmt::format("--{}: expected {} to {}, found {}", name, min, max, value));
}

}  // namespace

void check_perspective(const Perspective& view, V2i tile_size) {
  if (view.width < 1 || view.height < 1 || view.width > 1 << 20 || view.height > 1 << 20)
    throw Error(ErrorKind::usage, fmt::format("view: expected 1 to {} pixels on each side, found {} x {}", 1 << 20,
                                              view.width, view.height));
  check_range("camera-height", view.height_texels, 0.001, 1e6);
  check_range("pitch", view.pitch_deg, -90, 90);
  check_range("yaw", view.yaw_deg, -360, 360);
  check_range("fov", view.fov_deg, 0.01, 170);
  const auto side_256 = [](int side) { return static_cast<uint32_t>(side) * 256u; };
  if (view.origin_x.offset_256 >= side_256(tile_size.x) || view.origin_y.offset_256 >= side_256(tile_size.y))
    throw Error(ErrorKind::usage, "view: expected an origin inside its tile");
}

PerspectiveRays rays_of(const Perspective& view) {
  const double pitch = view.pitch_deg * kRadiansPerDegree, yaw = view.yaw_deg * kRadiansPerDegree;
  const double half = view.fov_deg * 0.5 * kRadiansPerDegree;
  const double pixel = 2 * portable_sin(half) / portable_cos(half) / view.height;
  const double ahead[2] = {portable_sin(yaw), -portable_cos(yaw)};
  const double cos_pitch = portable_cos(pitch), sin_pitch = portable_sin(pitch);

  const double right[3] = {-ahead[1] * pixel, ahead[0] * pixel, 0};
  const double down[3] = {-sin_pitch * ahead[0] * pixel, -sin_pitch * ahead[1] * pixel, cos_pitch * pixel};
  const double forward[3] = {cos_pitch * ahead[0], cos_pitch * ahead[1], sin_pitch};
  const auto corner = [&](int i) { return forward[i] - right[i] * view.width * 0.5 - down[i] * view.height * 0.5; };
  return {direction(corner(0), corner(1), corner(2)), direction(right[0], right[1], right[2]),
          direction(down[0], down[1], down[2]), static_cast<float>(view.height_texels)};
}

}  // namespace texbake
