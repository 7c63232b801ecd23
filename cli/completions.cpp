#include "cli/completions.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/help.h"

namespace texbake {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// Between single quotes of a shell; `quote` is how it writes one inside.
std::string quoted(const std::string& text, const std::string& quote) {
  return fmt::format("'{}'", replaced(text, "'", quote));
}

/// "-o", "--output"; none for a positional.
std::vector<std::string> spellings(const Argument& argument) {
  if (argument.form == Form::positional) return {};
  std::vector<std::string> list;
  if (argument.letter) list.push_back(fmt::format("-{}", argument.letter));
  list.push_back("--" + argument.name);
  return list;
}

std::vector<const Argument*> pointers(const Arguments& first, const Arguments& second) {
  std::vector<const Argument*> list;
  for (const Arguments* arguments : {&first, &second})
    for (const Argument& argument : arguments->list()) list.push_back(&argument);
  return list;
}

// --- bash

/// The body of a case of bash for arguments in one place of the command line: all options, and what the value of the
/// option before the cursor, or else the positional, may be.
std::string bash_case(const std::vector<const Argument*>& arguments) {
  std::vector<std::string> options;
  std::string operands, values;
  for (const Argument* argument : arguments) {
    const std::vector<std::string> names = spellings(*argument);
    options.insert(options.end(), names.begin(), names.end());
    const char* kind = argument->names == Names::file ? "files" : argument->names == Names::folder ? "folders" : "text";
    if (argument->form == Form::positional) operands = kind;
    if (argument->form != Form::option) continue;
    values += fmt::format("        {}) {} ;;\n", fmt::join(names, " | "),
                          argument->choices.empty() ? fmt::format("kind={}", kind)
                                                    : fmt::format("words='{}'", fmt::join(argument->choices, " ")));
  }
  return fmt::format("      options='{}'\n      operands={}\n      case $previous in\n{}      esac\n",
                     fmt::join(options, " "), operands, values);
}

constexpr const char* kBashEnd = R"(  if [ -n "$words" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
    return
  fi
  if [ -z "$kind" ] && [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    return
  fi
  case ${kind:-$operands} in
    files) mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    folders) mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
    *) COMPREPLY=() ;;
  esac
  compopt -o filenames 2> /dev/null
}
complete -F _texbake texbake
)";

// --- zsh

/// Between the brackets of a description of _arguments, in single quotes.
std::string zsh_text(const std::string& text) {
  std::string result = replaced(text, "\\", "\\\\");
  for (const char* sign : {"[", "]", ":"}) result = replaced(result, sign, std::string("\\") + sign);
  return replaced(result, "'", "'\\''");
}

std::string zsh_value(const Argument& argument) {
  if (!argument.choices.empty()) return fmt::format("({})", fmt::join(argument.choices, " "));
  if (argument.names == Names::file) return "_files";
  return argument.names == Names::folder ? "_files -/" : " ";
}

/// One argument as _arguments takes it.
std::string zsh_spec(const Argument& argument) {
  const bool again = argument.repeat == Repeat::each;
  if (argument.form == Form::positional)
    return fmt::format("'{}:{}:{}'", again ? "*" : "", zsh_text(argument.name), zsh_value(argument));
  const std::vector<std::string> names = spellings(argument);
  const std::string value =
      argument.form == Form::option ? fmt::format(":{}:{}", zsh_text(argument.value), zsh_value(argument)) : "";
  const std::string text = fmt::format("[{}]{}", zsh_text(argument.help), value);
  if (again) return fmt::format("'*{}{}'", names.back(), text);
  if (names.size() == 1) return fmt::format("'{}{}'", names.back(), text);
  return fmt::format("'({0})'{{{1}}}'{2}'", fmt::join(names, " "), fmt::join(names, ","), text);
}

std::string zsh_specs(const std::vector<const Argument*>& arguments) {
  std::string specs;
  for (const Argument* argument : arguments) specs += " \\\n        " + zsh_spec(*argument);
  return specs + "\n";
}

// --- fish

/// One argument; `condition` says when it is offered, "" always.
std::string fish_line(const Argument& argument, const std::string& condition) {
  std::string line = "complete -c texbake";
  if (!condition.empty()) line += fmt::format(" -n {}", quoted(condition, "\\'"));
  if (argument.form == Form::positional) return line + (argument.names == Names::nothing ? " -f\n" : " -F\n");
  if (argument.letter) line += fmt::format(" -s {}", argument.letter);
  line += " -l " + argument.name;
  if (!argument.choices.empty())
    line += fmt::format(" -x -a '{}'", fmt::join(argument.choices, " "));
  else if (argument.names == Names::file)
    line += " -r -F";
  else if (argument.names == Names::folder)
    line += " -x -a '(__fish_complete_directories)'";
  else if (argument.form == Form::option)
    line += " -x";
  return line + fmt::format(" -d {}\n", quoted(replaced(argument.help, "\\", "\\\\"), "\\'"));
}

}  // namespace

std::string bash_completion(const CommandLine& line) {
  std::vector<std::string> with_value;
  for (const Argument& argument : line.common().list())
    if (argument.form == Form::option)
      for (const std::string& name : spellings(argument)) with_value.push_back(name);
  std::string text = fmt::format(R"(# Completions of texbake {} for bash.
_texbake() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} verb='' i
  local options='' operands='' words='' kind=''
  if [ "$current" = = ]; then
    current=''
  elif [ "$previous" = = ]; then
    previous=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case ${{COMP_WORDS[i]}} in
      {}) ((++i)) ;;
      -*) ;;
      *) verb=${{COMP_WORDS[i]}} && break ;;
    esac
  done
  case $verb in
    '')
)",
                                 program_version(), fmt::join(with_value, " | "));
  const std::string verbs = fmt::format("{} help", fmt::join(line.verb_names(), " "));
  text += bash_case(pointers(line.program(), line.common()));
  text += fmt::format("      [[ $current == -* || -n $words$kind ]] || words='{}'\n      ;;\n", verbs);
  text += fmt::format("    help) words='{}' ;;\n", fmt::join(line.verb_names(), " "));
  for (const Verb& verb : line.verbs())
    text += fmt::format("    {})\n{}      ;;\n", verb.name(), bash_case(pointers(verb.arguments, line.common())));
  return text + "  esac\n" + kBashEnd;
}

std::string zsh_completion(const CommandLine& line) {
  std::string verbs, cases;
  for (const Verb& verb : line.verbs()) {
    verbs += fmt::format("        '{}:{}'\n", verb.name(), zsh_text(verb.command.summary));
    cases += fmt::format("    {})\n      _arguments -s{}      ;;\n", verb.name(),
                         zsh_specs(pointers(verb.arguments, line.common())));
  }
  return fmt::format(R"(#compdef texbake
# Completions of texbake {} for zsh.
_texbake() {{
  local curcontext="$curcontext" state line
  local -a verbs
  _arguments -s -C '1:verb:->verb' '*::argument:->argument'{}  case $state in
    verb)
      verbs=(
{}        'help:{}'
      )
      _describe verb verbs
      ;;
    argument) _texbake_verb ;;
  esac
}}
_texbake_verb() {{
  case $words[1] in
    help) _arguments '1:verb:({})' ;;
{}  esac
}}
_texbake "$@"
)",
                     program_version(), zsh_specs(pointers(line.program(), line.common())), verbs,
                     zsh_text(kHelpSummary), fmt::join(line.verb_names(), " "), cases);
}

std::string fish_completion(const CommandLine& line) {
  std::string text = fmt::format("# Completions of texbake {} for fish.\ncomplete -c texbake -f\n", program_version());
  const std::string none = fmt::format("not __fish_seen_subcommand_from {} help", fmt::join(line.verb_names(), " "));
  const auto word = [&](const std::string& verb, const std::string& summary) {
    text += fmt::format("complete -c texbake -n '{}' -a {} -d {}\n", none, verb, quoted(summary, "\\'"));
  };
  for (const Verb& verb : line.verbs()) word(verb.name(), verb.command.summary);
  word("help", kHelpSummary);
  text += fmt::format("complete -c texbake -n '__fish_seen_subcommand_from help' -a '{}'\n",
                      fmt::join(line.verb_names(), " "));
  for (const Argument& argument : line.program().list()) text += fish_line(argument, none);
  for (const Argument& argument : line.common().list()) text += fish_line(argument, "");
  for (const Verb& verb : line.verbs())
    for (const Argument& argument : verb.arguments.list())
      text += fish_line(argument, "__fish_seen_subcommand_from " + verb.name());
  return text;
}

}  // namespace texbake
