// How a long stage tells how far it is. libbake never prints; the caller decides what to do with the number.
#pragma once

#include <functional>

namespace texbake {

/// Called with the done share, 0 to 1, never decreasing, from one thread at a time. Empty when nobody listens.
using Progress = std::function<void(double done)>;

inline void report_progress(const Progress& progress, double done) {
  if (progress) progress(done);
}

}  // namespace texbake
