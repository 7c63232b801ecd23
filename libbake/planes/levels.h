// Levels of detail of the infinite texture, without bias: what each content of each patch shows, averaged over blocks
// of about 2^l × 2^l texels and premultiplied by the patch's cover of the block. A value of level l is the sum of one
// share for each patch that lies under the block, and equals the box mean of the infinite texture there. Based on: Lutz
// et al. 2019, Anisotropic Filtering for On-the-fly Patch-based Texturing. Layout: shaders/README.md §12.
#pragma once

#include "libbake/planes/evaluator_planes.h"
#include "libbake/planes/level_lists.h"

namespace texbake {

/// Fills the values of `plane`, a plane of `planes`, in value_rows rows of kListWidth. A share of a block is the mean,
/// in double and rounded once to float, of those of the finer blocks that it consists of; of a texel it is what the
/// evaluator shows, so normals are turned and heights scaled. With noise, shares of the base have the means of the
/// noises too; what else the noises have in a block are level_weights (level_weights.h, noise_levels.h).
void fill_levels(const LevelLists& lists, const Plane& plane, const TilePlanes& planes, ImageView<glsl::vec4> values);
int value_rows(const LevelLists& lists, const TilePlanes& planes);

/// The same in an image of its own.
Image<glsl::vec4> level_values(const LevelLists& lists, const Plane& plane, const TilePlanes& planes);

}  // namespace texbake
