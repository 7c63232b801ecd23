// The whole chain, from a photograph to a bundle.
#pragma once

#include "bake/bake_request.h"
#include "bake/listener.h"

namespace texbake {

/// What "texbake bake" makes of `request`, to the byte once it is written. Throws Error as check_request, read_material
/// and the stages do.
Bundle bake(const BakeRequest& request, Listener& listener);

}  // namespace texbake
