// What a report is made of, out of a bundle: the tile as it is drawn, and what its stages recorded.
#pragma once

#include "formats/bundle.h"
#include "libbake/report/report_input.h"

namespace texbake {

/// Views into `bundle`, which must outlive them. What a stage has not recorded is absent.
ReportInput report_input(const Bundle& bundle);

}  // namespace texbake
