#include "formats/schema.h"

#include <fmt/format.h>

#include <memory>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "formats/json_text.h"

namespace texbake {
namespace {

using PlainJson = nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

constexpr const char* kManifestFile = "bundle.json";
constexpr size_t kMaxShown = 60;      // characters of a value in a message
constexpr size_t kMaxReported = 200;  // a file of another kind need not be listed member by member

const valijson::Schema& compiled_schema() {
  static const auto schema = [] {
    auto result = std::make_unique<valijson::Schema>();
    const PlainJson text = PlainJson::parse(bundle_schema());
    valijson::SchemaParser().populateSchema(Adapter(text), *result);
    return result;
  }();
  return *schema;
}

/// The steps "<root>", "[scales]", "[0]" as the pointer /scales/0.
Json::json_pointer pointer_of(const std::vector<std::string>& context) {
  Json::json_pointer pointer;
  for (const std::string& step : context)
    if (step.size() >= 2 && step.front() == '[') pointer.push_back(step.substr(1, step.size() - 2));
  return pointer;
}

/// The value at `pointer`, cut to what fits into a message.
std::string shown(const Json& manifest, const Json::json_pointer& pointer) {
  if (!manifest.contains(pointer)) return "nothing";
  const std::string found = compact_json(manifest.at(pointer));
  return found.size() <= kMaxShown ? found : fmt::format("{}...", found.substr(0, kMaxShown));
}

/// What an outer level says about a failure that an inner level has already reported.
bool is_wrapper(const std::string& description) { return description.starts_with("Failed to validate"); }

}  // namespace

void check_schema(const Json& manifest, IssueLog& log) {
  const PlainJson plain = manifest;
  valijson::ValidationResults results;
  if (valijson::Validator().validate(compiled_schema(), Adapter(plain), &results)) return;
  size_t reported = 0;
  std::set<std::pair<std::string, std::string>> seen;
  for (const auto& error : results) {
    const Json::json_pointer at = pointer_of(error.context);
    const std::string pointer = at.to_string();
    if (is_wrapper(error.description) || !seen.insert({pointer, error.description}).second) continue;
    if (++reported > kMaxReported) return;
    log.add({IssueId::schema_violation,
             {.pointer = pointer, .file = pointer.empty() ? kManifestFile : ""},
             fmt::format("expected what bundle.schema.json allows ({}), found {}", error.description,
                         shown(manifest, at))});
  }
  if (reported == 0)
    log.add({IssueId::schema_violation, {.file = kManifestFile}, "expected what bundle.schema.json allows"});
}

}  // namespace texbake
