#include "libbake/report/suitability.h"

#include <fmt/format.h>

namespace texbake {
namespace {

/// Above it, texels a period apart are nearly the same: any other translation is seen.
constexpr double kNearRegular = 0.5;

}  // namespace

Suitability suitability(const std::optional<ContrastReport>& contrast,
                        const std::optional<TranslationLattice>& lattice) {
  if (lattice && lattice->correlation >= kNearRegular)
    return {fmt::format("the texture is near-regular: {:.0f} % of its variation recurs after ({}, {}) texels, so that "
                        "any other translation breaks the pattern, and translations that keep the pattern repeat it",
                        100 * lattice->correlation, lattice->translations.front().x, lattice->translations.front().y),
            "select-contents --lattice auto, which keeps the pattern whole and varies what lies on it; or plain "
            "tiling, if the pattern itself is all there is"};
  const auto low = contrast ? low_contrast(*contrast) : std::nullopt;
  if (low == LowContrast::faint_borders)
    return {
        fmt::format(
            "its contrast is low: colors differ by only {:.1f} ΔE across fragment borders, too little to hide seams",
            contrast->border_delta_e),
        "separating structure and noise (texbake decompose), or hex tiling: without features there is nothing that "
        "blending could spoil"};
  if (low == LowContrast::size_limited)
    return {fmt::format("its contrast is low: {:.0f} % of the tile is in fragments that ended at the maximum area, not "
                        "at the border of a feature",
                        100 * contrast->size_limited_share),
            "a smaller fragment --threshold, an exemplar with clearer features, or texbake decompose"};
  if (lattice)
    return {fmt::format("the texture has a lattice: {:.0f} % of its variation recurs after ({}, {}) texels; contents "
                        "that move by anything else put joints beside joints",
                        100 * lattice->correlation, lattice->translations.front().x, lattice->translations.front().y),
            "select-contents --lattice auto, which moves contents only along the lattice"};
  return {};
}

}  // namespace texbake
