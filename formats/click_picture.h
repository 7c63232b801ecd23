// Reads heights that were painted into a picture.
#pragma once

#include <string>

#include "formats/clicks.h"

namespace texbake {

/// The clicks and the size of a sparse picture, as read_clicks says; nothing else of `ClickFile` is set.
ClickFile read_click_picture(const std::string& path);

}  // namespace texbake
