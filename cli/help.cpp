#include "cli/help.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "cli/text_wrap.h"

namespace texbake {
namespace {

constexpr int kLeastWidth = 60;
constexpr int kWidthOfFiles = 100;
constexpr int kIndent = 2;

/// Writes help of a width.
class HelpWriter {
 public:
  explicit HelpWriter(int width) : width_(width), column_(std::min(30, width / 3)) {}

  void paragraph(const std::string& text);
  void gap() { text_ += "\n"; }
  void heading(const std::string& text) { text_ += fmt::format("\n{}:\n", text); }
  /// `name` at the left and `description` beside it, or below where the name is long.
  void entry(const std::string& name, const std::string& description);
  void arguments(const Arguments& arguments);
  /// Lines of text, each a paragraph.
  void remarks(const std::string& title, const std::string& lines);
  /// Command lines, one a line.
  void examples(const std::string& commands);

  const std::string& text() const { return text_; }

 private:
  void lines(const std::vector<std::string>& lines, int indent, int indent_of_more);

  int width_;
  int column_;  ///< where descriptions begin
  std::string text_;
};

void HelpWriter::lines(const std::vector<std::string>& lines, int indent, int indent_of_more) {
  for (const std::string& line : lines) {
    text_ += std::string(static_cast<size_t>(indent), ' ') + line + "\n";
    indent = indent_of_more;
  }
}

void HelpWriter::paragraph(const std::string& text) { lines(wrapped(text, width_), 0, 0); }

void HelpWriter::entry(const std::string& name, const std::string& description) {
  const int room = column_ - 2 * kIndent;
  std::vector<std::string> beside = wrapped(description, width_ - column_);
  if (columns_of(name) <= room) {
    const auto gap = static_cast<size_t>(column_ - kIndent - columns_of(name));
    if (beside.empty()) beside.emplace_back();
    beside.front().insert(0, name + std::string(gap, ' '));
    return lines(beside, kIndent, column_);
  }
  lines(wrapped(name, width_ - 3 * kIndent), kIndent, 3 * kIndent);
  lines(beside, column_, column_);
}

void HelpWriter::arguments(const Arguments& arguments) {
  for (const ArgumentGroup& group : arguments.groups()) {
    heading(group.heading);
    for (const Argument* argument : group.arguments) entry(heading_of(*argument), description_of(*argument));
  }
}

void HelpWriter::remarks(const std::string& title, const std::string& text) {
  heading(title);
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines(wrapped(line, width_ - 3 * kIndent), kIndent, 3 * kIndent);
}

void HelpWriter::examples(const std::string& commands) {
  heading("Examples");
  std::istringstream stream(commands);
  for (std::string line; std::getline(stream, line);)
    lines(wrapped_command(line.substr(line.find_first_not_of(' ')), width_ - 3 * kIndent), kIndent, 3 * kIndent);
}

}  // namespace

int help_width() {
  int width = kWidthOfFiles;
  winsize size{};
  if (isatty(STDOUT_FILENO) && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) width = size.ws_col;
  if (const char* columns = std::getenv("COLUMNS"); columns && std::atoi(columns) > 0) width = std::atoi(columns);
  return std::max(width, kLeastWidth);
}

std::string description_of(const Argument& argument) {
  std::string text = argument.help;
  if (argument.required && argument.form == Form::option) text += "; required";
  if (!argument.excludes.empty()) text += fmt::format("; not together with --{}", argument.excludes);
  if (!argument.standard.empty()) text += fmt::format("; default: {}", argument.standard);
  return text;
}

std::string heading_of(const Argument& argument) {
  if (argument.form == Form::positional) return argument.name + (argument.repeat == Repeat::each ? "..." : "");
  return (argument.letter ? fmt::format("-{}, ", argument.letter) : "") + "--" + argument.name +
         (argument.value.empty() ? "" : " ") + argument.value;
}

std::string usage_of(const Verb& verb) {
  std::string text = fmt::format("texbake {} [OPTIONS]", verb.name()), positionals;
  for (const Argument& argument : verb.arguments.list()) {
    if (argument.form == Form::positional)
      positionals += fmt::format(" {}", heading_of(argument));
    else if (argument.required)
      text += fmt::format(" --{} {}", argument.name, argument.value);
  }
  return text + positionals;
}

std::string help_text(const CommandLine& line, int width) {
  HelpWriter writer(width);
  writer.paragraph(kProgramSummary);
  writer.gap();
  writer.paragraph("Usage: texbake VERB [OPTIONS] ...");
  writer.heading("Verbs");
  for (const Verb& verb : line.verbs()) writer.entry(verb.name(), verb.command.summary);
  writer.entry("help", kHelpSummary);
  writer.arguments(line.program());
  writer.arguments(line.common());
  writer.examples(kProgramExample);
  return writer.text();
}

std::string help_text(const CommandLine& line, const Verb& verb, int width) {
  HelpWriter writer(width);
  writer.paragraph(verb.command.summary);
  writer.gap();
  writer.paragraph("Usage: " + usage_of(verb));
  writer.arguments(verb.arguments);
  writer.arguments(line.common());
  if (!verb.command.combinations.empty()) writer.remarks("Combinations", verb.command.combinations);
  writer.examples(verb.command.example);
  return writer.text();
}

}  // namespace texbake
