// Whether a number is good. The limits are engineering choices, made on photographs by these numbers and by looking;
// they are no perceptual study.
#pragma once

#include <limits>
#include <vector>

#include "libbake/report/measures.h"

namespace texbake {

/// From good to bad. What could not be measured is never good.
enum class Verdict { pass, warn, undefined, fail };
template <>
struct EnumNames<Verdict> {
  static constexpr std::pair<Verdict, std::string_view> values[] = {
      {Verdict::pass, "pass"}, {Verdict::warn, "warn"}, {Verdict::undefined, "not-defined"}, {Verdict::fail, "fail"}};
};

/// Inclusive: good between `pass_low` and `pass_high`, doubtful between `warn_low` and `warn_high`, else bad.
struct Limits {
  double pass_low = -std::numeric_limits<double>::infinity();
  double pass_high = std::numeric_limits<double>::infinity();
  double warn_low = -std::numeric_limits<double>::infinity();
  double warn_high = std::numeric_limits<double>::infinity();
};

/// The limits of `measure` for a bundle of `content_count` contents for each patch and such borders; nothing for what
/// is only printed. Soft borders must hide seams better.
std::optional<Limits> limits_of(Measure measure, int content_count, int soft_border_px = 0);

/// Where a number stands; `undefined` for one that is not there.
Verdict judge(const Limits& limits, const Measured& measured);

/// "≤ 0.1", "0.96 - 1.05".
std::string good_text(const Limits& limits);

/// The worst of some verdicts; pass for none.
Verdict worst(const std::vector<Verdict>& verdicts);

}  // namespace texbake
