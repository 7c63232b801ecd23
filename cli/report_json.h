// A report as JSON; specified by the definition "report" of cli/output.schema.json.
#pragma once

#include "formats/bundle.h"
#include "libbake/report/report.h"

namespace texbake {

Json report_json(const Report& report, const std::string& bundle, const std::string& page);

}  // namespace texbake
