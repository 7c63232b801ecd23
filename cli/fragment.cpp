// texbake fragment: bundle → bundle with fragments.
#include "bake/stages.h"
#include "cli/stage_command.h"
#include "libbake/report/choice_sheets.h"

namespace texbake {
namespace {

Sheet draw_fragments(const Bundle& bundle, const FragmentOptions& options, const Progress& progress) {
  const Scale& scale = bundle.scales.front();
  return fragment_sheet(*scale.colors, scale.base(), options, progress);
}

}  // namespace

Command fragment_command() {
  return stage_command<FragmentOptions>("fragment",
                                        "bundle → bundle: divide the tile into small regions of one color class",
                                        "  texbake fragment leaves.texbundle --threshold 20\n"
                                        "  texbake fragment leaves.texbundle --sheet fragments.png",
                                        run_fragment, draw_fragments);
}

}  // namespace texbake
