// Turns the list of fields of a stage's options into flags of the command line, with their help.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/arguments.h"
#include "libbake/base/option_text.h"

namespace texbake {

/// The words that a value of type T may be, where they can be listed.
template <class T>
std::vector<std::string> choices_of() {
  std::vector<std::string> choices;
  if constexpr (IsOptional<T>::value) {
    choices = choices_of<typename T::value_type>();
    if (!choices.empty()) choices.push_back("auto");
  } else if constexpr (std::is_enum_v<T>) {
    for (const std::string_view name : enum_names<T>()) choices.emplace_back(name);
  }
  return choices;
}

/// `field` of an options struct as the option --NAME, which sets `value`; `value` must outlive the parse.
template <class T>
Argument option_of(T& value, const Field& field, const std::string& name) {
  std::string standard = value_text(value);
  if (standard == "auto" && *field.auto_help) standard += fmt::format(" ({})", field.auto_help);
  return {.name = name,
          .value = accepted_text<T>(field),
          .choices = choices_of<T>(),
          .names = std::string_view(field.unit) == "FILE" ? Names::file : Names::nothing,
          .standard = standard,
          .help = field.help,
          .repeat = Repeat::last,
          .assign = [&value, name, field](const std::string& text) { assign_text(value, name, field, text); }};
}

/// The flag of a field. It is the field's name, but for a name that bundles record in another spelling.
inline std::string_view flag_of(std::string_view field_name) { return field_name == "colour" ? "color" : field_name; }

/// Adds every field of `options`, which must outlive the parse, as --PREFIXFLAG under the heading `group`.
/// The name of a field whose flag differs from it is accepted too.
template <class Options>
void add_flags(Arguments& arguments, Options& options, const std::string& group, const std::string& prefix = "") {
  Options::fields(options, [&](auto& value, const Field& field) {
    const std::string flag = prefix + std::string(flag_of(field.name));
    Argument option = option_of(value, field, flag);
    if (flag != prefix + field.name) option.alias = prefix + field.name;
    option.group = group;
    arguments.option(std::move(option));
  });
}

}  // namespace texbake
