// Everything in double from + − × ÷ and sqrt alone, rounded once at the end: the same bits on every machine.
#include "libbake/color/luv.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"

namespace texbake {
namespace {

// ITU-R BT.709 primaries with the D65 white (0.3127, 0.3290); rows X, Y, Z.
constexpr double kXyzFromLinear[3][3] = {{0.41239079926595934, 0.357584339383878, 0.1804807884018343},
                                         {0.21263900587151027, 0.715168678767756, 0.07219231536073371},
                                         {0.01933081871559182, 0.11919477979462598, 0.9505321522496607}};
constexpr double kLinearFromXyz[3][3] = {{3.2409699419045226, -1.537383177570094, -0.4986107602930034},
                                         {-0.9692436362808796, 1.8759675015077202, 0.04155505740717559},
                                         {0.05563007969699366, -0.20397695888897652, 1.0569715142428786}};

// White is (1, 1, 1) through the same matrix, so that grays have u* = v* = 0.
constexpr double kWhiteX = kXyzFromLinear[0][0] + kXyzFromLinear[0][1] + kXyzFromLinear[0][2];
constexpr double kWhiteY = kXyzFromLinear[1][0] + kXyzFromLinear[1][1] + kXyzFromLinear[1][2];
constexpr double kWhiteZ = kXyzFromLinear[2][0] + kXyzFromLinear[2][1] + kXyzFromLinear[2][2];
constexpr double kWhiteDenominator = kWhiteX + 15 * kWhiteY + 3 * kWhiteZ;
constexpr double kWhiteU = 4 * kWhiteX / kWhiteDenominator;
constexpr double kWhiteV = 9 * kWhiteY / kWhiteDenominator;

constexpr double kDarkY = 216.0 / 24389.0;     // (6/29)³: below it lightness is linear in Y
constexpr double kDarkSlope = 24389.0 / 27.0;  // (29/3)³
constexpr double kDarkL = 8;
constexpr double kLeastV = 1.0 / 64;  // nothing visible has a smaller v'; the division by it must stay finite

// Cube root of x > 0. The exponent divided by three starts within 6 %; each Halley step cubes the error.
double cube_root(double x) {
  double root = std::bit_cast<double>(std::bit_cast<uint64_t>(x) / 3 + 0x2A9F7893782DA1CEu);
  for (int step = 0; step < 3; ++step) {
    const double cube = root * root * root;
    root *= (cube + 2 * x) / (2 * cube + x);
  }
  return root;
}

double lightness(double y) { return y > kDarkY ? 116 * cube_root(y) - 16 : kDarkSlope * y; }

double relative_luminance(double l) {
  if (l <= kDarkL) return l / kDarkSlope;
  const double root = (l + 16) / 116;
  return root * root * root;
}

double row_product(const double (&row)[3], double a, double b, double c) {
  return row[0] * a + row[1] * b + row[2] * c;
}

template <class Convert>
Image<V3f> convert_rows(ImageView<const V3f> image, const Convert& convert) {
  Image<V3f> result(image.width(), image.height());
  parallel_for(0, image.height(), [&](int y) {
    for (int x = 0; x < image.width(); ++x) result(x, y) = convert(image(x, y));
  });
  return result;
}

}  // namespace

V3f luv_from_linear(const V3f& linear) {
  const double x = row_product(kXyzFromLinear[0], linear.x, linear.y, linear.z);
  const double y = row_product(kXyzFromLinear[1], linear.x, linear.y, linear.z);
  const double z = row_product(kXyzFromLinear[2], linear.x, linear.y, linear.z);
  const double l = lightness(y / kWhiteY);
  const double denominator = x + 15 * y + 3 * z;
  if (denominator == 0) return {static_cast<float>(l), 0, 0};
  const double u = 4 * x / denominator - kWhiteU;
  const double v = 9 * y / denominator - kWhiteV;
  return {static_cast<float>(l), static_cast<float>(13 * l * u), static_cast<float>(13 * l * v)};
}

V3f linear_from_luv(const V3f& luv) {
  if (luv.x == 0) return V3f(0);
  const double y = relative_luminance(luv.x) * kWhiteY;
  const double u = luv.y / (13.0 * luv.x) + kWhiteU;
  const double v = std::max(luv.z / (13.0 * luv.x) + kWhiteV, kLeastV);
  const double x = y * 9 * u / (4 * v);
  const double z = y * (12 - 3 * u - 20 * v) / (4 * v);
  return {static_cast<float>(row_product(kLinearFromXyz[0], x, y, z)),
          static_cast<float>(row_product(kLinearFromXyz[1], x, y, z)),
          static_cast<float>(row_product(kLinearFromXyz[2], x, y, z))};
}

Image<V3f> luv_from_linear(ImageView<const V3f> linear) {
  return convert_rows(linear, [](const V3f& c) { return luv_from_linear(c); });
}

Image<V3f> linear_from_luv(ImageView<const V3f> luv) {
  return convert_rows(luv, [](const V3f& c) { return linear_from_luv(c); });
}

float linear_from_srgb(float encoded) {
  const double magnitude = std::fabs(encoded);
  const double linear = magnitude <= 0.04045 ? magnitude / 12.92 : portable_pow((magnitude + 0.055) / 1.055, 2.4);
  return std::copysign(static_cast<float>(linear), encoded);
}

float srgb_from_linear(float linear) {
  const double magnitude = std::fabs(linear);
  if (magnitude <= 0.0031308) return static_cast<float>(12.92 * linear);
  const double root = cube_root(magnitude);  // x^(1/2.4) = (x^⅓)^(5/4)
  return std::copysign(static_cast<float>(1.055 * root * std::sqrt(std::sqrt(root)) - 0.055), linear);
}

}  // namespace texbake
