#include "libbake/report/measures.h"

namespace texbake {
namespace {

constexpr const char* kTile = "Tile";
constexpr const char* kRepetition = "Repetition";
constexpr const char* kSeams = "Seams";
constexpr const char* kFidelity = "Fidelity";
constexpr const char* kNoise = "Noise";
constexpr const char* kCost = "Cost";

constexpr const char* kBandAdvice =
    "more patches with smaller shapes (patch --count), or more candidates to choose from (select-contents "
    "--candidates)";
constexpr const char* kCloseAdvice = "convert --periodic make, or a photograph that tiles";
constexpr const char* kSeamAdvice =
    "softer borders (select-contents --soft-border), fewer patches (patch --count), borders along features (fragment "
    "--threshold), or fewer contents (select-contents --count)";
constexpr const char* kNoiseAdvice = "decompose with a smaller --local-size, or with another number of --noises";

constexpr MeasureKind kKinds[] = {
    {Measure::tile_x, "tileX", kTile, "Wrap seam, left to right", "",
     "Step across the tile's wrap seam relative to an ordinary step; 1 is invisible.", kCloseAdvice},
    {Measure::tile_y, "tileY", kTile, "Wrap seam, top to bottom", "", "The same, from top to bottom.", kCloseAdvice},

    {Measure::repetition_near, "repetitionNear", kRepetition, "Repetition, near", "",
     "Share of all variation that recurs with every tile: 1 is periodic, 0 ideal; the best possible here is "
     "1/contents.",
     "more contents for each patch: select-contents --count 12"},
    {Measure::repetition_mid, "repetitionMid", kRepetition, "Repetition, middle", "",
     "The same from a distance at which 1/64 of the tile blurs into one.", ""},
    {Measure::repetition_far, "repetitionFar", kRepetition, "Repetition, far", "",
     "The same from farther away, where 1/16 of the tile blurs into one: the grid that reveals tiling.",
     "convert --flatten, or a larger choice: select-contents --candidates 240 --count 12"},
    {Measure::amplitude_far, "amplitudeFar", kRepetition, "Grid amplitude, far", "ΔE",
     "Contrast of that grid; below 0.7 hardly anyone sees it.",
     "convert --flatten, which removes the shading that repeats"},
    {Measure::predicted_near, "predictedNear", kRepetition, "Predicted, near", "",
     "Repetition near, predicted from the contents without rendering.", ""},
    {Measure::predicted_far, "predictedFar", kRepetition, "Predicted, far", "",
     "Repetition far, predicted from the contents without rendering.", ""},

    {Measure::band_finest, "bandFinest", kFidelity, "Amplitude 1/128-1/64", "",
     "Contrast of details of about 1/64 of the tile, relative to the exemplar's.", kBandAdvice},
    {Measure::band_fine, "bandFine", kFidelity, "Amplitude 1/64-1/32", "",
     "Contrast one octave coarser, relative to the exemplar's.", kBandAdvice},
    {Measure::band_middle, "bandMiddle", kFidelity, "Amplitude 1/32-1/16", "", "Contrast two octaves coarser.",
     kBandAdvice},
    {Measure::band_coarse, "bandCoarse", kFidelity, "Amplitude 1/16-1/8", "",
     "Contrast of large shapes; low values mean that they were washed out.", kBandAdvice},
    {Measure::band_rest, "bandRest", kFidelity, "Amplitude above 1/8", "", "Contrast of anything larger.", kBandAdvice},

    {Measure::seam_auc, "seamAuc", kSeams, "Seam visibility", "",
     "Probability that a seam steps more than the exemplar does at the same place; 0.5 is invisible.", kSeamAdvice},
    {Measure::seam_tail, "seamTail", kSeams, "Strong seams", "",
     "Share of seam texels that step more than 95 % of the original steps there; 0.05 is invisible.", kSeamAdvice},
    {Measure::seam_auc_all, "seamAucAll", kSeams, "Against all neighbors", "",
     "The same, compared with every pair of neighbors; high if borders follow contrast on purpose.", ""},
    {Measure::seam_tail_all, "seamTailAll", kSeams, "Strong, against all", "",
     "Share of seam texels that step more than 95 % of all neighbor steps of the exemplar.", ""},
    {Measure::seam_run, "seamRun", kSeams, "Run of strong seams", "px",
     "Mean length of a connected run of such texels: what catches the eye.", ""},
    {Measure::pair_mean, "pairImpactMean", kSeams, "Pair impact, mean", "ΔE⁴",
     "Visual impact across borders whose contents have changed on both sides, over all pairs of contents.", ""},
    {Measure::pair_worst, "pairImpactWorst", kSeams, "Pair impact, worst", "ΔE⁴", "The worst pair of contents.", ""},

    {Measure::color, "colorDistance", kFidelity, "Colors", "",
     "Distance between the color distributions of rendering and exemplar, in the exemplar's standard deviations.",
     "select-contents --candidates 240, which lets the choice use the exemplar more evenly"},
    {Measure::spectrum, "spectrumDistance", kFidelity, "Spectrum", "dB",
     "How far the strength of grain and shapes deviates, over all sizes and directions.",
     "more contents or candidates; with noise layers, a smaller --local-size"},
    {Measure::gradient_ratio, "gradientRatio", kFidelity, "Sharpness", "",
     "Mean step between neighbors relative to the exemplar's: below 1 is blur, above 1 means seams.",
     "against seams, see Seams; against blur, contents that are rotated or scaled less"},
    {Measure::gradient_distance, "gradientDistance", kFidelity, "Sharpness, all steps", "",
     "Mean difference of the sorted steps, relative to the exemplar's mean step.", ""},
    {Measure::structure, "structureDistance", kFidelity, "Structure", "",
     "How well small windows can be found in the exemplar, relative to plain tiling; blur flatters it.",
     "borders along features (fragment --threshold), or fewer patches (patch --count)"},

    {Measure::noise_spectrum, "noiseSpectrum", kNoise, "Noise spectrum", "dB",
     "Rendered noise compared with the estimated spectrum, for the worst noise.", kNoiseAdvice},
    {Measure::noise_power, "noisePower", kNoise, "Noise power", "",
     "Relative error of the rendered noise's variance, for the worst noise.", kNoiseAdvice},
    {Measure::noise_kurtosis, "noiseKurtosis", kNoise, "Noise kurtosis", "",
     "Largest excess kurtosis among a noise's channels; 0 is Gaussian, photographs have 0.2 to 2.", ""},
    {Measure::noise_energy, "noiseEnergy", kNoise, "Energy deviation", "",
     "How unevenly the synthesis reproduces the exemplar's detail: r(T).", ""},
    {Measure::noise_coherence, "noiseCoherence", kNoise, "Coherence drop", "",
     "Directional structure that the exemplar has and the synthesis lost: structure left in the noise.", kNoiseAdvice},

    {Measure::fetches, "fetches", kCost, "Texture fetches", "per texel",
     "At the finest level, for all maps of the material.", ""},
    {Measure::gpu_bytes, "gpuBytes", kCost, "GPU memory", "MiB", "Textures and tables, without mip levels.", ""},
};
static_assert(std::size(kKinds) == kMeasureCount);

constexpr bool in_order() {
  for (size_t i = 0; i < std::size(kKinds); ++i)
    if (static_cast<size_t>(kKinds[i].measure) != i) return false;
  return true;
}
static_assert(in_order());

}  // namespace

std::span<const MeasureKind> measure_kinds() { return kKinds; }

}  // namespace texbake
