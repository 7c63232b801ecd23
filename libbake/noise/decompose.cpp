// Structure and masks at each candidate size, a test synthesis, the choice; then a second pass and the borders.
#include "libbake/noise/decompose.h"

#include <fmt/format.h>

#include <algorithm>

#include "libbake/base/error.h"
#include "libbake/base/half.h"
#include "libbake/noise/sharp_border.h"
#include "libbake/noise/structure.h"
#include "libbake/noise/synthesis_test.h"

namespace texbake {
namespace {

constexpr double kWeakNoise = 1e-4;  // share of the variance below which there is nothing to synthesize
constexpr float kSigma = 0.01f;      // the paper's
constexpr double kLostDirection = 0.02;

/// A structure as the bundle stores it: light, in half floats; a second pass could make it negative.
Image<V3f> stored(Image<V3f>& values, NoiseSpace space) {
  for (V3f& v : values) v = V3f(std::max(v.x, 0.0f), std::max(v.y, 0.0f), std::max(v.z, 0.0f));
  Image<V3f> light = to_light(values, space);
  for (V3f& color : light) color = half_exact(color);
  return light;
}

/// The luminance of `light` in the space in which the layers are told apart.
Image<float> luminance_in(ImageView<const V3f> light, NoiseSpace space) {
  return luminance(in_noise_space(light, space));
}

std::vector<Image<float>> make_masks(ImageView<const V3f> values, const LocalSpectra& spectra,
                                     const DecomposeOptions& options) {
  if (options.noises == 1) {
    std::vector<Image<float>> everywhere;
    everywhere.emplace_back(values.width(), values.height(), 1.0f);
    return everywhere;
  }
  const GrainFeatures features(values, spectra, static_cast<double>(options.color_weight));
  return assign_masks(features, cluster_grain(features, options.noises, options.seed), options.masks);
}

/// structure + noise made again from its spectra.
Image<V3f> synthesis_of(ImageView<const V3f> exemplar, const Image<V3f>& structure,
                        const std::vector<Image<float>>& masks, int local_size, NoiseSpace space) {
  EstimatePsdOptions options;
  options.space = space;
  options.local_size = local_size;
  options.lobes = 0;
  return synthesise(structure, estimate_psd(exemplar, structure, masks, options), masks);
}

SynthesisTest compare(ImageView<const V3f> exemplar, const Image<V3f>& synthesis, int local_size, NoiseSpace space) {
  const Image<float> wanted = luminance_in(exemplar, space);
  const Image<float> made = luminance_in(synthesis, space);
  return {local_size, energy_deviation(wanted, made), mean_coherence(wanted) - mean_coherence(made)};
}

/// BL17 §7: the noise is an exemplar of its own, and what its finer local spectra tell apart is structure. Half the
/// size and half the tolerance: at the first pass's own it would find little more than that did.
Image<V3f> extract_again(ImageView<const V3f> exemplar, const Image<V3f>& structure, int local_size, float sigma,
                         const DecomposeOptions& options) {
  const Image<V3f> noise = noise_layer(exemplar, structure, options.space);
  const Image<float> light = luminance(noise);
  const LocalSpectra spectra(light, std::max(2, local_size / 2));
  Image<V3f> more =
      extract_structure(noise, spectra, {.sigma = static_cast<double>(sigma) / 2.0, .iterations = options.iterations});
  const Image<V3f> found = in_noise_space(structure, options.space);
  for (size_t i = 0; i < more.size(); ++i) more.data()[i] += found.data()[i];
  return stored(more, options.space);
}

/// Structure, masks and synthesis with the sigma that `options` have.
LocalSizeCandidate split(ImageView<const V3f> exemplar, int local_size, const DecomposeOptions& options) {
  const Image<V3f> values = in_noise_space(exemplar, options.space);
  const Image<float> light = luminance(values);
  const LocalSpectra spectra(light, local_size);
  LocalSizeCandidate candidate;
  candidate.sigma = *options.sigma;
  candidate.space = options.space;
  Image<V3f> structure = extract_structure(
      values, spectra, {.sigma = static_cast<double>(candidate.sigma), .iterations = options.iterations});
  candidate.structure = stored(structure, options.space);
  candidate.masks = make_masks(values, options.mask_size ? LocalSpectra(light, *options.mask_size) : spectra, options);
  candidate.synthesis = synthesis_of(exemplar, candidate.structure, candidate.masks, local_size, options.space);
  candidate.test = compare(exemplar, candidate.synthesis, local_size, options.space);
  return candidate;
}

/// Direction that is lost is structure that was taken for grain: then half of the tolerance keeps more of it.
DecomposeOptions with_sigma(ImageView<const V3f> exemplar, const DecomposeOptions& options) {
  DecomposeOptions resolved = options;
  if (options.sigma) return resolved;
  resolved.sigma = kSigma;
  if (split(exemplar, kLocalSizes[0], resolved).test.coherence_drop > kLostDirection) resolved.sigma = kSigma / 2;
  return resolved;
}

double variance_share(ImageView<const V3f> exemplar, const Image<V3f>& structure, NoiseSpace space) {
  const double noise = standard_deviation(luminance(noise_layer(exemplar, structure, space)));
  const double whole = standard_deviation(luminance_in(exemplar, space));
  return noise * noise / (whole * whole);
}

void measure(ImageView<const V3f> exemplar, NoiseSpace space, Decomposition& result) {
  result.noise_share = variance_share(exemplar, result.structure, space);
  for (const Image<float>& mask : result.masks) {
    double sum = 0.0;
    for (const float weight : mask) sum += static_cast<double>(weight);
    result.mask_share.push_back(sum / static_cast<double>(mask.size()));
  }
  if (result.noise_share < kWeakNoise)
    result.warnings.push_back(fmt::format(
        "the noise has only {:.2g} of the exemplar's variance: one layer would be enough", result.noise_share));
  if (result.result.coherence_drop > kStructureInNoise)
    result.warnings.push_back(
        fmt::format("structure is left in the noise: the coherence of the synthesis is {:.3f} below the exemplar's (a "
                    "drop above {:.2f} is visible); {}",
                    result.result.coherence_drop, kStructureInNoise,
                    result.local_size.local_size > 2 ? "a smaller --local-size keeps more of it in the structure"
                                                     : "this exemplar's fine patterns are not random grain"));
}

LocalSizeCandidate chosen_candidate(std::vector<LocalSizeCandidate> candidates, std::optional<int> asked,
                                    Decomposition& result) {
  for (const LocalSizeCandidate& candidate : candidates) result.tested.push_back(candidate.test);
  result.local_size =
      asked ? LocalSizeChoice{*asked, fmt::format("{} texels: asked for", *asked)} : choose_local_size(result.tested);
  return std::move(*std::find_if(candidates.begin(), candidates.end(), [&](const LocalSizeCandidate& candidate) {
    return candidate.test.local_size == result.local_size.local_size;
  }));
}

}  // namespace

void check_decompose(ImageView<const V3f> exemplar, const DecomposeOptions& options) {
  check_options(options);
  const int smallest = options.local_size.value_or(kLocalSizes[0]);
  if (options.sharp_border_px > 0.0f && options.noises == kMaxNoises)
    throw Error(ErrorKind::usage,
                fmt::format("--sharp-border occupies one of the {} masks: expected --noises of at most {}, found {}",
                            kMaxNoises, kMaxNoises - 1, options.noises));
  const Image<float> light = luminance_in(exemplar, options.space);
  for (const int size : {smallest, options.mask_size.value_or(smallest)})
    LocalSpectra(light, size);  // throws when it cannot be made
}

LocalSizeCandidate decompose_at(ImageView<const V3f> exemplar, int local_size, const DecomposeOptions& options) {
  return split(exemplar, local_size, with_sigma(exemplar, options));
}

std::vector<LocalSizeCandidate> local_size_candidates(ImageView<const V3f> exemplar, const DecomposeOptions& options,
                                                      const Progress& progress) {
  check_decompose(exemplar, options);
  const DecomposeOptions resolved = with_sigma(exemplar, options);
  std::vector<LocalSizeCandidate> candidates;
  for (const int size : kLocalSizes) {
    if (std::min(exemplar.width(), exemplar.height()) < 2 * size) break;
    candidates.push_back(split(exemplar, size, resolved));
    report_progress(progress, size / 16.0);  // the largest takes half of the time
  }
  return candidates;
}

Decomposition decompose(ImageView<const V3f> exemplar, const DecomposeOptions& options, const Progress& progress) {
  check_decompose(exemplar, options);
  std::vector<LocalSizeCandidate> candidates;
  if (options.local_size)
    candidates.push_back(decompose_at(exemplar, *options.local_size, options));
  else
    candidates = local_size_candidates(exemplar, options, [&](double done) { report_progress(progress, 0.8 * done); });
  return decompose(exemplar, options, std::move(candidates), progress);
}

Decomposition decompose(ImageView<const V3f> exemplar, const DecomposeOptions& options,
                        std::vector<LocalSizeCandidate> candidates, const Progress& progress) {
  check_decompose(exemplar, options);
  Decomposition result;
  LocalSizeCandidate candidate = chosen_candidate(std::move(candidates), options.local_size, result);
  result.sigma = candidate.sigma;
  result.structure = std::move(candidate.structure);
  result.masks = std::move(candidate.masks);
  result.result = candidate.test;
  report_progress(progress, 0.8);

  if (options.second_pass == SecondPass::automatic && candidate.test.coherence_drop > kStructureInNoise) {
    const int size = result.local_size.local_size;
    result.structure = extract_again(exemplar, result.structure, size, result.sigma, options);
    const Image<V3f> synthesis = synthesis_of(exemplar, result.structure, result.masks, size, options.space);
    result.result = compare(exemplar, synthesis, size, options.space);
    result.second_pass = true;
  }
  if (options.sharp_border_px > 0.0f)
    keep_sharp_borders(exemplar, border_band(result.masks, static_cast<double>(options.sharp_border_px)),
                       result.structure, result.masks);
  measure(exemplar, options.space, result);
  report_progress(progress, 1.0);
  return result;
}

}  // namespace texbake
