// texbake select-contents: bundle → bundle with the contents of its patches.
#include "bake/stages.h"
#include "cli/stage_command.h"
#include "libbake/report/choice_sheets.h"

namespace texbake {
namespace {

Sheet draw_contents(const Bundle& bundle, const SelectContentsOptions& options, const Progress& progress) {
  const Scale& scale = bundle.scales.front();
  return select_contents_sheet(*scale.colors, scale.base(), *scale.patches, options, progress);
}

}  // namespace

Command select_contents_command() {
  return stage_command<SelectContentsOptions>("select-contents", "bundle → bundle: find what may fill each patch",
                                              "  texbake select-contents leaves.texbundle --count 8\n"
                                              "  texbake select-contents bricks.texbundle --lattice auto\n"
                                              "  texbake select-contents leaves.texbundle --sheet contents.png",
                                              run_select_contents, draw_contents);
}

}  // namespace texbake
