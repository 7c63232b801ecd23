// Levels of detail of the infinite texture, without bias: what each content of each patch shows, averaged over blocks
// of about 2^l × 2^l texels and premultiplied by the patch's cover of the block. A value of level l is the sum of one
// share for each patch that lies under the block, and equals the box mean of the infinite texture there. Based on: Lutz
// et al. 2019, Anisotropic Filtering for On-the-fly Patch-based Texturing. Layout: shaders/README.md §12.
#pragma once

#include "libbake/planes/evaluator_planes.h"
#include "libbake/planes/level_lists.h"

namespace texbake {

/// Adds the levels of `plane`, the base or a map of `planes`, and the lists of patches that all planes
/// share (level_lists.h). A share of a block is the mean, in double and rounded once to float, of those of the finer
/// blocks that it consists of; of a texel it is what the evaluator shows, so normals are turned and heights scaled.
/// With noise, shares of the base have the means of the noises too, and weights for what else the noises have in a
/// block (level_weights.h, noise_levels.h). Throws Error(infeasible) when there are 2^32 values or more.
void add_levels(EvaluatorPlanes& planes, const Plane& plane);

/// The same of the base and all maps.
void add_levels(EvaluatorPlanes& planes);

/// The two steps of it, for values that are kept elsewhere: the lists, which are added to `planes`; and the values of
/// one plane, in value_rows rows of kListWidth, and with noise those of the masks, which are added.
LevelLists add_lists(EvaluatorPlanes& planes);
int value_rows(const LevelLists& lists, const EvaluatorPlanes& planes);
void fill_levels(const LevelLists& lists, const Plane& plane, EvaluatorPlanes& planes, ImageView<glsl::vec4> values);

}  // namespace texbake
