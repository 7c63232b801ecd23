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

/// By scale and member, the last stage that writes it.
std::map<std::pair<std::string, std::string>, size_t> last_writers(const std::vector<Stage>& stages) {
  std::map<std::pair<std::string, std::string>, size_t> last;
  for (size_t i = 0; i < stages.size(); ++i)
    if (const StageRow* row = find_row(stages[i].verb))
      for (const std::string& member : row->writes) last[{stages[i].scale, member}] = i;
  return last;
}

void erase_files(Json& json) {
  if (json.is_object()) json.erase("file");
  if (json.is_structured())
    for (Json& member : json) erase_files(member);
}

bool is_about(const std::string& name, const Json& scale) {
  return name.empty() || (scale.is_object() && scale.value("name", Json()) == name);
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

std::vector<std::string> owned(const std::vector<Stage>& stages,
                               const std::map<std::pair<std::string, std::string>, size_t>& last_writer, size_t at) {
  std::vector<std::string> members;
  if (const StageRow* row = find_row(stages[at].verb))
    for (const std::string& member : row->writes)
      if (last_writer.at({stages[at].scale, member}) == at) members.push_back(member);
  return members;
}

}  // namespace

std::vector<std::string> owned_members(const std::vector<Stage>& stages, size_t at) {
  return owned(stages, last_writers(stages), at);
}

Json history_json(StateJson state) {
  Json scales = std::move(state.scales);
  if (!state.noise.is_null() && scales.is_array() && !scales.empty() && scales.back().is_object())
    scales.back()["noise"] = std::move(state.noise);
  return scales;
}

HistoryHashes::HistoryHashes(const Json& scales, const std::vector<SourceFile>& sources,
                             const std::vector<Stage>& stages)
    : scales_(scales), sources_(sources), stages_(stages), last_writer_(last_writers(stages)) {}

std::string HistoryHashes::input(size_t at) {
  const StageRow* row = find_row(stages_[at].verb);
  if (!row) return stages_[at].input;
  return row == &first_stage() ? of_sources(stages_[at].scale) : of_members(stages_[at].scale, row->reads);
}

std::string HistoryHashes::output(size_t at) {
  if (!find_row(stages_[at].verb)) return stages_[at].output;
  return of_members(stages_[at].scale, owned(stages_, last_writer_, at));
}

std::string HistoryHashes::of_sources(const std::string& scale) {
  std::string lines;
  for (const SourceFile& source : sources_)
    if (source.scale == scale && source.role != kClicksRole)
      lines += fmt::format("{} {}\n", source.role, source.sha256);
  return sha256(lines);
}

std::string HistoryHashes::of_members(const std::string& scale, const Members& members) {
  std::string& hash = hashes_[{scale, members}];
  if (!hash.empty()) return hash;
  Json parts = Json::array();
  for (const Json& one : scales_)
    if (is_about(scale, one)) parts.push_back(restricted(one, members));
  return hash = sha256(compact_json(parts));
}

void record_stage(Bundle& bundle, Stage stage) {
  const Json scales = history_json(state_json(bundle, plane_refs(bundle)));
  bundle.stages.push_back(std::move(stage));
  const size_t last = bundle.stages.size() - 1;
  HistoryHashes hashes(scales, bundle.sources, bundle.stages);
  bundle.stages[last].input = hashes.input(last);
  for (size_t i = 0; i <= last; ++i) bundle.stages[i].output = hashes.output(i);
}

}  // namespace texbake
