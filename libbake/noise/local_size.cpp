#include "libbake/noise/local_size.h"

#include <fmt/format.h>

#include <cassert>

namespace texbake {
namespace {

constexpr double kTolerance = 0.04;
constexpr double kGrainTolerance = 0.10;
constexpr double kGrainCoherenceDrop = 0.025;

double tolerance(const SynthesisTest& test) {
  return test.coherence_drop <= kGrainCoherenceDrop ? kGrainTolerance : kTolerance;
}

}  // namespace

LocalSizeChoice choose_local_size(std::span<const SynthesisTest> tested) {
  assert(!tested.empty());
  const double reference = tested.front().energy_deviation;
  size_t chosen = 0;
  for (size_t i = 1; i < tested.size(); ++i)
    if (tested[i].energy_deviation <= reference + tolerance(tested[i])) chosen = i;
  std::string figures;
  for (const SynthesisTest& test : tested)
    figures += fmt::format("{}{} ({:.3f}, {:.3f})", figures.empty() ? "" : ", ", test.local_size, test.energy_deviation,
                           test.coherence_drop);
  const double used = chosen == 0 ? kTolerance : tolerance(tested[chosen]);
  return {
      tested[chosen].local_size,
      fmt::format("{} texels: the largest size whose synthesis deviates from the exemplar by at most {:.3f} + {:.2f}; "
                  "size (deviation, coherence drop): {}",
                  tested[chosen].local_size, reference, used, figures)};
}

}  // namespace texbake
