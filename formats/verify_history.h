// Checks of what a bundle says about its own making.
#pragma once

#include "formats/bundle_io.h"

namespace texbake {

/// What each stage wrote is what the bundle holds, and what it read is there still. Takes the scales and the
/// noise out of the manifest.
void check_state(LoadedBundle& loaded, IssueLog& log);
/// Every plane and table has a stage that makes it.
void check_stages(const Bundle& bundle, IssueLog& log);
/// Recorded figures of `scale` agree with what can be counted in it.
void check_figures(const Bundle& bundle, size_t scale, IssueLog& log);
/// Recorded figures are numbers.
void check_nulls(const Bundle& bundle, IssueLog& log);

}  // namespace texbake
