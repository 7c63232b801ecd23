// The hashes by which the record of a stage says what it read of a bundle and wrote to it: members as in
// formats/stage_table.h. The record of a verb that is not in the table is kept and not judged.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "formats/manifest.h"

namespace texbake {

/// What stage `at` wrote and no later stage of the same scale has written since: the members that are still its own.
std::vector<std::string> owned_members(const std::vector<Stage>& stages, size_t at);

/// The scales, the finest with the bundle's noise as its last member: what the hashes below are taken of.
Json history_json(StateJson state);

/// The hashes of the stages of one bundle, as it is now. A stranger's bundle has a thousand stages and megabytes of
/// tables: equal members of equal scales are hashed once. What it is made of must stay until it goes.
class HistoryHashes {
 public:
  /// `scales` as history_json makes them.
  HistoryHashes(const Json& scales, const std::vector<SourceFile>& sources, const std::vector<Stage>& stages);

  /// What stage `at` read. convert reads the sources of its scale.
  std::string input(size_t at);
  /// What it wrote and is still its own.
  std::string output(size_t at);

 private:
  using Members = std::vector<std::string>;
  std::string of_sources(const std::string& scale);
  /// SHA-256 of the texts of the scales that a stage of `scale` is about, each with `members` alone and without the
  /// files of planes.
  std::string of_members(const std::string& scale, const Members& members);

  const Json& scales_;
  const std::vector<SourceFile>& sources_;
  const std::vector<Stage>& stages_;
  std::map<std::pair<std::string, std::string>, size_t> last_writer_;  ///< by scale and member
  std::map<std::pair<std::string, Members>, std::string> hashes_;      ///< by scale
};

/// Appends `stage` with its hashes. Records whose results it replaced tell from then on of what is left of them.
void record_stage(Bundle& bundle, Stage stage);

}  // namespace texbake
