#include "libbake/draw/compare.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>

#include "libbake/base/error.h"

namespace texbake {
namespace {

void check_sizes(V2i expected, V2i found) {
  if (expected != found)
    throw Error(ErrorKind::bad_data,
                fmt::format("frame: expected {} x {} pixels, found {} x {}", expected.x, expected.y, found.x, found.y));
}

template <class A, class B>
void check_sizes(const A& expected, const B& found) {
  check_sizes(V2i(expected.width(), expected.height()), V2i(found.width(), found.height()));
}

bool has_nan(const V3f& c) { return std::isnan(c.x) || std::isnan(c.y) || std::isnan(c.z); }

uint64_t differing_bits(const V3f& a, const V3f& b) {
  int bits = 0;
  for (int c = 0; c < 3; ++c) bits += std::popcount(std::bit_cast<uint32_t>(a[c]) ^ std::bit_cast<uint32_t>(b[c]));
  return static_cast<uint64_t>(bits);
}

float difference_of(const V3f& a, const V3f& b) {
  if (has_nan(a) || has_nan(b)) return std::numeric_limits<float>::infinity();
  float largest = 0;
  for (int c = 0; c < 3; ++c)
    if (a[c] != b[c]) largest = std::max(largest, std::abs(a[c] - b[c]));  // equal infinities do not differ
  return largest;
}

}  // namespace

ValueComparison compare_values(ImageView<const V3f> expected, ImageView<const V3f> found, float tolerance) {
  check_sizes(expected, found);
  ValueComparison result;
  result.pixels = expected.size();
  double sum = 0;
  for (int y = 0; y < expected.height(); ++y)
    for (int x = 0; x < expected.width(); ++x) {
      const V3f &a = expected(x, y), &b = found(x, y);
      const uint64_t bits = differing_bits(a, b);
      const bool nan = has_nan(a) || has_nan(b);
      if (bits == 0 && !nan) continue;
      const float difference = difference_of(a, b);
      result.differing_bits += bits;
      result.nan_pixels += nan;
      if (!nan) sum += difference;
      result.differing_pixels += difference > tolerance;
      if (!result.worst || difference > result.worst->difference) result.worst = WorstPixel{x, y, a, b, difference};
    }
  if (result.pixels > result.nan_pixels)
    result.mean_difference = sum / static_cast<double>(result.pixels - result.nan_pixels);
  return result;
}

DecisionComparison compare_decisions(ImageView<const PixelDecision> expected, ImageView<const PixelDecision> found) {
  check_sizes(expected, found);
  DecisionComparison result;
  result.pixels = expected.size();
  for (int y = 0; y < expected.height(); ++y)
    for (int x = 0; x < expected.width(); ++x) {
      if (expected(x, y) == found(x, y)) continue;
      if (result.differing_pixels++ == 0) result.first = {x, y};
    }
  return result;
}

Image<V3f> color_values(ImageView<const glsl::vec4> values) {
  Image<V3f> colors(values.width(), values.height());
  for (int y = 0; y < values.height(); ++y)
    for (int x = 0; x < values.width(); ++x) colors(x, y) = {values(x, y).x, values(x, y).y, values(x, y).z};
  return colors;
}

Image<V3f> difference_picture(ImageView<const V3f> expected, ImageView<const V3f> found, float gain) {
  check_sizes(expected, found);
  Image<V3f> picture(expected.width(), expected.height());
  for (int y = 0; y < expected.height(); ++y)
    for (int x = 0; x < expected.width(); ++x) {
      const V3f &a = expected(x, y), &b = found(x, y);
      const V3f d = b - a;
      picture(x, y) = has_nan(d) ? V3f(1) : V3f(std::abs(d.x), std::abs(d.y), std::abs(d.z)) * gain;
    }
  return picture;
}

}  // namespace texbake
