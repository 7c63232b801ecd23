// The hashes by which the record of a stage says what it read of a bundle and wrote to it: members as in
// formats/stage_table.h. The record of a verb that is not in the table is kept and not judged.
#pragma once

#include <string>
#include <vector>

#include "formats/manifest.h"

namespace texbake {

/// What stage `at` wrote and no later stage of the same scale has written since: the members that are still its own.
std::vector<std::string> owned_members(const std::vector<Stage>& stages, size_t at);

/// The scales, the finest with the bundle's noise as its last member: what the hashes below are taken of.
Json history_json(const StateJson& state);

/// SHA-256 of the texts of the scales that `stage` is about, each with `members` alone and without the files of planes.
std::string members_hash(const Json& scales, const Stage& stage, const std::vector<std::string>& members);

/// What stage `at` read, as it is in the bundle now. convert reads the sources of its scale.
std::string input_hash(const Json& scales, const std::vector<SourceFile>& sources, const std::vector<Stage>& stages,
                       size_t at);
/// What is still its own, as it is in the bundle now.
std::string output_hash(const Json& scales, const std::vector<Stage>& stages, size_t at);

/// Appends `stage` with its hashes. Records whose results it replaced tell from then on of what is left of them.
void record_stage(Bundle& bundle, Stage stage);

}  // namespace texbake
