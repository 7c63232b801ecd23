// Which bundles may be read at all. Based on: the version rules of glTF 2.0, §3.2.
#pragma once

#include "formats/issues.h"

namespace texbake {

enum class Semantics {
  known,  ///< refuse a number this build does not know
  any,    ///< for programs that only list what a bundle holds
};

/// Checks kind, versions, required extensions and semantics of the manifest `json`, whatever else it may be.
void check_asset(const Json& json, Semantics semantics, IssueLog& log);

}  // namespace texbake
