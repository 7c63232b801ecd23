// What a report is made of: a tile, what its stages recorded, and how closely to look.
#pragma once

#include <optional>
#include <vector>

#include "libbake/base/options.h"
#include "libbake/content/pair_impact.h"
#include "libbake/planes/evaluator_input.h"
#include "libbake/segment/contrast.h"

namespace texbake {

struct ReportOptions {
  int seeds = 3;
  int tiles = 6;
  int side_px = 1024;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.seeds,
          Field{.name = "seeds",
                .unit = "renderings",
                .min = 1,
                .max = 64,
                .help = "number of renderings of each method; results are their mean ± standard deviation"});
    visit(self.tiles, Field{.name = "tiles",
                            .unit = "tiles",
                            .min = 2,
                            .max = 32,
                            .help = "number of tiles on each side of a rendering"});
    visit(self.side_px, Field{.name = "side",
                              .unit = "px",
                              .min = 32,
                              .max = 16384,
                              .help = "longest tile side that is measured at full size; larger tiles are measured at a "
                                      "half, a third, ... of their size"});
  }

  /// A preview in a few seconds: one seed, the tile at 256 texels.
  static ReportOptions quick() { return {.seeds = 1, .tiles = 6, .side_px = 256}; }
};

/// What was recorded of a noise layer, over all its noises; nothing for what was not.
struct NoiseSummary {
  std::optional<double> spectrum_db{};       ///< of the drawn noise's spectrum to the estimated one; the worst
  std::optional<double> power_error{};       ///< relative, of its variance; the worst
  std::optional<double> excess_kurtosis{};   ///< of largest magnitude
  std::optional<double> energy_deviation{};  ///< r(T) of decompose
  std::optional<double> coherence_drop{};    ///< of decompose
};

/// What is reported on. Views are borrowed.
struct ReportInput {
  EvaluatorInput tile;
  ImageView<const V3f> exemplar = {};           ///< where the base is a structure; empty: the base itself
  std::optional<NoiseSummary> noise;            ///< nothing without a noise layer
  std::vector<ImageView<const float>> spectra;  ///< of the first channel of each noise, magnitudes
  std::optional<PairImpact> pairs;              ///< as select-contents found it
  std::optional<ContrastReport> contrast;       ///< as fragment found it
};

}  // namespace texbake
