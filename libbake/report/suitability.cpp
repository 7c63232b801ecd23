#include "libbake/report/suitability.h"

#include <fmt/format.h>

namespace texbake {
namespace {

/// Above it, texels a period apart are nearly the same: any other translation is seen.
constexpr double kNearRegular = 0.5;

}  // namespace

Suitability suitability(const std::optional<ContrastReport>& contrast, const std::optional<Lattice>& lattice) {
  if (lattice && lattice->correlation >= kNearRegular)
    return {fmt::format("the texture is near-regular: {:.0f} % of its variation returns after ({}, {}) texels, so that "
                        "what is moved by anything else breaks the pattern, and what keeps the pattern repeats it",
                        100 * lattice->correlation, lattice->translations.front().x, lattice->translations.front().y),
            "select-contents --lattice auto keeps the pattern whole and varies what lies on it; tile it plainly where "
            "the pattern itself is all there is"};
  const auto low = contrast ? low_contrast(*contrast) : std::nullopt;
  if (low == LowContrast::faint_borders)
    return {fmt::format("its contrast is low: colours differ by only {:.1f} ΔE across the borders of fragments, too "
                        "little to hide seams",
                        contrast->border_delta_e),
            "decompose it into structure and noise (texbake decompose), or take hex tiling: without features there is "
            "nothing that blending could spoil"};
  if (low == LowContrast::size_limited)
    return {
        fmt::format("its contrast is low: {:.0f} % of the tile is in fragments that ended at the greatest area, not "
                    "at a feature's border",
                    100 * contrast->size_limited_share),
        "a smaller fragment --threshold, an exemplar with clearer features, or texbake decompose"};
  if (lattice)
    return {fmt::format("the texture has a lattice: {:.0f} % of its variation returns after ({}, {}) texels; contents "
                        "moved by anything else put joints beside joints",
                        100 * lattice->correlation, lattice->translations.front().x, lattice->translations.front().y),
            "select-contents --lattice auto moves contents along the lattice alone"};
  return {};
}

}  // namespace texbake
