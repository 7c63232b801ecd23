#include "formats/srgb_codes.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "libbake/color/luv.h"

namespace texbake {
namespace {

// Mantissa bits that tell two runs apart: with these a run holds at most two codes, so that a search takes a step or
// two.
int mantissa_bits(int bits) { return bits == 8 ? 7 : 14; }

float highest_code(int bits) { return static_cast<float>((1 << bits) - 1); }

}  // namespace

std::vector<float> linear_of_srgb_codes(int bits) {
  assert(bits >= 1 && bits <= 16);
  std::vector<float> table(size_t{1} << bits);
  for (size_t code = 0; code < table.size(); ++code)
    table[code] = linear_from_srgb(static_cast<float>(code) / highest_code(bits));
  return table;
}

SrgbEncoder::SrgbEncoder(int bits) : shift_(23 - mantissa_bits(bits)) {
  assert(bits == 8 || bits == 16);
  const int codes = 1 << bits;
  least_.resize(static_cast<size_t>(codes) + 1);
  least_[0] = -std::numeric_limits<float>::infinity();
  for (int code = 1; code < codes; ++code)
    least_[code] = linear_from_srgb((static_cast<float>(code) - 0.5f) / highest_code(bits));
  least_[codes] = std::numeric_limits<float>::infinity();

  // One entry for each run of floats from the first that is not code 0 up to 1.
  first_bits_ = std::bit_cast<uint32_t>(least_[1]) >> shift_;
  const uint32_t last_bits = std::bit_cast<uint32_t>(1.0f) >> shift_;
  int code = 0;
  for (uint32_t run = first_bits_; run <= last_bits; ++run) {
    const auto least = std::bit_cast<float>(run << shift_);
    while (least >= least_[code + 1]) ++code;
    start_.push_back(static_cast<uint16_t>(code));
  }
}

uint16_t SrgbEncoder::operator()(float linear) const {
  assert(!std::isnan(linear));
  if (linear < least_[1]) return 0;
  if (linear >= 1) return static_cast<uint16_t>(least_.size() - 2);
  int code = start_[(std::bit_cast<uint32_t>(linear) >> shift_) - first_bits_];
  while (linear >= least_[code + 1]) ++code;
  return static_cast<uint16_t>(code);
}

uint16_t code_from_unit(float value_01, int bits) {
  assert(!std::isnan(value_01));
  return static_cast<uint16_t>(std::clamp(value_01, 0.0f, 1.0f) * highest_code(bits) + 0.5f);
}

float normal_from_code(uint16_t code, int bits) {
  const int middle = 1 << (bits - 1);
  return std::max(static_cast<float>(code - middle) / static_cast<float>(middle - 1), -1.0f);
}

uint16_t code_from_normal(float component, int bits) {
  assert(!std::isnan(component));
  const int middle = 1 << (bits - 1);
  const float scaled = std::clamp(component, -1.0f, 1.0f) * static_cast<float>(middle - 1);
  return static_cast<uint16_t>(middle + static_cast<int>(std::floor(scaled + 0.5f)));
}

}  // namespace texbake
