// Turns the list of fields of a stage's options into flags of the command line, with their help.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "libbake/base/option_text.h"

namespace texbake {

/// One flag, whatever the type of its value.
struct Flag {
  std::string name;      ///< without "--"
  std::string accepted;  ///< "1 to 64 colours"
  std::string standard;  ///< the default, "auto (how)" for an automatic value
  std::string help;
  std::function<void(const std::string&)> assign;  ///< reads the text of the value; throws Error(usage)
};

/// Adds `flag` to `app` under the heading `group`.
void add_flag(CLI::App& app, const Flag& flag, const std::string& group);

/// Adds every field of `options`, which must outlive the parse, as --PREFIXNAME.
template <class Options>
void add_flags(CLI::App& app, Options& options, const std::string& group, const std::string& prefix = "") {
  Options::fields(options, [&](auto& value, const Field& field) {
    const std::string name = prefix + field.name;
    std::string standard = value_text(value);
    if (standard == "auto" && *field.auto_help) standard += fmt::format(" ({})", field.auto_help);
    add_flag(app,
             {.name = name,
              .accepted = accepted_text<std::decay_t<decltype(value)>>(field),
              .standard = standard,
              .help = field.help,
              .assign = [&value, name, field](const std::string& text) { assign_text(value, name, field, text); }},
             group);
  });
}

}  // namespace texbake
