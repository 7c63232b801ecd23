// The report as one HTML file: pictures inside, no script, nothing from a network, readable in dark and light.
#pragma once

#include <string>

#include "libbake/color/palette.h"
#include "libbake/report/report.h"

namespace texbake {

/// `name` is the bundle's; `palette` its dominant colors, or nullptr.
std::string report_page(const Report& report, const std::string& name, const Palette* palette);

/// "0.123 ± 0.004 dB", "not defined here". Three digits.
std::string measured_text(const Measured& measured);

/// One sentence on what the verdict means.
std::string verdict_sentence(const Report& report);

}  // namespace texbake
