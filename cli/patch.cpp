// texbake patch: bundle → bundle with patches.
#include "bake/stages.h"
#include "cli/stage_command.h"

namespace texbake {

Command patch_command() {
  return stage_command<PatchOptions>("patch",
                                     "bundle → bundle: join fragments into the patches that exchange their contents",
                                     "  texbake patch leaves.texbundle --count 12", run_patch);
}

}  // namespace texbake
