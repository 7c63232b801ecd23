// Loops over several threads. Every index does its own work and writes its own place, so that the number of threads
// changes the time and never the result.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace texbake {

/// Calls `body(i)` for begin ≤ i < end, at least `grain` consecutive indices in one task. `body` must not depend on
/// the order of the calls. Reductions are made by the caller, in index order, from what each index has stored.
template <class Body>
void parallel_for(int begin, int end, const Body& body, int grain = 1) {
  tbb::parallel_for(tbb::blocked_range<int>(begin, end, static_cast<size_t>(grain)),
                    [&](const tbb::blocked_range<int>& range) {
                      for (int i = range.begin(); i < range.end(); ++i) body(i);
                    });
}

}  // namespace texbake
