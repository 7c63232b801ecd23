// Which size of local spectra suits an exemplar: the largest one whose noise, made again, still looks like the
// exemplar. Based on: Guingo et al. 2017, §5: "the largest possible T_loc leading to acceptable visual results".
#pragma once

#include <span>
#include <string>
#include <vector>

namespace texbake {

/// How an exemplar and its synthesis (structure + new noise) compare; see synthesis_test.h.
struct SynthesisTest {
  int local_size = 0;
  double energy_deviation = 0;  ///< r(T)
  double coherence_drop = 0;    ///< of the exemplar's mean coherence, to the synthesis
};

struct LocalSizeChoice {
  int local_size = 0;
  std::string reason;  ///< one sentence with the figures
};

/// A coherence drop above this says that structure was left in the noise: 0.04 to 0.08 in photographs of bark, rust,
/// moss and leaves, 0.02 at most in grass, sand and known Gaussian fields.
inline constexpr double kStructureInNoise = 0.03;

/// `tested` by rising size, at least one. The largest T with r(T) ≤ r(smallest) + 0.04; + 0.10 where the coherence
/// drops by 0.025 at most: such noise is grain without direction, and its energy differs by chance alone.
LocalSizeChoice choose_local_size(std::span<const SynthesisTest> tested);

}  // namespace texbake
