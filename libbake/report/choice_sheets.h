// What an artist tunes by eye, side by side: the number of classes, the fragments' contrast and sizes, seeds and the
// number of contents. Tiles are shown, and tried, at reduced size.
// Based on: Guingo et al. 2017, Fig. 14.
#pragma once

#include "libbake/base/progress.h"
#include "libbake/color/convert.h"
#include "libbake/content/select_contents.h"
#include "libbake/report/sheet.h"
#include "libbake/segment/fragment.h"

namespace texbake {

/// For K = 2, 3, 4, 6, 8, 12 (those that the tile has colors for): the dominant colors and the compact form, with
/// the color error. Above: the exemplar, and K chosen automatically.
Sheet convert_sheet(ImageView<const V3f> exemplar, const ConvertOptions& options, const Progress& progress = {});

/// Three contrasts (half, once, twice the threshold) by three sizes (half, once, twice both areas) around `options`,
/// each fragment in its mean color, borders dark.
Sheet fragment_sheet(const PrincipalVariation& colors, ImageView<const V3f> base, const FragmentOptions& options,
                     const Progress& progress = {});

/// Three numbers of contents around `options.count` by three seeds of the choice: 4 × 4 tiles from afar, with the
/// repetition that is predicted.
Sheet select_contents_sheet(const PrincipalVariation& colors, ImageView<const V3f> base, const PatchMap& patches,
                            const SelectContentsOptions& options, const Progress& progress = {});

}  // namespace texbake
