// Reads the value of an option from the words a person wrote, strictly: what is not understood whole is refused.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "libbake/base/options.h"

namespace texbake {

/// The values an option accepts, in words: "1 to 64 colours", "impact|balanced"; for a text, its unit.
std::string number_range_text(const Field& field);
std::string names_text(std::span<const std::string_view> names);

/// Throw Error(usage) `--classes: expected 1 to 64 colors, found "many"`. `flag` is the name after "--".
double parse_number(std::string_view flag, const Field& field, std::string_view text);
int64_t parse_integer(std::string_view flag, const Field& field, std::string_view text);
/// The position of `text` among `names`; the error suggests the nearest.
size_t parse_name(std::string_view flag, std::span<const std::string_view> names, std::string_view text);

/// "4096x2048", "4096X2048" or "4096,2048" → 4096, 2048; both ≥ 1.
struct PixelSize {
  int width = 0;
  int height = 0;
};
PixelSize parse_size(std::string_view flag, std::string_view text);

/// "-12,99999999999.5" → two decimals, as text: they may have more digits than any number type.
struct DecimalPoint {
  std::string x;
  std::string y;
};
DecimalPoint parse_point(std::string_view flag, std::string_view text);

/// "512M", "4G", "4GiB", "1000000": bytes; K, M, G, T are powers of 1024.
uint64_t parse_bytes(std::string_view flag, std::string_view text);

/// May `name` name a plane of a bundle? At most 63 letters, digits, '-' and '_', the first a letter.
inline constexpr size_t kMaxPlaneNameLength = 63;
bool is_plane_name(std::string_view name);

/// "NAME=FILE" → NAME, FILE; NAME may name a plane.
struct NamedFile {
  std::string name;
  std::string file;
};
NamedFile parse_named_file(std::string_view flag, std::string_view text);

/// The values of an enum, by their names.
template <class E>
std::span<const std::string_view> enum_names() {
  static constexpr auto names = [] {
    std::array<std::string_view, std::size(EnumNames<E>::values)> list{};
    for (size_t i = 0; i < list.size(); ++i) list[i] = EnumNames<E>::values[i].second;
    return list;
  }();
  return names;
}

/// Sets `value` from `text`. An optional also takes "auto".
template <class T>
void assign_text(T& value, std::string_view flag, const Field& field, std::string_view text) {
  if constexpr (IsOptional<T>::value) {
    if (text == "auto") {
      value.reset();
    } else {
      typename T::value_type given{};
      assign_text(given, flag, field, text);
      value = given;
    }
  } else if constexpr (std::is_enum_v<T>) {
    value = EnumNames<T>::values[parse_name(flag, enum_names<T>(), text)].first;
  } else if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(parse_number(flag, field, text));
  } else if constexpr (std::is_integral_v<T>) {
    value = static_cast<T>(parse_integer(flag, field, text));
  } else {
    value = T(text);
  }
}

/// The value as a person would write it; "auto" for an unset optional.
template <class T>
std::string value_text(const T& value) {
  if constexpr (IsOptional<T>::value)
    return value ? value_text(*value) : "auto";
  else if constexpr (std::is_enum_v<T>)
    return std::string(enum_name(value));
  else
    return fmt::format("{}", value);
}

/// What the option accepts, in words.
template <class T>
std::string accepted_text(const Field& field) {
  if constexpr (IsOptional<T>::value)
    return accepted_text<typename T::value_type>(field);
  else if constexpr (std::is_enum_v<T>)
    return names_text(enum_names<T>());
  else if constexpr (std::is_arithmetic_v<T>)
    return number_range_text(field);
  else
    return *field.unit ? field.unit : "TEXT";
}

}  // namespace texbake
