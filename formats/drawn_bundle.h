// Hands the parts of a bundle to the evaluator: where a bundle becomes what is drawn.
#pragma once

#include <string>

#include "formats/bundle.h"
#include "formats/image_reader.h"
#include "libbake/planes/drawn_material.h"

namespace texbake {

/// What is drawn of `bundle`: views into it, which must not outlive it.
DrawnMaterial drawn_material(const Bundle& bundle);

/// The finest scale by itself. Its height map, where there is one, is the map "height". A structure without spectra is
/// drawn alone.
EvaluatorInput evaluator_input(const Bundle& bundle);

/// All scales, coarse to fine. A stack has noise in its finest scale alone: the others show their exemplars.
std::vector<StackScale> stack_input(const Bundle& bundle);

/// What a picture of map `name` of the finest scale is; of the color where the name is "".
PictureRole picture_role(const Bundle& bundle, const std::string& name);

}  // namespace texbake
