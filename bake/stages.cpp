#include "bake/stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "bake/running_stage.h"
#include "bake/stage_parts.h"
#include "libbake/planes/prepare.h"
#include "libbake/segment/contrast.h"

namespace texbake {
namespace {

Json area_figures(const Partition& partition) {
  const auto& areas = partition.areas_px;
  const auto [least, most] = std::minmax_element(areas.begin(), areas.end());
  const auto total = std::accumulate(areas.begin(), areas.end(), uint64_t{0});
  return {{"count", partition.count()},
          {"minArea", *least},
          {"meanArea", static_cast<double>(total) / static_cast<double>(areas.size())},
          {"maxArea", *most}};
}

Json contrast_figures(const ContrastReport& contrast) {
  return {{"borderDeltaE", contrast.border_delta_e},
          {"interiorDeltaE", contrast.interior_delta_e},
          {"sizeLimitedShare", contrast.size_limited_share}};
}

void warn_of_low_contrast(const ContrastReport& contrast, Listener& listener) {
  const auto reason = low_contrast(contrast);
  if (!reason) return;
  listener.warning(
      *reason == LowContrast::faint_borders
          ? fmt::format("low contrast: colors differ by only {:.1f} ΔE across fragment borders ({:.1f} inside), too "
                        "little to hide the seams of exchanged contents; an exemplar with clearer features is better",
                        contrast.border_delta_e, contrast.interior_delta_e)
          : fmt::format("low contrast: {:.0f} % of the tile is in fragments that ended at the maximum area, not at a "
                        "border, so that seams have nothing to hide behind; an exemplar with clearer features, or a "
                        "smaller --threshold, is better",
                        100 * contrast.size_limited_share));
}

Json content_figures(const SelectContentsFigures& figures) {
  return {{"contentClasses", figures.content_classes},
          {"saliencyThreshold", figures.saliency_threshold},
          {"salientShare", figures.salient_share},
          {"bestImpact", figures.best_impact},
          {"meanImpact", figures.mean_impact},
          {"worstImpact", figures.worst_impact},
          {"meanPairImpact", figures.mean_pair_impact},
          {"worstPairImpact", figures.worst_pair_impact},
          {"repetitionNear", figures.repetition_near},
          {"repetitionFar", figures.repetition_far},
          {"useDeviation", figures.use_deviation},
          {"computedShare", figures.computed_share},
          {"latticeCorrelation", figures.lattice_correlation}};
}

void check_soft_border(int width_px, V2i tile_size) {
  const int widest = max_soft_border_px(tile_size);
  if (width_px > widest)
    throw Error(ErrorKind::infeasible,
                fmt::format("--soft-border: expected at most {} px, an eighth of the tile of {} x {}, found {}", widest,
                            tile_size.x, tile_size.y, width_px));
}

}  // namespace

void run_fragment(Bundle& bundle, const FragmentOptions& options, Listener& listener) {
  Scale& scale = only_scale(bundle);
  const PrincipalVariation& colors = required(scale.colors, "a palette", "convert");
  RunningStage stage(bundle, "fragment", listener);
  const FragmentOptions resolved = resolve(options, colors);
  FragmentMap fragments = fragment(colors, scale.base(), resolved, stage.progress());
  const ContrastReport contrast = contrast_report(scale.base(), fragments, *resolved.max_area_px);
  stage.replace();
  scale.fragments = std::move(fragments);
  Json figures = area_figures(scale.fragments->partition);
  figures.update(contrast_figures(contrast));
  stage.finish(parameters_of(options, resolved), figures);
  warn_of_low_contrast(contrast, listener);
}

void run_patch(Bundle& bundle, const PatchOptions& options, Listener& listener) {
  Scale& scale = only_scale(bundle);
  const FragmentMap& fragments = required(scale.fragments, "fragments", "fragment");
  RunningStage stage(bundle, "patch", listener);
  const PatchOptions resolved = resolve(options, fragments);
  PatchMap patches = patch(fragments, scale.base(), resolved, stage.progress());
  stage.replace();
  scale.patches = std::move(patches);
  stage.finish(parameters_of(options, resolved), area_figures(scale.patches->partition));
}

void run_select_contents(Bundle& bundle, const SelectContentsOptions& options, Listener& listener) {
  Scale& scale = only_scale(bundle);
  const PrincipalVariation& colors = required(scale.colors, "a palette", "convert");
  const PatchMap& patches = required(scale.patches, "patches", "patch");
  check_soft_border(options.soft_border_px.value_or(0), scale.size());
  RunningStage stage(bundle, "select-contents", listener);
  const bool may_deform = options.search != Search::exact && options.lattice == LatticeUse::never;
  const SelectContentsOptions suited = scale.structure && may_deform ? deforming(options) : options;
  ContentSelection selection = select_contents(colors, scale.base(), patches, suited, stage.progress());
  stage.replace();
  scale.contents = std::move(selection.table);
  scale.soft_border_px = *selection.effective.soft_border_px;
  stage.finish(parameters_of(options, selection.effective), content_figures(selection.figures));
}

}  // namespace texbake
