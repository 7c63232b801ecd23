#include "cli/kept_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "formats/byte_text.h"
#include "formats/input_file.h"
#include "formats/json_text.h"
#include "formats/limits.h"
#include "formats/sha256.h"
#include "libbake/base/error.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_output(const std::string& output, const std::string& what) {
  throw Error(
      ErrorKind::usage,
      fmt::format("{}: expected the name of a file that may be replaced, found {}; choose another name", output, what));
}

bool is_source(const fs::path& file, const SourceFile& source) {
  std::error_code failed;
  return fs::file_size(file, failed) == source.size_bytes && !failed && sha256_file(file) == source.sha256;
}

/// What a manifest says of the bundle's past.
struct Past {
  std::vector<std::string> verbs;  ///< of its stages
  std::vector<SourceFile> colors;  ///< the sources of its colors
};

std::string text_member(const Json& json, const char* name) {
  const Json value = json.is_object() ? json.value(name, Json()) : Json();
  return value.is_string() ? value.get<std::string>() : "";
}

Json list_member(const Json& json, const char* name) {
  const Json value = json.is_object() ? json.value(name, Json()) : Json();
  return value.is_array() ? value : Json::array();
}

/// Of a bundle of any version, as far as it can be read.
Past past_of(const fs::path& bundle) {
  IssueLog log("", IssueLog::OnError::collect);
  const Json manifest = parse_json(file_bytes((bundle / kManifestName).string(), kMaxManifestBytes), log);
  Past past;
  for (const Json& stage : list_member(manifest, "stages")) past.verbs.push_back(text_member(stage, "verb"));
  for (const Json& source : list_member(manifest, "sources"))
    if (text_member(source, "role") == kColorRole)
      past.colors.push_back({kColorRole, bytes_of_text(text_member(source, "name")), text_member(source, "sha256")});
  return past;
}

bool has_stage(const Bundle& bundle, const std::string& verb) {
  return std::ranges::find(bundle.stages, verb, &Stage::verb) != bundle.stages.end();
}

bool has_source(const Bundle& bundle, const SourceFile& source) {
  return std::ranges::find(bundle.sources, source.sha256, &SourceFile::sha256) != bundle.sources.end();
}

}  // namespace

void check_keeps_inputs(const std::string& output, std::span<const std::string> inputs) {
  std::error_code failed;
  if (output.empty() || !fs::exists(output, failed)) return;
  for (const std::string& input : inputs)
    if (fs::equivalent(output, input, failed))
      refuse_output(output, fmt::format("an input of this command ({})", input));
}

void check_keeps_sources(const std::string& output, const Bundle& bundle) {
  std::error_code failed;
  if (output.empty() || !fs::is_regular_file(output, failed)) return;
  for (const SourceFile& source : bundle.sources)
    if (is_source(output, source))
      refuse_output(output, fmt::format("a file that the bundle was made from ({} \"{}\")", source.role, source.name));
}

std::vector<std::string> losses(const std::string& path, const Bundle& bundle) {
  std::error_code failed;
  if (!fs::exists(fs::path(path) / kManifestName, failed)) return {};
  const Past past = past_of(path);
  std::vector<std::string> found, verbs;
  for (const std::string& verb : past.verbs)
    if (!has_stage(bundle, verb) && std::ranges::find(verbs, verb) == verbs.end()) verbs.push_back(verb);
  if (!verbs.empty())
    found.push_back(
        fmt::format("{}: replaced a bundle that had more stages ({}): their results are dropped; run them "
                    "again, or bake the whole chain with texbake bake",
                    path, fmt::join(verbs, ", ")));
  for (const SourceFile& color : past.colors)
    if (!has_source(bundle, color))
      found.push_back(
          fmt::format("{}: replaced a bundle of another picture, \"{}\" with SHA-256 {}; to keep both, give "
                      "one of them another name with -o",
                      path, color.name, color.sha256));
  return found;
}

}  // namespace texbake
