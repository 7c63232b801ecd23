// Splits an exemplar into structure and noise, and finds where each of a few noises lives.
// Based on: Guingo et al. 2017, eq. 6, §3.3 (masks), §5 (structure), §6 (color, sharp borders), §7 (second pass).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libbake/base/options.h"
#include "libbake/base/progress.h"
#include "libbake/base/torus.h"
#include "libbake/noise/estimate_psd.h"
#include "libbake/noise/local_size.h"
#include "libbake/noise/masks.h"

namespace texbake {

enum class SecondPass {
  automatic,  ///< where the coherence test finds structure in the noise
  never,
};
template <>
struct EnumNames<SecondPass> {
  static constexpr std::pair<SecondPass, std::string_view> values[] = {{SecondPass::automatic, "auto"},
                                                                       {SecondPass::never, "never"}};
};

struct DecomposeOptions {
  NoiseSpace space = NoiseSpace::root;
  int noises = 3;                 ///< K
  std::optional<int> local_size;  ///< T_loc
  MaskKind masks = MaskKind::binary;
  std::optional<int> mask_size;  ///< T_loc of the spectra that masks are made from
  float color_weight = 1.0f;
  float sharp_border_px = 0.0f;
  SecondPass second_pass = SecondPass::automatic;
  std::optional<float> sigma;
  int iterations = 5;
  uint32_t seed = 1;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(
        self.space,
        Field{
            .name = "noise-space",
            .help =
                "root: separate the layers in the square root of light, and add noise to it; linear: in light itself"});
    visit(self.noises, Field{.name = "noises",
                             .min = 1,
                             .max = kMaxNoises,
                             .help = "number of noises (K): random patterns that the eye tells apart"});
    visit(self.local_size,
          Field{.name = "local-size",
                .unit = "texels",
                .min = 2,
                .max = 16,
                .help = "side of the local spectra: 2, 4, 8 or 16; a larger side moves more into the noise",
                .auto_help = "the largest side whose synthesis still resembles the exemplar"});
    visit(self.masks, Field{.name = "masks", .help = "binary: sharp transitions between noises; soft: blends"});
    visit(self.mask_size, Field{.name = "mask-size",
                                .unit = "texels",
                                .min = 2,
                                .max = 16,
                                .help = "side of the local spectra for the masks: 2, 4, 8 or 16; small sides give "
                                        "exact borders, large ones separate noises that differ little",
                                .auto_help = "the value of --local-size"});
    visit(self.color_weight,
          Field{.name = "mask-color-weight",
                .min = 0,
                .max = 100,
                .help = "variance of the color relative to that of the spectra when the masks are found"});
    visit(self.sharp_border_px, Field{.name = "sharp-border",
                                      .unit = "px",
                                      .min = 0,
                                      .max = 32,
                                      .help = "half width of the band along mask borders that stays in the structure"});
    visit(
        self.second_pass,
        Field{.name = "second-pass",
              .help = "auto: extract structure from the noise a second time if some was left there; never: once only"});
    visit(self.sigma,
          Field{.name = "structure-sigma",
                .min = 1e-4,
                .max = 1,
                .help =
                    "how different two local spectra may be to count as alike, in 10 standard deviations of luminance",
                .auto_help = "0.01, as in the paper; half of it if that would take structure for noise"});
    visit(self.iterations, Field{.name = "structure-iterations",
                                 .min = 1,
                                 .max = 50,
                                 .help = "number of times that the structure is filtered"});
    visit(self.seed,
          Field{.name = "mask-seed", .min = 0, .max = 4294967295.0, .help = "random seed of the clustering"});
  }
};

/// The decomposition at one T_loc, for the choice by eye of BL17 Fig. 14.
struct LocalSizeCandidate {
  float sigma = 0;
  NoiseSpace space = NoiseSpace::root;
  Image<V3f> structure;  ///< light
  std::vector<Image<float>> masks;
  Image<V3f> synthesis;  ///< light: structure + noise made again
  SynthesisTest test;
};

struct Decomposition {
  Image<V3f> structure;             ///< light, half-exact, ≥ 0; noise_layer() is what the exemplar has beside it
  std::vector<Image<float>> masks;  ///< K, and one more with sharp borders; see masks.h
  LocalSizeChoice local_size;
  float sigma = 0;                    ///< that was used
  std::vector<SynthesisTest> tested;  ///< every T_loc that was tried, by rising size; first pass
  SynthesisTest result;               ///< of the last pass, before sharp borders
  bool second_pass = false;           ///< whether it ran
  double noise_share = 0;             ///< variance of the noise's luminance / the exemplar's
  std::vector<double> mask_share;     ///< mean of each mask
  std::vector<std::string> warnings;
};

/// `options` as they apply to this exemplar: throws Error(usage) for values out of range and for combinations that do
/// not fit, Error(infeasible) for an exemplar without luminance contrast or smaller than 2 · local size.
void check_decompose(ImageView<const V3f> exemplar, const DecomposeOptions& options);

/// One T_loc, first pass, without sharp borders. Where sigma is not set it is 0.01, or half of it where at 0.01 and the
/// smallest T_loc the coherence of the synthesis drops by more than 0.02 below the exemplar's: 0.02 to 0.04 in bark,
/// rust, moss and leaves, 0.02 at most in grass, sand and known Gaussian fields.
LocalSizeCandidate decompose_at(ImageView<const V3f> exemplar, int local_size, const DecomposeOptions& options);

/// All sizes that fit the exemplar, by rising size, at one sigma.
std::vector<LocalSizeCandidate> local_size_candidates(ImageView<const V3f> exemplar, const DecomposeOptions& options,
                                                      const Progress& progress = {});

/// `exemplar`: a tile in linear Rec.709, half-exact. Errors as check_decompose, and Error(infeasible) when there are
/// fewer distinct local spectra than noises or a mask is too small for a spectrum.
Decomposition decompose(ImageView<const V3f> exemplar, const DecomposeOptions& options = {},
                        const Progress& progress = {});

/// The same from candidates that local_size_candidates made with these options; where `options.local_size` is set, its
/// candidate is taken.
Decomposition decompose(ImageView<const V3f> exemplar, const DecomposeOptions& options,
                        std::vector<LocalSizeCandidate> candidates, const Progress& progress = {});

}  // namespace texbake
