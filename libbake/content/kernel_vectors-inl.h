// Vectors of distances and sums for the kernel of the search, one for each row of a group. Compiled once for each
// instruction set: included only by impact_kernel.cpp.
#if defined(TEXBAKE_CONTENT_KERNEL_VECTORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef TEXBAKE_CONTENT_KERNEL_VECTORS_INL_H_
#undef TEXBAKE_CONTENT_KERNEL_VECTORS_INL_H_
#else
#define TEXBAKE_CONTENT_KERNEL_VECTORS_INL_H_
#endif

#include <hwy/highway.h>

#include "libbake/content/distance_field.h"

#if HWY_TARGET != HWY_SCALAR && HWY_ARCH_X86
HWY_BEFORE_NAMESPACE();
namespace texbake {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<uint8_t, kGroupWidth> d8{};
constexpr hn::Repartition<uint16_t, decltype(d8)> d16{};
constexpr hn::Repartition<uint32_t, decltype(d8)> d32{};
constexpr hn::Repartition<int16_t, decltype(d8)> di16{};
constexpr hn::Repartition<int32_t, decltype(d8)> di32{};
constexpr hn::Repartition<int64_t, decltype(d8)> d64{};
constexpr hn::Repartition<uint64_t, decltype(d8)> du64{};
constexpr hn::Rebind<uint32_t, decltype(d64)> d32_half{};

// One vector for each row of a group: Lanes(d8) translations of each row are summed at a time.
struct Bytes {
  hn::Vec<decltype(d8)> row[kGroupRows];
};

HWY_ATTR HWY_INLINE size_t slot() { return kGroupRows * hn::Lanes(d8); }
HWY_ATTR HWY_INLINE Bytes load(const uint8_t* from) {
  Bytes v;
  for (size_t r = 0; r < kGroupRows; ++r) v.row[r] = hn::Load(d8, from + r * hn::Lanes(d8));
  return v;
}
HWY_ATTR HWY_INLINE void store(const Bytes& v, uint8_t* to) {
  for (size_t r = 0; r < kGroupRows; ++r) hn::Store(v.row[r], d8, to + r * hn::Lanes(d8));
}

// The same with 16 bits: of each 16 translations the first 8 in `low`, the last 8 in `high`.
struct Words {
  hn::Vec<decltype(d16)> low[kGroupRows];
  hn::Vec<decltype(d16)> high[kGroupRows];
};

HWY_ATTR HWY_INLINE Words load(const uint16_t* from) {
  Words v;
  for (size_t r = 0; r < kGroupRows; ++r) {
    v.low[r] = hn::Load(d16, from + 2 * r * hn::Lanes(d16));
    v.high[r] = hn::Load(d16, from + (2 * r + 1) * hn::Lanes(d16));
  }
  return v;
}
HWY_ATTR HWY_INLINE void store(const Words& v, uint16_t* to) {
  for (size_t r = 0; r < kGroupRows; ++r) {
    hn::Store(v.low[r], d16, to + 2 * r * hn::Lanes(d16));
    hn::Store(v.high[r], d16, to + (2 * r + 1) * hn::Lanes(d16));
  }
}
HWY_ATTR HWY_INLINE Words widen(const Bytes& v) {
  Words wide;
  for (size_t r = 0; r < kGroupRows; ++r) {
    wide.low[r] = hn::BitCast(d16, hn::InterleaveLower(d8, v.row[r], hn::Zero(d8)));
    wide.high[r] = hn::BitCast(d16, hn::InterleaveUpper(d8, v.row[r], hn::Zero(d8)));
  }
  return wide;
}
HWY_ATTR HWY_INLINE Words operator+(Words a, const Words& b) {
  for (size_t r = 0; r < kGroupRows; ++r) {
    a.low[r] = hn::Add(a.low[r], b.low[r]);
    a.high[r] = hn::Add(a.high[r], b.high[r]);
  }
  return a;
}
HWY_ATTR HWY_INLINE Words operator-(Words a, const Words& b) {
  for (size_t r = 0; r < kGroupRows; ++r) {
    a.low[r] = hn::Sub(a.low[r], b.low[r]);
    a.high[r] = hn::Sub(a.high[r], b.high[r]);
  }
  return a;
}

// Sums of 32 bits: of each 16 translations four in each vector.
struct ErrorSums {
  hn::Vec<decltype(di32)> quarter[kGroupRows][4];
};

HWY_ATTR HWY_INLINE ErrorSums load_sums(const uint32_t* from) {
  ErrorSums sums;
  for (size_t r = 0; r < kGroupRows; ++r)
    for (size_t i = 0; i < 4; ++i)
      sums.quarter[r][i] = hn::BitCast(di32, hn::LoadU(d32, from + r * kGroupWidth + i * hn::Lanes(d32)));
  return sums;
}
HWY_ATTR HWY_INLINE void store_sums(const ErrorSums& sums, uint32_t* to) {
  for (size_t r = 0; r < kGroupRows; ++r)
    for (size_t i = 0; i < 4; ++i)
      hn::StoreU(hn::BitCast(d32, sums.quarter[r][i]), d32, to + r * kGroupWidth + i * hn::Lanes(d32));
}

// Adds δ · (M ∗ δ) of two texels.
HWY_ATTR HWY_INLINE void add_errors(const Bytes& delta_1, const Words& box_1, const Bytes& delta_2, const Words& box_2,
                                    ErrorSums& sums) {
  const auto zero = hn::Zero(d8);
  auto unused = hn::Zero(di32);
  for (size_t r = 0; r < kGroupRows; ++r) {
    const auto low = hn::InterleaveLower(d8, delta_1.row[r], delta_2.row[r]);
    const auto high = hn::InterleaveUpper(d8, delta_1.row[r], delta_2.row[r]);
    const hn::Vec<decltype(d8)> deltas[4] = {hn::InterleaveLower(d8, low, zero), hn::InterleaveUpper(d8, low, zero),
                                             hn::InterleaveLower(d8, high, zero), hn::InterleaveUpper(d8, high, zero)};
    const hn::Vec<decltype(d16)> boxes[4] = {
        hn::InterleaveLower(d16, box_1.low[r], box_2.low[r]), hn::InterleaveUpper(d16, box_1.low[r], box_2.low[r]),
        hn::InterleaveLower(d16, box_1.high[r], box_2.high[r]), hn::InterleaveUpper(d16, box_1.high[r], box_2.high[r])};
    for (size_t i = 0; i < 4; ++i)
      sums.quarter[r][i] = hn::ReorderWidenMulAccumulate(di32, hn::BitCast(di16, deltas[i]),
                                                         hn::BitCast(di16, boxes[i]), sums.quarter[r][i], unused);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace texbake
HWY_AFTER_NAMESPACE();
#endif

#endif  // include guard for each instruction set
