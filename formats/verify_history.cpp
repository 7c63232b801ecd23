#include "formats/verify_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "formats/history.h"
#include "formats/json_text.h"
#include "formats/stage_table.h"

namespace texbake {
namespace {

/// The figures of a stage that follow from what the bundle holds, by the names the verbs record them under.
Json countable_figures(const std::string& verb, const Scale& scale) {
  const auto areas = [](const Partition& partition) -> Json {
    if (partition.areas_px.empty()) return Json::object();  // could not be read
    const auto [least, most] = std::ranges::minmax(partition.areas_px);
    return {{"count", partition.count()}, {"minArea", least}, {"maxArea", most}};
  };
  if (verb == "convert" && scale.colors) return {{"classes", scale.colors->palette.classes.size()}};
  if (verb == "fragment" && scale.fragments) return areas(scale.fragments->partition);
  if (verb == "patch" && scale.patches) return areas(scale.patches->partition);
  return Json::object();
}

void find_nulls(const Json& json, const std::string& pointer, IssueLog& log) {
  if (json.is_null())
    log.add({IssueId::figure_implausible, {.pointer = pointer}, "expected a finite number, found null"});
  if (!json.is_structured()) return;
  for (const auto& [key, value] : json.items())
    if (value.is_null() || value.is_structured()) find_nulls(value, pointer_below(pointer, key), log);
}

void check_counts(const Stage& stage, const Json& countable, const std::string& pointer, IssueLog& log) {
  for (const auto& [key, counted] : countable.items()) {
    const auto figure = stage.figures.find(key);
    if (figure != stage.figures.end() && figure->is_number() && *figure != counted)
      log.add({IssueId::figure_implausible,
               {.pointer = pointer_below(pointer, key)},
               fmt::format("expected {}, found {}", compact_json(counted), compact_json(*figure))});
  }
}

bool has_record(const Bundle& bundle, const std::string& verb, const Scale& scale) {
  return std::ranges::any_of(bundle.stages, [&](const Stage& stage) {
    return stage.verb == verb && (stage.scale.empty() || stage.scale == scale.name);
  });
}

}  // namespace

void check_state(LoadedBundle& loaded, IssueLog& log) {
  const Bundle& bundle = loaded.bundle;
  if (!loaded.manifest.contains("scales")) return;
  Json noise;
  if (loaded.manifest.contains("noise")) noise = std::move(loaded.manifest["noise"]);
  const Json scales = history_json({std::move(loaded.manifest["scales"]), std::move(noise)});
  HistoryHashes hashes(scales, bundle.sources, bundle.stages);
  for (size_t i = 0; i < bundle.stages.size(); ++i) {
    const Stage& stage = bundle.stages[i];
    const std::string output = hashes.output(i);
    if (stage.output != output)
      log.add({IssueId::state_mismatch,
               {.pointer = fmt::format("/stages/{}/output", i)},
               fmt::format("{}: expected {}, found {}", stage.verb, output, stage.output)});
    const std::string input = hashes.input(i);
    if (stage.input != input)
      log.add({IssueId::chain_broken,
               {.pointer = fmt::format("/stages/{}/input", i)},
               fmt::format("{}: expected {}, found {}", stage.verb, input, stage.input)});
  }
}

void check_stages(const Bundle& bundle, IssueLog& log) {
  for (const Scale& scale : bundle.scales)
    for (const StageRow& row : stage_table())
      if (row.result.is_in && row.result.is_in(bundle, scale) && !has_record(bundle, row.verb, scale))
        log.add({IssueId::stage_missing,
                 {.pointer = "/stages"},
                 fmt::format("expected a stage {} because there are {} in the scale \"{}\", found none", row.verb,
                             row.result.name, scale.name)});
}

void check_figures(const Bundle& bundle, size_t scale, IssueLog& log) {
  std::map<std::string, Json> countable;  // by verb: counting costs a pass over all shapes, and stages may be many
  for (size_t i = 0; i < bundle.stages.size(); ++i) {
    const Stage& stage = bundle.stages[i];
    if (bundle.scales.size() > 1 && stage.scale != bundle.scales[scale].name) continue;
    if (!countable.contains(stage.verb)) countable[stage.verb] = countable_figures(stage.verb, bundle.scales[scale]);
    check_counts(stage, countable[stage.verb], fmt::format("/stages/{}/figures", i), log);
  }
}

void check_nulls(const Bundle& bundle, IssueLog& log) {
  for (size_t i = 0; i < bundle.stages.size(); ++i)
    find_nulls(bundle.stages[i].figures, fmt::format("/stages/{}/figures", i), log);
}

}  // namespace texbake
