// texbake fragment: bundle → bundle with fragments.
#include "cli/stage_command.h"
#include "cli/stages.h"

namespace texbake {

Command fragment_command() {
  return stage_command<FragmentOptions>("fragment", "bundle → bundle: small regions of one colour class",
                                        "  texbake fragment leaves.texbundle --threshold 20", run_fragment);
}

}  // namespace texbake
