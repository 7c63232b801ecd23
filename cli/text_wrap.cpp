#include "cli/text_wrap.h"

#include <algorithm>

namespace texbake {
namespace {

/// The words between the spaces of `text`.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find(' ', begin), text.size());
    if (end > begin) words.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// A word that is longer than `width`, in pieces that end at a '|' or a ','.
std::vector<std::string> pieces_of(const std::string& word, int width) {
  if (columns_of(word) <= width) return {word};
  std::vector<std::string> pieces;
  for (size_t begin = 0; begin < word.size();) {
    const size_t end = std::min(word.find_first_of("|,", begin), word.size() - 1) + 1;
    pieces.push_back(word.substr(begin, end - begin));
    begin = end;
  }
  return pieces;
}

/// Appends `piece` to the last line, after `gap`, or begins a line where it has no room.
void append(std::vector<std::string>& lines, const std::string& gap, const std::string& piece, int width) {
  if (!lines.empty() && columns_of(lines.back()) + columns_of(gap) + columns_of(piece) <= width)
    lines.back() += gap + piece;
  else
    lines.push_back(piece);
}

}  // namespace

int columns_of(std::string_view text) {
  return static_cast<int>(std::ranges::count_if(text, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

std::vector<std::string> wrapped(std::string_view text, int width) {
  std::vector<std::string> lines;
  for (const std::string& word : words_of(text)) {
    const std::vector<std::string> pieces = pieces_of(word, width);
    for (size_t i = 0; i < pieces.size(); ++i) append(lines, i == 0 ? " " : "", pieces[i], width);
  }
  return lines;
}

std::vector<std::string> wrapped_command(std::string_view command, int width) {
  constexpr std::string_view kContinued = " \\";
  if (columns_of(command) <= width) return {std::string(command)};
  std::vector<std::string> units;  // an option with its value, or another word
  for (const std::string& word : words_of(command)) {
    const bool is_value = !word.starts_with("-") && !units.empty() && units.back().starts_with("-") &&
                          units.back().find(' ') == std::string::npos;
    if (is_value)
      units.back() += " " + word;
    else
      units.push_back(word);
  }
  std::vector<std::string> lines;
  for (const std::string& unit : units) append(lines, " ", unit, width - static_cast<int>(kContinued.size()));
  for (size_t i = 0; i + 1 < lines.size(); ++i) lines[i] += kContinued;
  return lines;
}

}  // namespace texbake
