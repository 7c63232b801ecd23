// How good a bundle is, beside what a user would pick instead: numbers, verdicts and pictures from one run.
#pragma once

#include <string>
#include <vector>

#include "libbake/base/progress.h"
#include "libbake/report/report_input.h"
#include "libbake/report/report_picture.h"
#include "libbake/report/suitability.h"
#include "libbake/report/verdict.h"

namespace texbake {

/// A measure's standing in the bundle.
struct Judgement {
  Measure measure = Measure::tile_x;
  Limits limits;
  Verdict verdict = Verdict::undefined;
};

/// Whether one map of the material can be tiled: its wrap, judged as the color's.
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
  std::vector<MapReport> maps;                   ///< beside the color, whose wrap is in `methods`
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
