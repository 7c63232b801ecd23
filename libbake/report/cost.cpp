#include "libbake/report/cost.h"

namespace texbake {
namespace {

constexpr double kWideBytes = 8;    // RGBA16F
constexpr double kNarrowBytes = 2;  // R16F
constexpr double kPatchBytes = 4;   // RG16UI
constexpr double kTableBytes = 16;  // RGBA32I
constexpr double kBlockBytes = 8;   // RG32UI
constexpr double kEntryBytes = 4;   // RG16UI
constexpr double kMebi = 1048576;
constexpr double kWangTiles = 16;

double map_bytes(const Plane& plane, double texels) {
  return texels * (plane.channels == 1 ? kNarrowBytes : kWideBytes);
}

// What soft borders add to a texel on average, and their textures.
struct SoftCost {
  double fetches = 0;
  double bytes = 0;
};

// A texel reads its block in place of its patch; where it is shared, a value of each share and, but for the first, an
// entry in place of one texel of each picture.
SoftCost soft_cost(const EvaluatorPlanes& planes, double pictures) {
  if (planes.first_level > 0) return {};
  double shares = 0, shared = 0;
  for (int y = 0; y < planes.size.y; ++y)
    for (int x = 0; x < planes.size.x; ++x) {
      const uint32_t more = planes.level_blocks(x, y).owned >> 20;
      shared += more > 0 ? 1 : 0;
      shares += more > 0 ? more + 1.0 : 0.0;
    }
  const double texels = static_cast<double>(planes.size.x) * planes.size.y;
  return {((shares - shared) * (pictures + 1)) / texels,
          texels * kBlockBytes + shares * (kEntryBytes + planes.content_count * kWideBytes * pictures)};
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
  const double noises = planes.noise_step != 0 ? planes.noise_tiles.height() >> planes.noise_log2.y : 0;
  const double layers = noises > 0 ? 1 + noises : 0;
  const double layer_bytes = noises > 0 ? (texels + noise_texels) * kWideBytes : 0;
  const SoftCost soft = soft_cost(planes, pictures);
  set(Method::bundle, pictures + 1 + layers + soft.fetches,
      bytes + texels * kPatchBytes + tables + layer_bytes + soft.bytes);
  set(Method::periodic, pictures, bytes);
  set(Method::wang, pictures + 1, kWangTiles * bytes);
  set(Method::hex, 3 * pictures, bytes);
}

}  // namespace texbake
