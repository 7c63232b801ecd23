// Integer codes of pictures, 8 or 16 bits, to and from numbers: by table, to the nearest code.
// Based on: IEC 61966-2-1.
#pragma once

#include <cstdint>
#include <vector>

namespace texbake {

/// The linear light of every sRGB code of `bits` bits (1 … 16): entry c is linear_from_srgb(c / (2^bits − 1)).
std::vector<float> linear_of_srgb_codes(int bits);

/// Encodes linear light as the nearest sRGB code of 8 or 16 bits.
class SrgbEncoder {
 public:
  explicit SrgbEncoder(int bits);
  /// The code c whose encoded value c / (2^bits − 1) is nearest to srgb_from_linear(linear), a tie going up. Values
  /// outside 0 … 1 take the nearest end; `linear` is not NaN.
  uint16_t operator()(float linear) const;

 private:
  std::vector<float> least_;     ///< least linear value of each code; ends with +infinity
  std::vector<uint16_t> start_;  ///< for each run of floats that share their leading bits: code of its first value
  uint32_t first_bits_;          ///< leading bits of the smallest float that is not code 0
  int shift_;                    ///< how many trailing bits a run spans
};

/// round(value_01 · (2^bits − 1)), halves up, the nearest end outside 0 … 1; `value_01` is not NaN.
uint16_t code_from_unit(float value_01, int bits);

/// The convention of integer normal maps: the middle code 2^(bits−1) is exactly 0 and the highest code is 1, so that
/// the flat normal that programs write, (128, 128, 255), is exactly (0, 0, 1). The lowest code would lie just below −1
/// and is −1. `component` is not NaN; values outside −1 … 1 take the nearest end.
float normal_from_code(uint16_t code, int bits);
uint16_t code_from_normal(float component, int bits);

}  // namespace texbake
