// The two stages of structure + noise on a bundle: run one, record it.
#pragma once

#include <string>

#include "bake/listener.h"
#include "formats/bundle.h"
#include "libbake/noise/decompose.h"
#include "libbake/noise/estimate_psd.h"

namespace texbake {

/// Splits the exemplar, and makes the palette again, of the structure, with the options that convert was given. `sheet`
/// names a picture of the choice of the local size, or is "". Errors as those of the stages in stages.h.
void run_decompose(Bundle& bundle, const DecomposeOptions& options, const std::string& sheet, Listener& listener);

/// The local size, where it is not given, is that of decompose.
void run_estimate_psd(Bundle& bundle, const EstimatePsdOptions& options, Listener& listener);

}  // namespace texbake
