// Random numbers that are the same on every machine and with every standard library.
// Based on: O'Neill 2014, "PCG: a family of simple fast space-efficient statistically good algorithms", PCG32 XSH RR.
#pragma once

#include <cstdint>

namespace texbake {

/// A seeded stream of 32-bit numbers; `stream` separates uses that share a seed.
class Random {
 public:
  explicit Random(uint64_t seed, uint64_t stream = 0) : increment_((stream << 1) | 1) {
    next();
    state_ += seed;
    next();
  }
  uint32_t next() {
    const uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + increment_;
    const auto shifted = static_cast<uint32_t>(((old >> 18) ^ old) >> 27);
    const auto rotation = static_cast<uint32_t>(old >> 59);
    return (shifted >> rotation) | (shifted << ((32 - rotation) & 31));
  }
  /// Uniform in 0 … n−1, without modulo bias beyond 2^-32; n > 0.
  uint32_t below(uint32_t n) { return static_cast<uint32_t>((static_cast<uint64_t>(next()) * n) >> 32); }
  /// Uniform in [0, 1), a multiple of 2^-24: exact in float.
  float uniform() { return static_cast<float>(next() >> 8) * 0x1p-24f; }

 private:
  uint64_t state_ = 0;
  uint64_t increment_;
};

}  // namespace texbake
