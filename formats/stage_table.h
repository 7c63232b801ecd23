// Every stage of the program in one table. The order of the chain, what a stage that runs again drops, what a recipe
// may ask for, the hashes of a record and the checks of a history all follow from it: a stage is added by adding its
// row.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/bundle.h"

namespace texbake {

/// When bake runs a stage.
enum class StageUse {
  always,  ///< for every picture
  layers,  ///< for pictures that are split into structure and noise
  never,   ///< it is asked for by its verb alone
};

/// What is left in a bundle by a stage, and by no stage before it.
struct StageResult {
  const char* name = nullptr;  ///< in messages, a plural; nullptr: not to be told from the bundle
  bool (*is_in)(const Bundle& bundle, const Scale& scale) = nullptr;
  void (*drop)(Bundle& bundle, Scale& scale) = nullptr;  ///< nullptr: it can only be replaced
};

/// Members are those of a scale in bundle.json, planes as "planes.KEY"; "noise" is the bundle's.
struct StageRow {
  std::string verb;
  StageUse use = StageUse::never;
  std::vector<std::string> reads;  ///< nothing for convert, which reads files
  std::vector<std::string> writes;
  StageResult result = {};
};

/// All stages: those of the chain in its order, then the others.
std::span<const StageRow> stage_table();

/// Nothing for a verb that is no stage.
const StageRow* find_row(std::string_view verb);

/// The first stage: it makes a bundle from files.
const StageRow& first_stage();

/// Is the stage one that bake runs, for some pictures at least?
inline bool is_in_chain(const StageRow& row) { return row.use != StageUse::never; }

/// The stages of the chain that read what `verb` writes, directly or not, in order. None for a verb outside the chain.
std::vector<const StageRow*> derived_stages(std::string_view verb);

}  // namespace texbake
