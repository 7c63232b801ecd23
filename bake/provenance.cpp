#include "bake/provenance.h"

#include <algorithm>
#include <iterator>

namespace texbake {
namespace {

/// The stages that read what `verb` makes, directly or not, in order. None for a verb outside the chain.
std::vector<std::string> derived_stages(const std::string& verb) {
  // Spectra are measured on what decompose found; fragments and what follows do not read them.
  if (verb == "estimate-psd") return {};
  const auto position = std::find(std::begin(kStageOrder), std::end(kStageOrder), verb);
  if (position == std::end(kStageOrder)) return {};
  return {std::next(position), std::end(kStageOrder)};
}

void drop_result(Bundle& bundle, const std::string& verb) {
  if (verb == "estimate-psd") bundle.noise.reset();
  for (Scale& scale : bundle.scales) {
    if (verb == "decompose") {
      scale.structure.reset();
      scale.masks.clear();
    }
    if (verb == "fragment") scale.fragments.reset();
    if (verb == "patch") scale.patches.reset();
    if (verb == "select-contents") {
      scale.contents.reset();
      scale.soft_border_px = 0;
    }
  }
}

/// Returns whether there was a record of `verb`.
bool drop_record(Bundle& bundle, const std::string& verb) {
  return std::erase_if(bundle.stages, [&](const Stage& stage) { return stage.verb == verb; }) > 0;
}

}  // namespace

std::vector<std::string> drop_stage(Bundle& bundle, const std::string& verb) {
  drop_result(bundle, verb);
  drop_record(bundle, verb);
  std::vector<std::string> dropped;
  for (const std::string& derived : derived_stages(verb)) {
    drop_result(bundle, derived);
    if (drop_record(bundle, derived)) dropped.push_back(derived);
  }
  return dropped;
}

const Stage* find_stage(const Bundle& bundle, const std::string& verb) {
  const auto found =
      std::find_if(bundle.stages.begin(), bundle.stages.end(), [&](const Stage& stage) { return stage.verb == verb; });
  return found == bundle.stages.end() ? nullptr : &*found;
}

}  // namespace texbake
