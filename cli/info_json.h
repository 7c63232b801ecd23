// What a bundle holds, field by field, with shapes and units.
#pragma once

#include <string>

#include "formats/bundle.h"

namespace texbake {

/// {semantics, scales: [{name, width, height, fields: [{name, shape, unit, what}], palette}], sources, stages}
Json info_json(const Bundle& bundle);

/// The same for people.
std::string info_text(const Json& info, const std::string& path);

}  // namespace texbake
