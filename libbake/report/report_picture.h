// The pictures of a report, each with what it shows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"
#include "libbake/planes/prepare.h"
#include "libbake/report/rendering.h"

namespace texbake {

/// What a picture is for; the page groups by it, in this order.
enum class PictureGroup { overview, near, far, parts, seams, layers };

struct ReportPicture {
  PictureGroup group = PictureGroup::overview;
  std::string caption;      ///< one line
  Image<V3f> linear;        ///< linear Rec.709
  bool is_drawing = false;  ///< flat colors, stored without loss
};

/// The tile, a large window of the infinite texture, fragments, patches, contents, the contents of one patch; with
/// noise also structure, noise, masks and spectra (magnitudes; the square root of each over its largest, DC in the
/// middle). `exemplar` is empty where the base is the exemplar.
std::vector<ReportPicture> bundle_pictures(const EvaluatorInput& tile, const EvaluatorPlanes& planes,
                                           ImageView<const V3f> exemplar,
                                           const std::vector<ImageView<const float>>& spectra);

/// One rendering at the same place for every method: a window at 1 : 1 where four tiles meet, and all of it from afar.
std::vector<ReportPicture> rendering_pictures(std::string_view name, ImageView<const V3f> rendering_luv, V2i tile);

/// Seams over the grayed texture: blue where they hide, red where they step more than was usual there before.
ReportPicture seam_picture(ImageView<const V3f> tile_luv, const RenderingSources& sources);

/// How much of the variation around each texel of the tile returns with every tile: black 0, white 1.
ReportPicture repetition_picture(ImageView<const V3f> rendering_luv, V2i tile);

}  // namespace texbake
