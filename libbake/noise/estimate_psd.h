// The noises of a decomposed exemplar: a spectrum, a color space, a histogram and a realization for each mask.
// Based on: Guingo et al. 2017, §3.3 and §6.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libbake/base/options.h"
#include "libbake/base/progress.h"
#include "libbake/base/torus.h"
#include "libbake/color/noise_space.h"
#include "libbake/noise/color_basis.h"
#include "libbake/noise/equalization.h"
#include "libbake/noise/lobes.h"
#include "libbake/noise/spectrum.h"

namespace texbake {

/// The most noises of one exemplar: their masks fit one texel of four channels.
inline constexpr int kMaxNoises = 4;

enum class NoiseHistogram {
  exemplar,  ///< each channel is given the histogram it has in the exemplar
  gaussian,  ///< left as the phases make it
};
template <>
struct EnumNames<NoiseHistogram> {
  static constexpr std::pair<NoiseHistogram, std::string_view> values[] = {{NoiseHistogram::exemplar, "exemplar"},
                                                                           {NoiseHistogram::gaussian, "gaussian"}};
};

struct EstimatePsdOptions {
  std::optional<NoiseSpace> space;  ///< that of decompose; root when not set
  int spectrum_size = 64;           ///< T, a power of two
  SpectrumEstimator estimator = SpectrumEstimator::autocovariance;
  float core_share = 0.9f;
  std::optional<int> local_size;  ///< T_loc of decompose; 8 when not set
  NoiseHistogram histogram = NoiseHistogram::exemplar;
  int tile_size = 512;  ///< a power of two
  int lobes = 3;
  float lobe_error = 0.15f;
  uint32_t seed = 1;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.space, Field{.name = "noise-space",
                            .help = "root: add noise to the square root of light; linear: to light",
                            .auto_help = "the value used by decompose"});
    visit(self.spectrum_size,
          Field{.name = "spectrum-size",
                .unit = "texels",
                .min = 4,
                .max = 256,
                .help = "side T of a spectrum, a power of two; halved if a mask is too small for it"});
    visit(self.estimator, Field{.name = "estimator",
                                .help = "autocovariance: over the whole tile, least error; windows: as in the paper"});
    visit(self.core_share, Field{.name = "core-share",
                                 .min = 0.1,
                                 .max = 1,
                                 .help = "share of a mask that is measured: the texels closest to its mean spectrum"});
    visit(self.local_size, Field{.name = "local-size",
                                 .unit = "texels",
                                 .min = 2,
                                 .max = 16,
                                 .help = "side of the local spectra that decide which texels are close: 2, 4, 8 or 16",
                                 .auto_help = "the value used by decompose"});
    visit(self.histogram,
          Field{.name = "histogram",
                .help = "exemplar: equalize each tile to the exemplar's histogram; gaussian: leave it Gaussian"});
    visit(self.tile_size, Field{.name = "noise-tile",
                                .unit = "texels",
                                .min = 512,
                                .max = 4096,
                                .help = "side of the noise tiles, a power of two; a noise has side x side values"});
    visit(self.lobes,
          Field{.name = "lobes",
                .min = 0,
                .max = 6,
                .help = "number of Gaussian lobes in the compact spectrum of a channel; 0: no compact spectrum"});
    visit(self.lobe_error,
          Field{.name = "lobe-error",
                .min = 0,
                .max = 1,
                .help = "largest relative error of its magnitudes at which a compact spectrum is kept"});
    visit(self.seed, Field{.name = "noise-seed", .min = 0, .max = 4294967295.0, .help = "random seed of the phases"});
  }
};

/// One color channel of a noise, along one axis of its color space.
struct NoiseChannel {
  Image<float> spectrum;      ///< T×T magnitudes, in the noise's space: Σ S² is the variance
  LobeFit lobes;              ///< no lobes where the fit was worse than `lobe_error`; the error is kept
  Equalization equalization;  ///< relative to the mean; used where options.histogram says so
};

/// What was measured of one noise.
struct NoiseFigures {
  int64_t texels = 0;                   ///< of its mask that were measured
  double used_share = 1;                ///< of these, share that the estimator used
  std::array<double, 3> variance = {};  ///< of its channels inside the mask
  std::array<double, 3> excess_kurtosis = {};
  double tile_difference_db = 0;   ///< of the spectrum of the stored tile's first channel to the model's
  double tile_variance_ratio = 1;  ///< of the stored tile's first channel to the model's
};

struct Noise {
  ColorBasis basis;  ///< its mean is the mean of the noise inside the mask
  std::array<NoiseChannel, 3> channels;
  /// Its values, Rec.709 in the noise's space, half-exact, the mean included, equalized where options say so. They
  /// follow one another in reading order: the tile is how they are stored, not a picture of the noise; the lattice says
  /// where they show.
  Image<V3f> tile;
  NoiseFigures figures;

  int spectrum_size() const { return channels[0].spectrum.width(); }
};

struct NoiseModel {
  std::vector<Noise> noises;  ///< one for each mask
  NoiseSpace space = NoiseSpace::root;
  NoiseLattice lattice;               ///< of all of them
  std::vector<std::string> warnings;  ///< fall-backs, in words
};

/// exemplar − structure, both in light and taken into `space`.
Image<V3f> noise_layer(ImageView<const V3f> exemplar, ImageView<const V3f> structure, NoiseSpace space);

/// `exemplar` and `structure` in linear Rec.709, tiles of one size; `masks` as decompose makes them. A mask in which
/// the noise is zero gets a zero spectrum and a zero tile. Throws Error(bad_data) for masks or sizes that do not fit,
/// Error(infeasible) for a mask that is too small for any spectrum.
NoiseModel estimate_psd(ImageView<const V3f> exemplar, ImageView<const V3f> structure,
                        std::span<const Image<float>> masks, const EstimatePsdOptions& options = {},
                        const Progress& progress = {});

/// Σ_k mask_k · noise_k at every texel, without rounding: the noise layer of the exemplar, made again, in its space.
Image<V3f> synthesise_noise(const NoiseModel& model, std::span<const Image<float>> masks);

/// The light of `structure` (light) with that noise.
Image<V3f> synthesise(ImageView<const V3f> structure, const NoiseModel& model, std::span<const Image<float>> masks);

}  // namespace texbake
