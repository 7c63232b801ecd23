// texbake estimate-psd: bundle → bundle with the noises of its masks.
#include "bake/layer_stages.h"
#include "cli/stage_command.h"

namespace texbake {

Command estimate_psd_command() {
  return stage_command<EstimatePsdOptions>(
      "estimate-psd", "bundle → bundle: estimate the spectra and colors of the noises, and bake their tiles",
      "  texbake estimate-psd rock.texbundle --spectrum-size 128", run_estimate_psd);
}

}  // namespace texbake
