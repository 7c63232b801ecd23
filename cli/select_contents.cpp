// texbake select-contents: bundle → bundle with the contents of its patches.
#include "cli/stage_command.h"
#include "cli/stages.h"

namespace texbake {

Command select_contents_command() {
  return stage_command<SelectContentsOptions>("select-contents", "bundle → bundle: what may fill each patch",
                                              "  texbake select-contents leaves.texbundle --count 8",
                                              run_select_contents);
}

}  // namespace texbake
