// How a stage declares its options: one list of fields that the command line, the help text, the checks and the
// provenance all read. A stage writes
//
//   struct FragmentOptions {
//     std::optional<float> threshold;   // auto when unset
//     int min_area_px = 8;
//     template <class Self, class Visitor>
//     static void fields(Self& self, Visitor&& visit) {
//       visit(self.threshold, Field{.name = "threshold", .unit = "ΔE", .min = 0, .max = 100, .help = "..."});
//       visit(self.min_area_px, Field{.name = "min-area", .unit = "px", .min = 1, .max = 1e6, .help = "..."});
//     }
//   };
//
// A field is an int, uint32_t, float, double, std::string, an enum with EnumNames, or a std::optional of one of these.
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "libbake/base/error.h"

namespace texbake {

/// What a person must know about one option. `name` is the long flag and the JSON key, in kebab-case.
struct Field {
  const char* name;
  const char* unit = "";  ///< "" for a pure number or a name
  double min = 0;         ///< inclusive range, for numbers
  double max = 0;
  const char* help = "";
  const char* auto_help = "";  ///< for std::optional: how the value is chosen when it is not given
};

/// The names of an enum's values. Specialize with
/// `static constexpr std::pair<E, std::string_view> values[] = {{E::a, "a"}, ...};`
template <class E>
struct EnumNames;

template <class E>
requires std::is_enum_v<E> std::string_view enum_name(E value) {
  for (const auto& [candidate, name] : EnumNames<E>::values)
    if (candidate == value) return name;
  return "?";
}

template <class E>
requires std::is_enum_v<E> std::optional<E> enum_value(std::string_view name) {
  for (const auto& [value, candidate] : EnumNames<E>::values)
    if (candidate == name) return value;
  return std::nullopt;
}

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// Throws Error(usage) naming the first field outside its range.
template <class Options>
void check_options(const Options& options) {
  const auto check = [](const auto& value, const Field& field, const auto& self) -> void {
    using T = std::decay_t<decltype(value)>;
    if constexpr (IsOptional<T>::value) {
      if (value) self(*value, field, self);
    } else if constexpr (std::is_arithmetic_v<T>) {
      const auto number = static_cast<double>(value);
      if (!(number >= field.min && number <= field.max))
        throw Error(ErrorKind::usage, fmt::format("--{}: expected {} to {}{}{}, found {}", field.name, field.min,
                                                  field.max, *field.unit ? " " : "", field.unit, value));
    }
  };
  Options::fields(options, [&](const auto& value, const Field& field) { check(value, field, check); });
}

}  // namespace texbake
