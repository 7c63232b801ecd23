#include "libbake/segment/fragment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libbake/base/error.h"
#include "libbake/base/half.h"
#include "libbake/segment/clean.h"
#include "libbake/segment/denoised_colors.h"
#include "libbake/segment/grow.h"

namespace texbake {
namespace {

// Chosen on fourteen photographs of 512² and 1024², looking at the fragments over the picture: leaves, pebbles and
// bricks come out whole, and there are 640 to 1450 fragments, fewer on smooth concrete (520) and on sand (370).
constexpr double kThresholdPerMedian = 0.9;  // of |v|; more merges features, less breaks them up
constexpr float kLeastThreshold = 1.0f;      // ΔE; below it nobody sees a border
// Dissolving small fragments takes borders off the edges of the picture. A quarter of 1/2560 brought the own AUC of
// hard borders from 0.73 to 0.64 on leaves, 0.78 to 0.75 on a cliff, 0.73 to 0.66 on gravel; a quarter of that gains
// nothing.
constexpr double kMinAreaShare = 1.0 / 10240;
constexpr double kMaxAreaShare = 1.0 / 160;
constexpr double kDenoisePerSide = 1.5 / 1024;
constexpr float kLeastDenoise = 0.3f;  // px; a narrower Gaussian does not reach the next texel

/// Half of what a shape may have: four fragments that meet at a corner of the tile fit into one patch.
V2i fragment_extent(V2i size) { return {std::max(1, max_extent(size.x) / 2), std::max(1, max_extent(size.y) / 2)}; }

float automatic_denoise(double area) {
  const auto denoise = static_cast<float>(kDenoisePerSide * std::sqrt(area));
  return denoise < kLeastDenoise ? 0.0f : denoise;
}

float automatic_threshold(const Image<float>& variation) {
  return std::max(kLeastThreshold, static_cast<float>(kThresholdPerMedian * median_variation(variation)));
}

int share_of(double area, double share, int least) {
  return std::max(least, static_cast<int>(std::floor(area * share + 0.5)));
}

/// All but the threshold, which needs the colors without grain.
FragmentOptions resolve_sizes(FragmentOptions options, const PrincipalVariation& colors) {
  check_options(options);
  const auto area = static_cast<double>(colors.index.size());
  if (!options.denoise_px) options.denoise_px = automatic_denoise(area);
  if (!options.min_area_px) {
    options.min_area_px = share_of(area, kMinAreaShare, 4);
    if (options.max_area_px) options.min_area_px = std::min(*options.min_area_px, *options.max_area_px);
  }
  if (!options.max_area_px) options.max_area_px = std::max(share_of(area, kMaxAreaShare, 16), *options.min_area_px);
  if (*options.min_area_px > *options.max_area_px)
    throw Error(ErrorKind::usage,
                fmt::format("--min-area: expected at most {} px, the value of --max-area, found {} px",
                            *options.max_area_px, *options.min_area_px));
  return options;
}

void resolve_threshold(FragmentOptions& options, const DenoisedColors& denoised) {
  if (!options.threshold) options.threshold = automatic_threshold(denoised.variation);
}

/// Mean of the base over each fragment, summed in row order.
void average(ImageView<const V3f> base, FragmentMap& map) {
  std::vector<double> sums(map.fragments.size() * 3, 0.0);
  for (size_t at = 0; at < base.size(); ++at)
    for (size_t c = 0; c < 3; ++c)
      sums[map.partition.idx.data()[at] * size_t{3} + c] += static_cast<double>(base.data()[at][static_cast<int>(c)]);
  for (size_t f = 0; f < map.fragments.size(); ++f)
    for (size_t c = 0; c < 3; ++c)
      map.fragments[f].mean_color[static_cast<int>(c)] =
          half_exact(static_cast<float>(sums[f * 3 + c] / map.partition.areas_px[f]));
}

}  // namespace

FragmentOptions resolve(const FragmentOptions& options, const PrincipalVariation& colors) {
  FragmentOptions resolved = resolve_sizes(options, colors);
  if (!resolved.threshold) resolve_threshold(resolved, denoised_colors(colors, *resolved.denoise_px));
  return resolved;
}

FragmentMap fragment(const PrincipalVariation& colors, ImageView<const V3f> base, const FragmentOptions& options,
                     const Progress& progress) {
  assert(same_size(colors.index, base) && same_size(colors.index, colors.variation));
  const V2i size(base.width(), base.height());
  if (size.x < 3 || size.y < 3)
    throw Error(
        ErrorKind::infeasible,
        fmt::format(
            "expected a tile of at least 3 x 3 texels, found {} x {}: no fragment would be smaller than half of it",
            size.x, size.y));

  FragmentOptions resolved = resolve_sizes(options, colors);
  const DenoisedColors denoised = denoised_colors(colors, *resolved.denoise_px);
  resolve_threshold(resolved, denoised);
  report_progress(progress, 0.2);

  const V2i extent = fragment_extent(size);
  Growth growth =
      grow(denoised.index, denoised.variation, {*resolved.threshold, *resolved.max_area_px, extent, resolved.seed});
  report_progress(progress, 0.5);
  growth = clean(std::move(growth), denoised.luv, {*resolved.min_area_px, *resolved.max_area_px, extent});
  report_progress(progress, 0.9);

  FragmentMap map;
  for (const size_t seed : growth.seeds) map.fragments.push_back({denoised.index.data()[seed], V3f(0)});
  map.partition = unwrap(std::move(growth.idx));
  average(base, map);
  report_progress(progress, 1.0);
  return map;
}

}  // namespace texbake
