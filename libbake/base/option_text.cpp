#include "libbake/base/option_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "libbake/base/suggestion.h"

namespace texbake {
namespace {

[[noreturn]] void refuse(std::string_view flag, const std::string& expected, std::string_view found) {
  throw Error(ErrorKind::usage, fmt::format("--{}: expected {}, found \"{}\"", flag, expected, found));
}

/// The number that `text` spells from its first to its last character, or nothing.
template <class T>
std::optional<T> whole_number(std::string_view text) {
  T value{};
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool inside(const Field& field, double value) { return value >= field.min && value <= field.max; }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_name_character(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; }

}  // namespace

std::string number_range_text(const Field& field) {
  return fmt::format("{} to {}{}{}", field.min, field.max, *field.unit ? " " : "", field.unit);
}

std::string names_text(std::span<const std::string_view> names) { return fmt::format("{}", fmt::join(names, "|")); }

double parse_number(std::string_view flag, const Field& field, std::string_view text) {
  const auto value = whole_number<double>(text);
  if (!value || !std::isfinite(*value) || !inside(field, *value)) refuse(flag, number_range_text(field), text);
  return *value;
}

int64_t parse_integer(std::string_view flag, const Field& field, std::string_view text) {
  const auto value = whole_number<int64_t>(text);
  if (!value) refuse(flag, "a whole number, " + number_range_text(field), text);
  if (!inside(field, static_cast<double>(*value))) refuse(flag, number_range_text(field), text);
  return *value;
}

size_t parse_name(std::string_view flag, std::span<const std::string_view> names, std::string_view text) {
  for (size_t i = 0; i < names.size(); ++i)
    if (names[i] == text) return i;
  const std::vector<std::string> known(names.begin(), names.end());
  throw Error(ErrorKind::usage, fmt::format("--{}: expected one of {}, found \"{}\"{}", flag, fmt::join(names, ", "),
                                            text, suggestion(text, known)));
}

PixelSize parse_size(std::string_view flag, std::string_view text) {
  const size_t cross = text.find_first_of("xX,");
  const auto width = whole_number<int>(text.substr(0, cross));
  const auto height = cross == text.npos ? width : whole_number<int>(text.substr(cross + 1));
  if (!width || !height || *width < 1 || *height < 1) refuse(flag, "WIDTHxHEIGHT in pixels, such as 4096x2048", text);
  return {*width, *height};
}

DecimalPoint parse_point(std::string_view flag, std::string_view text) {
  const size_t comma = text.find(',');
  if (comma == text.npos) refuse(flag, "X,Y in texels, such as -512,4096", text);
  return {std::string(text.substr(0, comma)), std::string(text.substr(comma + 1))};
}

uint64_t parse_bytes(std::string_view flag, std::string_view text) {
  const size_t digits = std::min(text.find_first_not_of("0123456789."), text.size());
  const auto amount = whole_number<double>(text.substr(0, digits));
  std::string_view unit = text.substr(digits);
  for (const std::string_view suffix : {"iB", "B"})
    if (unit.ends_with(suffix)) unit.remove_suffix(suffix.size());
  const size_t power = unit.empty() ? 0 : std::string_view("KMGT").find(unit) + 1;
  if (!amount || unit.size() > 1 || (!unit.empty() && power == 0)) refuse(flag, "a size such as 512M or 4G", text);
  const double bytes = std::ldexp(*amount, static_cast<int>(10 * power));
  if (!(bytes >= 1) || bytes >= std::ldexp(1.0, 62)) refuse(flag, "a size such as 512M or 4G", text);
  return static_cast<uint64_t>(bytes);
}

bool is_plane_name(std::string_view name) {
  return !name.empty() && name.size() <= kMaxPlaneNameLength && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(), is_name_character);
}

NamedFile parse_named_file(std::string_view flag, std::string_view text) {
  const size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  if (equals == text.npos || equals + 1 == text.size() || name.empty())
    refuse(flag, "NAME=FILE, such as normal=rock_normal.png", text);
  if (!is_plane_name(name))
    refuse(
        flag,
        fmt::format("a NAME of at most {} letters, digits, '-' and '_' that begins with a letter", kMaxPlaneNameLength),
        text);
  return {std::string(name), std::string(text.substr(equals + 1))};
}

}  // namespace texbake
