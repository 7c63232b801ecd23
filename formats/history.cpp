#include "formats/history.h"

#include <fmt/format.h>

#include <algorithm>

#include "formats/json_text.h"
#include "formats/manifest.h"
#include "formats/sha256.h"
#include "formats/stage_table.h"

namespace texbake {
namespace {

constexpr const char* kPlanes = "planes.";

bool writes(const std::string& verb, const std::string& member) {
  const StageRow* row = find_row(verb);
  return row && std::ranges::find(row->writes, member) != row->writes.end();
}

void erase_files(Json& json) {
  if (json.is_object()) json.erase("file");
  if (json.is_structured())
    for (Json& member : json) erase_files(member);
}

bool is_about(const Stage& stage, const Json& scale) {
  return stage.scale.empty() || (scale.is_object() && scale.value("name", Json()) == stage.scale);
}

Json restricted(const Json& scale, const std::vector<std::string>& members) {
  const auto wanted = [&](const std::string& member) { return std::ranges::find(members, member) != members.end(); };
  Json part = Json::object();
  for (const auto& [key, value] : scale.items()) {
    if (wanted(key)) part[key] = value;
    if (key != "planes") continue;
    for (const auto& [plane, ref] : value.items())
      if (wanted(kPlanes + plane)) part["planes"][plane] = ref;
  }
  erase_files(part);
  return part;
}

}  // namespace

std::vector<std::string> owned_members(const std::vector<Stage>& stages, size_t at) {
  std::vector<std::string> owned;
  const StageRow* row = find_row(stages[at].verb);
  if (!row) return owned;
  for (const std::string& member : row->writes) {
    const bool replaced =
        std::any_of(stages.begin() + static_cast<ptrdiff_t>(at) + 1, stages.end(),
                    [&](const Stage& later) { return later.scale == stages[at].scale && writes(later.verb, member); });
    if (!replaced) owned.push_back(member);
  }
  return owned;
}

Json history_json(const StateJson& state) {
  Json scales = state.scales;
  if (!state.noise.is_null() && scales.is_array() && !scales.empty() && scales.back().is_object())
    scales.back()["noise"] = state.noise;
  return scales;
}

std::string members_hash(const Json& scales, const Stage& stage, const std::vector<std::string>& members) {
  Json parts = Json::array();
  for (const Json& scale : scales)
    if (is_about(stage, scale)) parts.push_back(restricted(scale, members));
  return sha256(compact_json(parts));
}

std::string input_hash(const Json& scales, const std::vector<SourceFile>& sources, const std::vector<Stage>& stages,
                       size_t at) {
  const Stage& stage = stages[at];
  const StageRow* row = find_row(stage.verb);
  if (!row) return stage.input;
  if (row != &first_stage()) return members_hash(scales, stage, row->reads);
  std::string lines;
  for (const SourceFile& source : sources)
    if (source.scale == stage.scale && source.role != kClicksRole)
      lines += fmt::format("{} {}\n", source.role, source.sha256);
  return sha256(lines);
}

std::string output_hash(const Json& scales, const std::vector<Stage>& stages, size_t at) {
  return find_row(stages[at].verb) ? members_hash(scales, stages[at], owned_members(stages, at)) : stages[at].output;
}

void record_stage(Bundle& bundle, Stage stage) {
  const Json scales = history_json(state_json(bundle, plane_refs(bundle)));
  bundle.stages.push_back(std::move(stage));
  const size_t last = bundle.stages.size() - 1;
  bundle.stages[last].input = input_hash(scales, bundle.sources, bundle.stages, last);
  for (size_t i = 0; i <= last; ++i) bundle.stages[i].output = output_hash(scales, bundle.stages, i);
}

}  // namespace texbake
