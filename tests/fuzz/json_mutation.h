// Changes of JSON that leave it JSON: most of what a reader of bytes refuses at once is not worth a run.
#pragma once

#include <string>

#include "formats/issues.h"
#include "libbake/base/random.h"

namespace texbake::fuzz {

/// One to three values replaced, removed, doubled, exchanged, wrapped or moved.
void mutate_json(Json& json, Random& random);

/// The same of a text; now and then its bytes instead, and always where it is not JSON.
std::string mutate_json_text(const std::string& text, Random& random);

}  // namespace texbake::fuzz
