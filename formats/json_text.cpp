#include "formats/json_text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <vector>

#include "formats/byte_text.h"
#include "formats/limits.h"

namespace texbake {
namespace {

constexpr size_t kColumns = 120;
constexpr size_t kMaxNameInMessage = 120;  // bytes

template <class Number>
std::string shortest_digits(Number value) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string double_text(double value) {
  if (!std::isfinite(value)) return "null";
  std::string text = shortest_digits(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string string_text(const std::string& value) { return Json(is_utf8(value) ? value : text_of_bytes(value)).dump(); }

std::string scalar_text(const Json& json) {
  if (json.is_number_float()) return double_text(json.get<double>());
  if (json.is_string()) return string_text(json.get_ref<const std::string&>());
  return json.dump();
}

/// One line; `gap` stands after every comma and colon. Once there are `enough` bytes, no more is added.
void append_line(const Json& json, std::string_view gap, std::string& out, size_t enough = std::string::npos) {
  if (!json.is_structured()) {
    out += scalar_text(json);
    return;
  }
  out += json.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, value] : json.items()) {
    if (!std::exchange(first, false)) (out += ',') += gap;
    if (json.is_object()) ((out += string_text(key)) += ':') += gap;
    append_line(value, gap, out, enough);
    if (out.size() > enough) return;
  }
  out += json.is_object() ? '}' : ']';
}

void append_lines(const Json& json, size_t indent, size_t column, std::string& out) {
  std::string line;
  append_line(json, " ", line);
  if (!json.is_structured() || json.empty() || column + line.size() < kColumns) {
    out += line;
    return;
  }
  out += json.is_object() ? "{" : "[";
  bool first = true;
  for (const auto& [key, value] : json.items()) {
    out += std::exchange(first, false) ? "\n" : ",\n";
    out.append(indent + 2, ' ');
    const std::string label = json.is_object() ? string_text(key) + ": " : "";
    out += label;
    append_lines(value, indent + 2, indent + 2 + label.size(), out);
  }
  (out += '\n').append(indent, ' ');
  out += json.is_object() ? '}' : ']';
}

/// Ends the parsing of a document that is not accepted.
struct Refused {
  IssueId id;
  std::string detail;
};

/// Makes values of what the parser reads, and refuses what JSON allows and a manifest must not have. A callback of
/// Json::parse would do the same in a time that grows with the square of the length of a list.
class StrictParser : public nlohmann::detail::json_sax_dom_parser<Json> {
 public:
  using Base = nlohmann::detail::json_sax_dom_parser<Json>;
  explicit StrictParser(Json& result) : Base(result, /*allow_exceptions_=*/true) {}

  bool start_object(size_t size) {
    enter();
    keys_.emplace_back();
    return Base::start_object(size);
  }
  bool end_object() {
    --depth_;
    keys_.pop_back();
    return Base::end_object();
  }
  bool start_array(size_t size) {
    enter();
    return Base::start_array(size);
  }
  bool end_array() {
    --depth_;
    return Base::end_array();
  }
  bool key(std::string& name) {
    if (!keys_.back().insert(name).second)
      throw Refused{IssueId::json_duplicate_key, fmt::format("expected each key only once, found {} twice",
                                                             shortened(string_text(name), kMaxNameInMessage))};
    if (keys_.back().size() > kMaxMembers)
      throw Refused{IssueId::json_too_deep,
                    fmt::format("expected at most {} members of an object, found more", kMaxMembers)};
    return Base::key(name);
  }

 private:
  void enter() {
    if (++depth_ > kMaxManifestDepth)
      throw Refused{IssueId::json_too_deep,
                    fmt::format("expected at most {} levels of nesting, found more", kMaxManifestDepth)};
  }

  int depth_ = 0;
  std::vector<std::set<std::string>> keys_;
};

/// Of a document, if it is JSON: before memory is taken for them.
size_t count_of_values(std::string_view text) {
  size_t count = 1;
  bool is_first = false;  // of a list or an object, if it has any
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    if (c == ',' || (is_first && c != ']' && c != '}')) ++count;
    is_first = c == '[' || c == '{';
    if (c != '"') continue;
    for (++i; i < text.size() && text[i] != '"'; ++i)
      if (text[i] == '\\') ++i;
  }
  return count;
}

struct Parsed {
  Json json;                       ///< null after a refusal
  std::optional<Refused> refused;  ///< what is wrong with it
};

/// What nlohmann's exceptions say, without their number: "parse error at line 2, column 1: ...".
std::string reason_of(const Json::exception& error) {
  const std::string words = error.what();
  const size_t end = words.find("] ");
  return end == std::string::npos ? words : words.substr(end + 2);
}

Parsed parsed_json(std::string_view text) {
  if (const size_t count = count_of_values(text); count > kMaxValues)
    return {nullptr, Refused{IssueId::json_too_deep,
                             fmt::format("expected at most {} values in all, found {}", kMaxValues, count)}};
  try {
    Parsed parsed;
    StrictParser parser(parsed.json);
    Json::sax_parse(text, &parser);
    return parsed;
  } catch (const Refused& refused) {
    return {nullptr, refused};
  } catch (const Json::exception& error) {
    return {nullptr, Refused{IssueId::json_syntax, fmt::format("expected JSON in UTF-8, found: {}", reason_of(error))}};
  }
}

}  // namespace

Json json_number(float value) {
  if (!std::isfinite(value)) return nullptr;
  const std::string text = shortest_digits(value);
  double number = value;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return static_cast<float>(number) == value ? number : static_cast<double>(value);
}

Json vector_json(const V3f& v) { return Json::array({json_number(v.x), json_number(v.y), json_number(v.z)}); }

std::string vector_text(const V3f& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

V3f vector_of(const Json& json) { return {json[0].get<float>(), json[1].get<float>(), json[2].get<float>()}; }

Json parse_json(std::string_view text, IssueLog& log) {
  Parsed parsed = parsed_json(text);
  if (parsed.refused) log.add({parsed.refused->id, {.file = "bundle.json"}, parsed.refused->detail});
  return std::move(parsed.json);
}

Json parse_json(std::string_view text, const std::string& path) {
  Parsed parsed = parsed_json(text);
  if (parsed.refused) throw Error(ErrorKind::bad_data, fmt::format("{}: {}", path, parsed.refused->detail));
  return std::move(parsed.json);
}

Json with_text(const Json& json) {
  if (json.is_string()) return text_of_bytes(json.get_ref<const std::string&>());
  if (!json.is_structured()) return json;
  Json copy = json.is_array() ? Json::array() : Json::object();
  for (const auto& [key, value] : json.items())
    if (json.is_array())
      copy.push_back(with_text(value));
    else
      copy[text_of_bytes(key)] = with_text(value);
  return copy;
}

std::string print_lines(const Json& json) { return with_text(json).dump(2) + "\n"; }

std::string print_json(const Json& json) {
  std::string text;
  append_lines(json, 0, 0, text);
  return text + "\n";
}

std::string compact_json(const Json& json) {
  std::string text;
  append_line(json, "", text);
  return text;
}

std::string shortened(std::string text, size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && (text[bytes] & 0xC0) == 0x80) --bytes;
  text.resize(bytes);
  return text + "...";
}

std::string shortened_json(const Json& json, size_t bytes) {
  std::string text;
  append_line(json, "", text, bytes);
  return shortened(std::move(text), bytes);
}

std::string pointer_below(const std::string& pointer, const std::string& name) {
  return pointer + (Json::json_pointer() / shortened(name, kMaxNameInMessage)).to_string();
}

}  // namespace texbake
