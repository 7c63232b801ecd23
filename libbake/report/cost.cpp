#include "libbake/report/cost.h"

namespace texbake {
namespace {

constexpr double kWideBytes = 8;    // RGBA16F
constexpr double kNarrowBytes = 2;  // R16F
constexpr double kPatchBytes = 4;   // RG16UI
constexpr double kTableBytes = 16;  // RGBA32I
constexpr double kMebi = 1048576;
constexpr double kWangTiles = 16;

double map_bytes(const Plane& plane, double texels) {
  return texels * (plane.channels == 1 ? kNarrowBytes : kWideBytes);
}

}  // namespace

void add_cost(const EvaluatorPlanes& planes, std::array<MeasureRow, kMethodCount>& methods) {
  const double texels = static_cast<double>(planes.size.x) * planes.size.y;
  double bytes = texels * kWideBytes;
  for (const Plane& map : planes.maps) bytes += map_bytes(map, texels);
  const auto pictures = 1.0 + static_cast<double>(planes.maps.size());
  const double tables = (static_cast<double>(planes.content_count) + 1.0) * planes.patch_count * kTableBytes;

  const auto set = [&](Method method, double fetches, double gpu_bytes) {
    MeasureRow& row = methods[static_cast<size_t>(method)];
    row[Measure::fetches] = Measured::of(fetches);
    row[Measure::gpu_bytes] = Measured::of(gpu_bytes / kMebi);
  };
  // The masks are one texture, each noise one more fetch.
  const double noise_texels = static_cast<double>(planes.noise_tiles.size());
  const double noises = planes.noise_size > 0 ? double{1} * planes.noise_tiles.height() / planes.noise_size : 0;
  const double layers = noises > 0 ? 1 + noises : 0;
  const double layer_bytes = noises > 0 ? (texels + noise_texels) * kWideBytes : 0;
  set(Method::bundle, pictures + 1 + layers, bytes + texels * kPatchBytes + tables + layer_bytes);
  set(Method::periodic, pictures, bytes);
  set(Method::wang, pictures + 1, kWangTiles * bytes);
  set(Method::hex, 3 * pictures, bytes);
}

}  // namespace texbake
