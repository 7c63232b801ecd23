#include "bake/provenance.h"

#include <algorithm>

#include "formats/stage_table.h"

namespace texbake {
namespace {

void drop_result(Bundle& bundle, const StageRow& row) {
  if (!row.result.drop) return;
  for (Scale& scale : bundle.scales) row.result.drop(bundle, scale);
}

/// Returns whether there was a record of `verb`.
bool drop_record(Bundle& bundle, const std::string& verb) {
  return std::erase_if(bundle.stages, [&](const Stage& stage) { return stage.verb == verb; }) > 0;
}

}  // namespace

std::vector<std::string> drop_stage(Bundle& bundle, const std::string& verb) {
  if (const StageRow* row = find_row(verb)) drop_result(bundle, *row);
  drop_record(bundle, verb);
  std::vector<std::string> dropped;
  for (const StageRow* derived : derived_stages(verb)) {
    drop_result(bundle, *derived);
    if (drop_record(bundle, derived->verb)) dropped.push_back(derived->verb);
  }
  return dropped;
}

const Stage* find_stage(const Bundle& bundle, const std::string& verb) {
  const auto found =
      std::find_if(bundle.stages.begin(), bundle.stages.end(), [&](const Stage& stage) { return stage.verb == verb; });
  return found == bundle.stages.end() ? nullptr : &*found;
}

}  // namespace texbake
