// Whether the fragments found borders to end at, or only their greatest size: the papers' failure on smooth pictures.
// Based on: Vanhoey et al. 2013, §8, "Limitations".
#pragma once

#include <optional>

#include "libbake/base/options.h"
#include "libbake/segment/fragment.h"

namespace texbake {

/// ΔE is Euclidean in CIELUV, between texels that share an edge.
struct ContrastReport {
  double border_delta_e = 0;    ///< mean across the borders of fragments: what will mask the seams
  double interior_delta_e = 0;  ///< mean inside the fragments
  double size_limited_share =
      0;  ///< share of the tile in fragments that have the greatest area: no contrast ended them
};

/// `base` is the picture that was fragmented, linear Rec.709; `max_area_px` the resolved option.
ContrastReport contrast_report(ImageView<const V3f> base, const FragmentMap& fragments, int max_area_px);

/// Why exchanged contents and transferred colors may show seams.
enum class LowContrast {
  faint_borders,  ///< the borders are so faint that they mask nothing
  size_limited,   ///< most fragments ended at the greatest area instead of at a border
};
template <>
struct EnumNames<LowContrast> {
  static constexpr std::pair<LowContrast, std::string_view> values[] = {{LowContrast::faint_borders, "faint-borders"},
                                                                        {LowContrast::size_limited, "size-limited"}};
};

/// Nothing where the contrast is sufficient. Faint borders come first where both hold.
std::optional<LowContrast> low_contrast(const ContrastReport& report);

}  // namespace texbake
