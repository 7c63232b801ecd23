// What a person may have meant by a word that is not known.
// Based on: Levenshtein 1966; Damerau 1964 for the swap of two neighbors.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace texbake {

/// Least number of insertions, deletions, replacements and swaps of neighboring bytes that turns `a` into `b`.
int edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to `word`, the first of equals; nothing when even that is too far to be a typing mistake.
std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> known);

/// `; did you mean "WORD"?`, or "" when no known word is near.
std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace texbake
