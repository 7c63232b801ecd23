#include "bake/layer_stages.h"

#include "bake/provenance.h"
#include "bake/running_stage.h"
#include "bake/stage_parts.h"
#include "formats/image_writer.h"
#include "libbake/color/convert.h"
#include "libbake/noise/choice_sheet.h"

namespace texbake {
namespace {

/// The palette of `light`, with the options that convert was given, so that it is made as convert would make it.
Conversion palette_of(const Bundle& bundle, ImageView<const V3f> light) {
  ConvertOptions options;
  if (const Stage* stage = find_stage(bundle, "convert"))
    JsonReader(asked_parameters(stage->parameters), "stages.convert").read(options);
  const std::optional<Image<float>>& height = bundle.scales.front().height;
  return convert(light, height ? height->view() : ImageView<const float>(), options);
}

void check_exemplar(const Scale& scale) {
  if (!scale.stores_exemplar)
    throw Error(ErrorKind::bad_data,
                "expected a bundle with the exemplar, found the compact form without it (convert --color palette), in "
                "which the noise is lost; convert again with --color full");
}

Json test_json(const SynthesisTest& test) {
  return {{"localSize", test.local_size},
          {"energyDeviation", test.energy_deviation},
          {"coherenceDrop", test.coherence_drop}};
}

Json decompose_figures(const Decomposition& result, const Conversion& palette) {
  Json tested = Json::array();
  for (const SynthesisTest& test : result.tested) tested.push_back(test_json(test));
  return {{"localSizeReason", result.local_size.reason},
          {"tested", tested},
          {"result", test_json(result.result)},
          {"secondPass", result.second_pass},
          {"noiseShare", result.noise_share},
          {"maskShares", result.mask_share},
          {"classes", palette.colors.palette.classes.size()},
          {"meanDeltaE", palette.error.mean_delta_e},
          {"p99DeltaE", palette.error.p99_delta_e}};
}

Decomposition decomposed(const Image<V3f>& exemplar, const DecomposeOptions& options, const std::string& sheet,
                         const Progress& progress) {
  if (sheet.empty()) return decompose(exemplar, options, progress);
  std::vector<LocalSizeCandidate> candidates = local_size_candidates(exemplar, options, progress);
  std::vector<SynthesisTest> tested;
  for (const LocalSizeCandidate& candidate : candidates) tested.push_back(candidate.test);
  const int chosen = options.local_size.value_or(choose_local_size(tested).local_size);
  write_picture(sheet, choice_sheet(exemplar, candidates, chosen), PictureRole::color);
  return decompose(exemplar, options, std::move(candidates), progress);
}

/// The T_loc that decompose used, where its record says so.
std::optional<int> local_size_of(const Bundle& bundle) {
  const Stage* decompose = find_stage(bundle, "decompose");
  const Json size = decompose ? decompose->parameters.value("local-size", Json()) : Json();
  return size.is_number_integer() ? std::optional<int>(size.get<int>()) : std::nullopt;
}

/// The space in which decompose told the layers apart, where its record says so.
std::optional<NoiseSpace> space_of(const Bundle& bundle) {
  const Stage* decompose = find_stage(bundle, "decompose");
  const Json space = decompose ? decompose->parameters.value("noise-space", Json()) : Json();
  return space.is_string() ? enum_value<NoiseSpace>(space.get<std::string>()) : std::nullopt;
}

Json noise_figures(const Noise& noise) {
  Json errors = Json::array();
  for (const NoiseChannel& channel : noise.channels) errors.push_back(channel.lobes.error);
  const NoiseFigures& figures = noise.figures;
  return {{"texels", figures.texels},
          {"usedShare", figures.used_share},
          {"spectrumSize", noise.spectrum_size()},
          {"variance", figures.variance},
          {"excessKurtosis", figures.excess_kurtosis},
          {"lobeError", errors},
          {"tileDifferenceDb", figures.tile_difference_db},
          {"tileVarianceRatio", figures.tile_variance_ratio}};
}

}  // namespace

void run_decompose(Bundle& bundle, const DecomposeOptions& options, const std::string& sheet, Listener& listener) {
  Scale& scale = only_scale(bundle);
  check_exemplar(scale);
  RunningStage stage(bundle, "decompose", listener);
  Decomposition result = decomposed(scale.exemplar, options, sheet, stage.progress());
  Conversion palette = palette_of(bundle, result.structure);
  stage.replace();
  scale.structure = std::move(result.structure);
  scale.masks = std::move(result.masks);
  DecomposeOptions effective = options;
  effective.local_size = result.local_size.local_size;
  effective.sigma = result.sigma;
  effective.mask_size = options.mask_size.value_or(result.local_size.local_size);
  const Json figures = decompose_figures(result, palette);
  scale.colors = std::move(palette.colors);
  stage.finish(parameters_of(options, effective), figures);
  listener.note("decompose: local size " + result.local_size.reason);
  for (const std::string& warning : result.warnings) listener.warning("decompose: " + warning);
}

void run_estimate_psd(Bundle& bundle, const EstimatePsdOptions& options, Listener& listener) {
  Scale& scale = only_scale(bundle);
  required(scale.structure, "a structure", "decompose");
  RunningStage stage(bundle, "estimate-psd", listener);
  EstimatePsdOptions effective = options;
  if (!options.local_size) effective.local_size = local_size_of(bundle);
  if (!options.space) effective.space = space_of(bundle).value_or(NoiseSpace::root);
  NoiseModel model = estimate_psd(scale.exemplar, *scale.structure, scale.masks, effective, stage.progress());
  stage.replace();
  bundle.noise = std::move(model);
  Json noises = Json::array();
  for (const Noise& noise : bundle.noise->noises) noises.push_back(noise_figures(noise));
  stage.finish(parameters_of(options, effective), {{"noises", noises}});
  for (const std::string& warning : bundle.noise->warnings) listener.warning("estimate-psd: " + warning);
}

}  // namespace texbake
