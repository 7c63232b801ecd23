// Bundles that targets begin with, and the hashes of a changed one put right, so that what lies behind them is reached.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "formats/bundle.h"

namespace texbake::fuzz {

/// Small bundles at several states of the chain: one scale with everything, a stack of two, a palette without exemplar.
std::vector<Bundle> sound_bundles();

/// The names and bytes of the files of a bundle, and one string of them.
using Files = std::map<std::string, std::string>;
std::string packed(const Files& files);
/// What `packed` made; of other bytes as much as can be made out.
Files unpacked(std::string_view bytes);

Files files_of(const std::filesystem::path& folder);
/// The folder holds these files and no others.
void write_files(const Files& files, const std::filesystem::path& folder);

enum class Repair {
  names,   ///< of payloads, as the manifest has its hashes
  hashes,  ///< of pixels, as they are in the payloads, then names
};
/// Puts right what depends on what was changed, as far as `json` still is a manifest: names of files, and with them the
/// files, hashes of stages.
void repair(Json& json, Files& files, Repair what);

}  // namespace texbake::fuzz
