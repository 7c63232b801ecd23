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
    "more patches with smaller shapes (patch --count), or a larger choice (select-contents --candidates)";
constexpr const char* kCloseAdvice = "convert with --periodic make, or take a photograph that tiles";
constexpr const char* kSeamAdvice =
    "a softer border (select-contents --soft-border), fewer patches (patch --count), borders along features (fragment "
    "--threshold), or fewer contents (select-contents --count)";
constexpr const char* kNoiseAdvice = "decompose with a smaller --local-size, or --noises for another number of noises";

constexpr MeasureKind kKinds[] = {
    {Measure::tile_x, "tileX", kTile, "Wrap left to right", "",
     "Step across the tile's wrap over a usual step; 1 is unseen.", kCloseAdvice},
    {Measure::tile_y, "tileY", kTile, "Wrap top to bottom", "", "The same from top to bottom.", kCloseAdvice},

    {Measure::repetition_near, "repetitionNear", kRepetition, "Repeats, near", "",
     "Share of all variation that returns with every tile: 1 periodic, 0 ideal, 1/contents at best here.",
     "more contents for each patch: select-contents --count 12"},
    {Measure::repetition_mid, "repetitionMid", kRepetition, "Repeats, middle", "",
     "The same, seen from where 1/64 of the tile is one blur.", ""},
    {Measure::repetition_far, "repetitionFar", kRepetition, "Repeats, far", "",
     "The same from afar, where 1/16 of the tile is one blur: the grid that gives tiling away.",
     "convert --flatten, or a larger choice: select-contents --candidates 240 --count 12"},
    {Measure::amplitude_far, "amplitudeFar", kRepetition, "Grid amplitude, far", "ΔE",
     "How strong that grid is; below 0.7 hardly anybody sees it.",
     "convert --flatten takes out the shading that repeats"},
    {Measure::predicted_near, "predictedNear", kRepetition, "Predicted, near", "",
     "Repetition near, foretold from the contents without drawing.", ""},
    {Measure::predicted_far, "predictedFar", kRepetition, "Predicted, far", "",
     "Repetition far, foretold from the contents without drawing.", ""},

    {Measure::band_finest, "bandFinest", kFidelity, "Amplitude 1/128-1/64", "",
     "Contrast of details of about 1/64 of the tile, over the exemplar's.", kBandAdvice},
    {Measure::band_fine, "bandFine", kFidelity, "Amplitude 1/64-1/32", "",
     "Contrast one octave coarser, over the exemplar's.", kBandAdvice},
    {Measure::band_middle, "bandMiddle", kFidelity, "Amplitude 1/32-1/16", "", "Contrast two octaves coarser.",
     kBandAdvice},
    {Measure::band_coarse, "bandCoarse", kFidelity, "Amplitude 1/16-1/8", "",
     "Contrast of large shapes; low values mean they were washed out.", kBandAdvice},
    {Measure::band_rest, "bandRest", kFidelity, "Amplitude above 1/8", "", "Contrast of what is larger still.",
     kBandAdvice},

    {Measure::seam_auc, "seamAuc", kSeams, "Seam visibility", "",
     "Chance that a seam steps more than the exemplar does at the same place; 0.5 is invisible.", kSeamAdvice},
    {Measure::seam_tail, "seamTail", kSeams, "Strong seams", "",
     "Share of seam texels that step more than 95 % of what stood there before; 0.05 is invisible.", kSeamAdvice},
    {Measure::seam_auc_all, "seamAucAll", kSeams, "Against all neighbours", "",
     "The same against every pair of neighbours; high where borders follow contrast on purpose.", ""},
    {Measure::seam_tail_all, "seamTailAll", kSeams, "Strong, against all", "",
     "Share of seam texels above 95 % of all neighbour steps of the exemplar.", ""},
    {Measure::seam_run, "seamRun", kSeams, "Run of strong seams", "px",
     "Mean length of a connected run of such texels: what the eye catches.", ""},
    {Measure::pair_mean, "pairImpactMean", kSeams, "Impact of pairs, mean", "ΔE⁴",
     "Impact across borders when both sides have changed, over all pairs of contents.", ""},
    {Measure::pair_worst, "pairImpactWorst", kSeams, "Impact of pairs, worst", "ΔE⁴", "The worst pair of contents.",
     ""},

    {Measure::color, "colorDistance", kFidelity, "Colours", "",
     "Distance of the colours' distribution from the exemplar's, in its standard deviations.",
     "select-contents --candidates 240: more to choose from uses the exemplar more evenly"},
    {Measure::spectrum, "spectrumDistance", kFidelity, "Spectrum", "dB",
     "How far grain and shapes of every size and direction are off in strength.",
     "more contents or candidates; noise layers: a smaller --local-size"},
    {Measure::gradient_ratio, "gradientRatio", kFidelity, "Sharpness", "",
     "Mean step between neighbours over the exemplar's: below 1 is blur, above 1 seams.",
     "seams: see there; blur: contents that are turned or shrunk less"},
    {Measure::gradient_distance, "gradientDistance", kFidelity, "Sharpness, all steps", "",
     "Mean difference of the sorted steps, over the exemplar's mean step.", ""},
    {Measure::structure, "structureDistance", kFidelity, "Structure", "",
     "How well small windows are found in the exemplar, over the same for plain tiling; blur flatters it.",
     "borders along features: fragment --threshold; fewer patches"},

    {Measure::noise_spectrum, "noiseSpectrum", kNoise, "Noise spectrum", "dB",
     "Drawn noise against the spectrum that was estimated, the worst noise.", kNoiseAdvice},
    {Measure::noise_power, "noisePower", kNoise, "Noise power", "",
     "Relative error of the drawn noise's variance, the worst noise.", kNoiseAdvice},
    {Measure::noise_kurtosis, "noiseKurtosis", kNoise, "Noise kurtosis", "",
     "Largest excess kurtosis of a noise's channels; 0 is Gaussian, photographs have 0.2 to 2.", ""},
    {Measure::noise_energy, "noiseEnergy", kNoise, "Energy deviation", "",
     "How unevenly the synthesis carries the exemplar's detail: r(T).", ""},
    {Measure::noise_coherence, "noiseCoherence", kNoise, "Coherence drop", "",
     "Direction that the exemplar has and the synthesis lost: structure left in the noise.", kNoiseAdvice},

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
