// Four neighboring texels at a time: the same operations in the same order on every processor, so the same bits.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace texbake {

using Lanes = float __attribute__((vector_size(16)));
using LaneBits = int32_t __attribute__((vector_size(16)));
inline constexpr int kLanes = 4;

inline Lanes load_lanes(const float* p) {
  Lanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
inline void store_lanes(float* p, Lanes v) { std::memcpy(p, &v, sizeof v); }
inline Lanes splat(float x) { return Lanes{x, x, x, x}; }

/// `n` rounded up to whole lanes.
inline int round_to_lanes(int n) { return (n + kLanes - 1) / kLanes * kLanes; }

/// The sum of the four lanes, in a fixed order.
inline float sum_lanes(Lanes v) { return (v[0] + v[1]) + (v[2] + v[3]); }

/// exp(−x) for 0 ≤ x ≤ 80; relative error below 2e-7. Other arguments give numbers without meaning.
inline Lanes exp_of_negative(Lanes x) {
  // exp(−x) = 2^i · 2^f with f in [−½, ½], the second by its Taylor series in f·ln 2.
  const Lanes t = x * splat(-1.44269504f);
  const LaneBits i = __builtin_convertvector(t - splat(0.5f), LaneBits);  // rounds toward zero: t ≤ 0
  const Lanes f = (t - __builtin_convertvector(i, Lanes)) * splat(0.693147181f);
  Lanes series = splat(1.0f / 5040.0f);
  series = series * f + splat(1.0f / 720.0f);
  series = series * f + splat(1.0f / 120.0f);
  series = series * f + splat(1.0f / 24.0f);
  series = series * f + splat(1.0f / 6.0f);
  series = series * f + splat(0.5f);
  series = series * f + splat(1.0f);
  series = series * f + splat(1.0f);
  const LaneBits scale_bits = (i + 127) << 23;
  Lanes scale;
  std::memcpy(&scale, &scale_bits, sizeof scale);
  return series * scale;
}

/// The natural logarithm of normal x > 0; absolute error below 1e-6.
inline Lanes log_lanes(Lanes x) {
  // x = 2^e · m with m in [√½, √2); log m = 2 atanh((m − 1)/(m + 1)).
  LaneBits bits;
  std::memcpy(&bits, &x, sizeof bits);
  const LaneBits shifted = bits - 0x3f3504f3;  // the bits of √½: the carry moves m into its range
  const LaneBits exponent = shifted >> 23;
  const LaneBits mantissa_bits = (shifted & 0x7fffff) + 0x3f3504f3;
  Lanes m;
  std::memcpy(&m, &mantissa_bits, sizeof m);
  const Lanes s = (m - splat(1.0f)) / (m + splat(1.0f));
  const Lanes s2 = s * s;
  Lanes series = splat(1.0f / 9.0f);
  series = series * s2 + splat(1.0f / 7.0f);
  series = series * s2 + splat(1.0f / 5.0f);
  series = series * s2 + splat(1.0f / 3.0f);
  series = series * s2 + splat(1.0f);
  return __builtin_convertvector(exponent, Lanes) * splat(0.693147181f) + splat(2.0f) * s * series;
}

}  // namespace texbake
