// Values in steps of the samples that a frame was stored with: what half a code or one half float is worth in light
// depends on the light, and comparing in steps says so.
#pragma once

#include "libbake/base/image.h"
#include "libbake/base/options.h"
#include "libbake/base/torus.h"

namespace texbake {

enum class SampleCode {
  srgb,     ///< integers by the sRGB curve, 0 … 1
  unit,     ///< integers of 0 … 1
  vector,   ///< integers of −1 … 1, the middle code being 0
  half,     ///< half floats
  float32,  ///< the values themselves: a step is 1
};
template <>
struct EnumNames<SampleCode> {
  static constexpr std::pair<SampleCode, std::string_view> values[] = {{SampleCode::srgb, "srgb"},
                                                                       {SampleCode::unit, "unit"},
                                                                       {SampleCode::vector, "vector"},
                                                                       {SampleCode::half, "half"},
                                                                       {SampleCode::float32, "float"}};
};

/// How the samples of a frame stand for values.
struct SampleScale {
  SampleCode code = SampleCode::float32;
  int bits = 32;  ///< of an integer code, 1 … 16
};

/// Where `value` lies on the scale: 0 … 2^bits − 1 for integers (vectors: −(2^(bits−1) − 1) … 2^(bits−1) − 1), clamped
/// and with a fraction between codes; for halves the number of half floats from 0 to `value`, with a fraction between
/// two of them. NaN stays NaN.
float in_steps(float value, const SampleScale& scale);
Image<V3f> in_steps(ImageView<const V3f> values, const SampleScale& scale);

/// How far, in steps, a right frame may be from the reference:
/// integers 0.6: half a step of rounding and the tenth by which graphics APIs let the sRGB curve err;
/// halves 1: a GPU may round toward zero when it stores; floats 0.
float default_tolerance(const SampleScale& scale);

}  // namespace texbake
