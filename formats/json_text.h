// Reads JSON strictly and writes it so that equal values give equal bytes and people can read it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "formats/issues.h"
#include "libbake/base/torus.h"

namespace texbake {

/// The value that prints as the shortest decimal which reads back as `value`: 0.1f as 0.1, not 0.10000000149011612.
Json json_number(float value);
/// The same of each component, in an array.
Json vector_json(const V3f& vector);
/// The same for people: (0.5, 0.25, 1).
std::string vector_text(const V3f& vector);
/// A vector from such an array.
V3f vector_of(const Json& json);

/// `text`, that of bundle.json, as a value. Reports json_syntax, json_too_deep and json_duplicate_key, and then returns
/// null.
Json parse_json(std::string_view text, IssueLog& log);
/// The same for the text of another file, that at `path`. Throws Error(bad_data).
Json parse_json(std::string_view text, const std::string& path);

/// `json` with every string as text_of_bytes makes it.
Json with_text(const Json& json);

/// Arrays and objects on one line where they fit into 120 columns, else one element to a line, two spaces a level; a
/// final newline. Doubles are the shortest decimals that read back to the same value and always show a point or an
/// exponent; what is not finite becomes null; strings that are not UTF-8 become what text_of_bytes makes of them.
std::string print_json(const Json& json);
/// The same values with each element on a line, as other programs print JSON.
std::string print_lines(const Json& json);
/// The same tokens without any white space.
std::string compact_json(const Json& json);

/// Text of a stranger in a message: at most `bytes` of UTF-8, no character cut in two, and "..." if there was more.
std::string shortened(std::string text, size_t bytes);
/// The same of compact_json, of which no more is made.
std::string shortened_json(const Json& json, size_t bytes);
/// `pointer` with one more step, to the member `name`; a name that is too long for a message is shortened.
std::string pointer_below(const std::string& pointer, const std::string& name);

}  // namespace texbake
