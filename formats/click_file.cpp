#include "formats/click_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "formats/click_picture.h"
#include "formats/input_file.h"
#include "formats/json_text.h"
#include "formats/sha256.h"

namespace texbake {
namespace {

constexpr const char* kForms = "{\"x\": 12, \"y\": 34, \"height\": 0.5} or [12, 34, 0.5]";

[[noreturn]] void refuse(const std::string& where, const std::string& expected, const std::string& found) {
  throw Error(ErrorKind::bad_data, fmt::format("{}: expected {}, found {}", where, expected, found));
}

int texel_of(double coordinate, const std::string& where) {
  constexpr double kFar = 1e9;
  if (!(std::abs(coordinate) < kFar)) refuse(where, "a coordinate in texels", fmt::format("{}", coordinate));
  return static_cast<int>(std::floor(coordinate));
}

HeightClick click_of(double x, double y, double height, const std::string& where) {
  return {{texel_of(x, where), texel_of(y, where)}, static_cast<float>(height)};
}

HeightClick click_of(const Json& json, const std::string& where) {
  Json triple = json;
  if (json.is_object()) {
    triple = Json::array();
    for (const auto& [key, value] : json.items())
      if (key != "x" && key != "y" && key != "height") refuse(where, kForms, fmt::format("a member \"{}\"", key));
    for (const char* key : {"x", "y", "height"}) triple.push_back(json.value(key, Json()));
  }
  if (!triple.is_array() || triple.size() != 3) refuse(where, kForms, compact_json(json));
  for (const Json& number : triple)
    if (!number.is_number()) refuse(where, kForms, compact_json(json));
  return click_of(triple[0].get<double>(), triple[1].get<double>(), triple[2].get<double>(), where);
}

std::vector<HeightClick> clicks_of_json(const std::string& text, const std::string& path) {
  const Json json = parse_json(text, path);
  const Json& list = json.is_object() && json.contains("clicks") ? json["clicks"] : json;
  if (!list.is_array()) refuse(path, fmt::format("a list of {}", kForms), compact_json(list).substr(0, 60));
  std::vector<HeightClick> clicks;
  for (size_t i = 0; i < list.size(); ++i) clicks.push_back(click_of(list[i], fmt::format("{}: [{}]", path, i)));
  return clicks;
}

/// The words of a line, parted by any of `parting`. Between quotation marks, which are left out, nothing parts.
std::vector<std::string> words_of(std::string_view line, std::string_view parting) {
  std::vector<std::string> words;
  bool in_word = false, in_quotes = false;
  for (const char c : line) {
    const bool parts = !in_quotes && parting.find(c) != std::string_view::npos;
    if (!parts && !in_word) words.emplace_back();
    in_word = !parts;
    if (c == '"')
      in_quotes = !in_quotes;
    else if (!parts)
      words.back() += c;
  }
  return words;
}

/// A number with a decimal point or, as spreadsheets write it in many countries, a decimal comma.
std::optional<double> number_of(std::string word) {
  std::ranges::replace(word, ',', '.');
  const char* const begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* const end = word.data() + word.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

/// The fields of a line. A semicolon parts them wherever one is: commas are then decimal. Without one, a comma parts
/// them, unless that does not make three of them but white space does.
std::vector<std::string> fields_of(std::string_view row) {
  if (row.find(';') != std::string_view::npos) return words_of(row, "; \t\r");
  const std::vector<std::string> by_comma = words_of(row, ", \t\r"), by_space = words_of(row, " \t\r");
  return by_comma.size() != 3 && by_space.size() == 3 ? by_space : by_comma;
}

std::vector<HeightClick> clicks_of_csv(std::string_view text, const std::string& path) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<HeightClick> clicks;
  for (int line = 1; !text.empty(); ++line) {
    const std::string_view row = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(row.size() + 1, text.size()));
    const std::vector<std::string> words = fields_of(row);
    if (words.empty() || words[0].starts_with('#')) continue;
    const std::string where = fmt::format("{}: line {}", path, line);
    const auto x = number_of(words[0]);
    if (line == 1 && !x) continue;  // names of columns
    const auto y = words.size() == 3 ? number_of(words[1]) : std::nullopt;
    const auto height = words.size() == 3 ? number_of(words[2]) : std::nullopt;
    if (!x || !y || !height) refuse(where, "x, y, height", fmt::format("\"{}\"", row.substr(0, 60)));
    clicks.push_back(click_of(*x, *y, *height, where));
  }
  return clicks;
}

}  // namespace

ClickFile read_clicks(const std::string& path) {
  check_input_file(path);
  const std::filesystem::path file_path(path);
  const std::string bytes = file_bytes(path);

  const std::string extension = file_path.extension().string();
  ClickFile file;
  if (extension == ".json")
    file.clicks = clicks_of_json(bytes, path);
  else if (extension == ".csv" || extension == ".txt")
    file.clicks = clicks_of_csv(bytes, path);
  else
    file = read_click_picture(path);
  file.name = file_path.filename().string();
  file.sha256 = sha256(bytes);
  file.size_bytes = bytes.size();
  return file;
}

}  // namespace texbake
