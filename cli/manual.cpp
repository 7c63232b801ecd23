// Based on: man(7) and groff_man(7): only macros that mandoc knows too, and no character beyond ASCII.
#include "cli/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "cli/exit_code.h"
#include "cli/help.h"
#include "formats/byte_text.h"

namespace texbake {
namespace {

/// `text`, which is UTF-8, so that troff prints it as it stands.
std::string escaped(const std::string& text) {
  std::string result = text.starts_with(".") || text.starts_with("'") ? "\\&" : "";
  for (std::string_view rest = text; !rest.empty();) {
    const CodePoint point = first_code_point(rest);
    if (point.value == '\\')
      result += "\\e";
    else if (point.value == '-')
      result += "\\-";
    else if (point.value < 0x80)
      result += static_cast<char>(point.value);
    else
      result += fmt::format("\\[u{:04X}]", point.value);
    rest.remove_prefix(point.bytes);
  }
  return result;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

/// What an option takes: a line may break after each word of a choice.
std::string value_text(const std::string& value) {
  std::string text = italic(value);
  for (size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 3) text.insert(at + 1, "\\:");
  return text;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::toupper(letter); });
  return text;
}

std::string section(const std::string& title) { return ".SH " + escaped(title) + "\n"; }

std::string item(const std::string& name, const std::string& text) { return ".TP\n" + name + "\n" + text + "\n"; }

std::string heading(const Argument& argument) {
  if (argument.form == Form::positional) return italic(heading_of(argument));
  std::string text = argument.letter ? bold(fmt::format("-{}", argument.letter)) + ", " : "";
  text += bold("--" + argument.name);
  return argument.value.empty() ? text : text + " " + value_text(argument.value);
}

std::string arguments(const Arguments& list) {
  std::string text;
  for (const ArgumentGroup& group : list.groups()) {
    text += ".SS " + escaped(group.heading) + "\n";
    for (const Argument* argument : group.arguments)
      text += item(heading(*argument), escaped(description_of(*argument)));
  }
  return text;
}

std::string title(const std::string& name) {
  return fmt::format(".TH {} 1 \"\" \"texbake {}\" \"texbake\"\n", escaped(upper(name)), program_version());
}

std::string name_section(const std::string& name, const std::string& summary) {
  return section("NAME") + escaped(name) + " \\- " + escaped(summary) + "\n";
}

std::string combinations(const std::string& lines) {
  if (lines.empty()) return {};
  std::string text = section("COMBINATIONS");
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) text += escaped(line) + "\n.br\n";
  return text;
}

std::string examples(const std::string& commands) {
  std::string text = section("EXAMPLES") + ".nf\n";
  std::istringstream stream(commands);
  for (std::string line; std::getline(stream, line);) text += escaped(line.substr(line.find_first_not_of(' '))) + "\n";
  return text + ".fi\n";
}

std::string page_name(const Verb& verb) { return "texbake-" + verb.name(); }

/// The pages of all verbs but `except`.
std::string see_also(const CommandLine& line, const Verb* except) {
  std::string text = section("SEE ALSO");
  if (except) text += ".BR texbake (1),\n";
  for (const Verb& verb : line.verbs())
    if (&verb != except) text += ".BR " + escaped(page_name(verb)) + " (1),\n";
  text.erase(text.size() - 2, 1);  // the last comma
  return text;
}

std::string exit_status() {
  std::string text = section("EXIT STATUS");
  for (const ExitCodeWords& words : kExitCodes)
    text += item(bold(fmt::format("{}", static_cast<int>(words.code))), escaped(words.meaning));
  return text;
}

}  // namespace

std::string manual_page(const CommandLine& line) {
  std::string text = title("texbake") + name_section("texbake", kProgramBrief);
  text += section("SYNOPSIS") + bold("texbake") + " " + italic("VERB") + " [" + italic("OPTIONS") + "] ...\n";
  text += section("DESCRIPTION") + escaped(kProgramSummary) + "\n" + ".SS Verbs\n";
  for (const Verb& verb : line.verbs()) text += item(bold(verb.name()), escaped(verb.command.summary));
  text += item(bold("help"), escaped(kHelpSummary));
  text += section("OPTIONS") + arguments(line.program()) + arguments(line.common());
  return text + exit_status() + examples(kProgramExample) + see_also(line, nullptr);
}

std::string manual_page(const CommandLine& line, const Verb& verb) {
  std::string text = title(page_name(verb)) + name_section(page_name(verb), verb.command.summary);
  text += section("SYNOPSIS") + escaped(usage_of(verb)) + "\n";
  text += section("OPTIONS") + arguments(verb.arguments) + arguments(line.common());
  text += section("EXIT STATUS") + "That of\n.BR texbake (1).\n";
  return text + combinations(verb.command.combinations) + examples(verb.command.example) + see_also(line, &verb);
}

}  // namespace texbake
