#include "libbake/report/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace texbake {
namespace {

Limits at_most(double pass, double warn) {
  Limits limits;
  limits.pass_high = pass;
  limits.warn_high = warn;
  return limits;
}

}  // namespace

std::optional<Limits> limits_of(Measure measure, int content_count, int soft_border_px) {
  switch (measure) {
    case Measure::tile_x:
    case Measure::tile_y:
      return at_most(1.15, 1.5);
    case Measure::repetition_near:
      return at_most(1.0 / content_count + 0.03, 1.0 / content_count + 0.10);
    case Measure::repetition_far:
      return at_most(0.10, 0.20);
    case Measure::amplitude_far:
      return at_most(0.7, 1.4);
    case Measure::band_finest:
    case Measure::band_fine:
    case Measure::band_middle:
    case Measure::band_coarse:
    case Measure::band_rest:
      return Limits{0.9, 1.1, 0.8, 1.25};
    case Measure::seam_auc:
      return soft_border_px > 0 ? at_most(0.60, 0.67) : at_most(0.65, 0.72);
    case Measure::seam_tail:
      return at_most(0.10, 0.20);
    case Measure::color:
      return at_most(0.06, 0.10);
    case Measure::spectrum:
      return at_most(0.8, 1.5);
    case Measure::gradient_ratio:
      return Limits{0.96, 1.05, 0.90, 1.12};
    case Measure::structure:
      return at_most(1.15, 1.4);
    case Measure::noise_spectrum:
      return at_most(1.0, 2.0);
    case Measure::noise_power:
      return at_most(0.03, 0.06);
    case Measure::noise_coherence:
      return at_most(0.05, 0.10);
    default:
      return std::nullopt;
  }
}

Verdict judge(const Limits& limits, const Measured& measured) {
  if (!measured.value || !std::isfinite(measured.value->mean)) return Verdict::undefined;
  const double value = measured.value->mean;
  if (value >= limits.pass_low && value <= limits.pass_high) return Verdict::pass;
  if (value >= limits.warn_low && value <= limits.warn_high) return Verdict::warn;
  return Verdict::fail;
}

std::string good_text(const Limits& limits) {
  if (std::isinf(limits.pass_low)) return fmt::format("≤ {:.3g}", limits.pass_high);
  return fmt::format("{:.3g} - {:.3g}", limits.pass_low, limits.pass_high);
}

Verdict worst(const std::vector<Verdict>& verdicts) {
  const auto found = std::max_element(verdicts.begin(), verdicts.end());
  return found == verdicts.end() ? Verdict::pass : *found;
}

}  // namespace texbake
