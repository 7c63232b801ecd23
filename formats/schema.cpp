#include "formats/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "formats/json_text.h"

namespace texbake {
namespace {

constexpr size_t kMaxShown = 60;  // bytes of a value in a message
constexpr const char* kManifestFile = "bundle.json";
constexpr std::string_view kDefinitions = "#/definitions/";

const Json& parsed_schema() {
  static const Json schema = Json::parse(bundle_schema());
  return schema;
}

/// Every pattern of the schema, made once: a manifest may ask for each of them a hundred thousand times.
const std::regex& compiled(const std::string& pattern) {
  static const std::map<std::string, std::regex> all = [] {
    std::map<std::string, std::regex> result;
    std::vector<const Json*> open = {&parsed_schema()};
    while (!open.empty()) {
      const Json& json = *open.back();
      open.pop_back();
      const auto found = json.is_object() ? json.find("pattern") : json.end();
      if (found != json.end()) result.emplace(*found, std::regex(found->get<std::string>()));
      if (json.is_structured())
        for (const Json& member : json) open.push_back(&member);
    }
    return result;
  }();
  return all.at(pattern);
}

/// Characters of UTF-8.
size_t length_of(const std::string& text) {
  return static_cast<size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

bool has_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return type == "boolean" && value.is_boolean();
}

/// Draft 7, as far as bundle.schema.json uses it: a keyword that is not listed in `constrain` does nothing.
class Validator {
 public:
  explicit Validator(IssueLog& log) : log_(log) {}

  void check(const Json& schema, const Json& value) {
    for (const auto& [keyword, expected] : schema.items())
      if (keyword != "items" || !is_too_long(schema, value)) constrain(keyword, expected, value);
  }

 private:
  /// From a value to one of its members or elements.
  struct Step {
    const std::string* name = nullptr;  ///< nullptr: an element
    size_t index = 0;
  };

  /// Then one issue says so: whoever made the list may want millions of them.
  static bool is_too_long(const Json& schema, const Json& list) {
    const auto limit = schema.find("maxItems");
    return limit != schema.end() && list.is_array() && list.size() > limit->get<size_t>();
  }

  void check_below(Step step, const Json& schema, const Json& value) {
    path_.push_back(step);
    check(schema, value);
    path_.pop_back();
  }

  void constrain(const std::string& keyword, const Json& expected, const Json& value) {
    if (keyword == "$ref")
      check(parsed_schema()["definitions"][expected.get<std::string>().substr(kDefinitions.size())], value);
    else if (keyword == "allOf")
      for (const Json& part : expected) check(part, value);
    else if (keyword == "type")
      demand(has_type(value, expected), value, [&] { return fmt::format("type {}", expected.get<std::string>()); });
    else if (keyword == "const")
      demand(value == expected, value, [&] { return compact_json(expected); });
    else if (keyword == "enum")
      demand(std::ranges::find(expected, value) != expected.end(), value,
             [&] { return fmt::format("one of {}", compact_json(expected)); });
    else if (value.is_object())
      constrain_object(keyword, expected, value);
    else if (value.is_array())
      constrain_array(keyword, expected, value);
    else if (value.is_string())
      constrain_string(keyword, expected, value);
    else if (value.is_number())
      constrain_number(keyword, expected, value);
  }

  void constrain_object(const std::string& keyword, const Json& expected, const Json& value) {
    if (keyword == "required")
      for (const Json& name : expected)
        demand(value.contains(name.get<std::string>()), value, [&] { return fmt::format("a member {}", name.dump()); });
    if (keyword == "properties")
      for (const auto& [name, schema] : expected.items())
        if (const auto member = value.find(name); member != value.end()) check_below({.name = &name}, schema, *member);
    if (keyword == "propertyNames")
      for (const auto& [name, member] : value.items())
        demand(std::regex_search(name, compiled(expected["pattern"])), value, [&, same = name] {
          return fmt::format("names of members like {}, not {}", expected["pattern"].get<std::string>(),
                             compact_json(shortened(same, kMaxShown)));
        });
  }

  void constrain_array(const std::string& keyword, const Json& expected, const Json& value) {
    if (keyword == "minItems")
      demand(value.size() >= expected.get<size_t>(), value,
             [&] { return fmt::format("at least {} elements", expected.dump()); });
    if (keyword == "maxItems")
      demand(value.size() <= expected.get<size_t>(), value,
             [&] { return fmt::format("at most {} elements", expected.dump()); });
    if (keyword == "uniqueItems")
      demand(std::set<Json>(value.begin(), value.end()).size() == value.size(), value,
             [] { return "different elements"; });
    if (keyword == "items")
      for (size_t i = 0; i < value.size(); ++i) check_below({.index = i}, expected, value[i]);
  }

  void constrain_string(const std::string& keyword, const Json& expected, const Json& value) {
    const std::string& text = value.get_ref<const std::string&>();
    if (keyword == "minLength")
      demand(length_of(text) >= expected.get<size_t>(), value,
             [&] { return fmt::format("at least {} characters", expected.dump()); });
    if (keyword == "maxLength")
      demand(length_of(text) <= expected.get<size_t>(), value,
             [&] { return fmt::format("at most {} characters", expected.dump()); });
    if (keyword == "pattern")
      demand(std::regex_search(text, compiled(expected)), value,
             [&] { return fmt::format("text like {}", expected.get<std::string>()); });
  }

  void constrain_number(const std::string& keyword, const Json& expected, const Json& value) {
    if (keyword == "minimum")
      demand(value >= expected, value, [&] { return fmt::format("at least {}", expected.dump()); });
    if (keyword == "maximum")
      demand(value <= expected, value, [&] { return fmt::format("at most {}", expected.dump()); });
    if (keyword == "not") {
      const auto divisor = expected["multipleOf"].get<int64_t>();
      demand(!value.is_number_integer() || value.get<int64_t>() % divisor != 0, value,
             [&] { return fmt::format("no multiple of {}", divisor); });
    }
  }

  /// `says` is asked only for what is shown: a manifest may be wrong in a million places.
  template <class Says>
  void demand(bool holds, const Json& value, const Says& says) {
    if (holds) return;
    if (!log_.shows_more(IssueId::schema_violation)) return log_.count_more(IssueId::schema_violation);
    const std::string pointer = pointer_text();
    log_.add({IssueId::schema_violation,
              {.pointer = pointer, .file = pointer.empty() ? kManifestFile : ""},
              fmt::format("expected what bundle.schema.json allows ({}), found {}", says(),
                          shortened_json(value, kMaxShown))});
  }

  std::string pointer_text() const {
    Json::json_pointer pointer;
    for (const Step& step : path_) pointer.push_back(step.name ? *step.name : std::to_string(step.index));
    return pointer.to_string();
  }

  IssueLog& log_;
  std::vector<Step> path_;
};

}  // namespace

void check_schema(const Json& manifest, IssueLog& log) { Validator(log).check(parsed_schema(), manifest); }

}  // namespace texbake
