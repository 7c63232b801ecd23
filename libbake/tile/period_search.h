// Where to close an axis of an exemplar: the period at which it meets itself best.
#pragma once

#include <optional>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// How much a strip of `overlap` columns of `luv` (CIELUV) from `begin` differs from the strip `period` columns further
/// on: d² / (5 ΔE + the mean of both gradients), because a step is seen less where the picture changes anyway.
Image<float> overlap_mismatch(ImageView<const V3f> luv, int begin, int period, int overlap);

struct PeriodOptions {
  int multiple = 1;            ///< the period is a multiple of this unless another closes much better
  std::optional<int> overlap;  ///< fixed, or the whole rest beside the period
};

struct Period {
  int length = 0;
  int overlap = 0;
  double cost = 0;  ///< of the best open cut, per row
};

/// The period along x that weighs the error of the best cut against the length lost. At least half of the width; the
/// overlap is at least a sixteenth of the width and 4. `multiple` must have a multiple in that range.
Period best_period(ImageView<const V3f> luv, const PeriodOptions& options);

/// The greatest of multiple, multiple / 2, multiple / 4, … (down to an odd number, then 1) that has a multiple in
/// least … greatest.
int multiple_within(int multiple, int least, int greatest);
/// The range of periods that `best_period` looks at.
struct PeriodRange {
  int least = 0;
  int greatest = 0;
};
PeriodRange period_range(int width, std::optional<int> overlap);

}  // namespace texbake
