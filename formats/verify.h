// Is a bundle whole and consistent? Everything that can be told from the bundle alone.
#pragma once

#include <filesystem>
#include <vector>

#include "formats/issues.h"

namespace texbake {

/// All issues of the bundle at `path`, in the order manifest, payloads, tables, history. A bad bundle is never an
/// exception: it is a list. An empty list is a perfect bundle.
std::vector<Issue> verify_bundle(const std::filesystem::path& path);

}  // namespace texbake
