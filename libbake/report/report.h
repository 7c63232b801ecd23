// How good a bundle is, beside what a user would pick instead: numbers, verdicts and pictures from one run.
#pragma once

#include <string>
#include <vector>

#include "libbake/base/options.h"
#include "libbake/base/progress.h"
#include "libbake/content/pair_impact.h"
#include "libbake/eval/prepare.h"
#include "libbake/report/report_picture.h"
#include "libbake/report/suitability.h"
#include "libbake/report/verdict.h"

namespace texbake {

struct ReportOptions {
  int seeds = 3;
  int tiles = 6;
  int side_px = 1024;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.seeds, Field{.name = "seeds",
                            .unit = "renderings",
                            .min = 1,
                            .max = 64,
                            .help = "of every method; numbers are their mean ± standard deviation"});
    visit(self.tiles,
          Field{.name = "tiles", .unit = "tiles", .min = 2, .max = 32, .help = "on each side of a rendering"});
    visit(self.side_px, Field{.name = "side",
                              .unit = "px",
                              .min = 32,
                              .max = 16384,
                              .help = "a tile with a longer side is measured at half of its size, a third, ..."});
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

/// A measure's standing in the bundle.
struct Judgement {
  Measure measure = Measure::tile_x;
  Limits limits;
  Verdict verdict = Verdict::undefined;
};

/// Whether one map of the material can be tiled: its wrap, judged as the colour's.
struct MapReport {
  std::string name;
  double tile_x = 1;
  double tile_y = 1;
  Verdict verdict = Verdict::undefined;
};

struct Report {
  V2i tile_px{0, 0};
  int reduction = 1;       ///< measured at 1/reduction of the tile's size
  int seam_reduction = 1;  ///< the same for seams, which only show at full size
  ReportOptions options;
  int patch_count = 0;
  int content_count = 0;  ///< N_t; 0 without contents

  std::array<MeasureRow, kMethodCount> methods;  ///< by Method
  MeasureRow floor;                              ///< between the exemplar's halves
  std::vector<MapReport> maps;                   ///< beside the colour, whose wrap is in `methods`
  std::vector<Judgement> judgements;             ///< in the order of the measures
  Suitability suitability;
  Verdict verdict = Verdict::undefined;  ///< the worst of the judgements and the maps'
  std::vector<ReportPicture> pictures;

  const MeasureRow& of(Method method) const { return methods[static_cast<size_t>(method)]; }
  bool is_suitable() const { return verdict <= Verdict::warn || suitability.fits(); }
};

/// Throws Error(usage) for options out of range.
Report report(const ReportInput& input, const ReportOptions& options = {}, const Progress& progress = {});

}  // namespace texbake
