// The JSON Schema of bundle.json, formats/bundle.schema.json, compiled into the program.
#pragma once

#include <string_view>

#include "formats/issues.h"

namespace texbake {

/// The text of formats/bundle.schema.json, draft 7.
std::string_view bundle_schema();

/// Reports schema_violation with the JSON pointer of each member of `manifest` that the schema does not allow.
void check_schema(const Json& manifest, IssueLog& log);

}  // namespace texbake
