// Range reduction to a small interval, then a series long enough for double precision.
#include "libbake/base/portable_math.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace texbake {
namespace {

// ln 2 and π/2 in two parts: the first has trailing zeros, so that its product with a small integer is exact.
constexpr double kLn2High = 6.93147180369123816490e-01;
constexpr double kLn2Low = 1.90821492927058770002e-10;
constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
constexpr double kHalfPiLow = 6.07710050650619224932e-11;

// Sum of coefficients[i] · x^i by Horner's rule.
template <int N>
double polynomial(const double (&coefficients)[N], double x) {
  double sum = coefficients[N - 1];
  for (int i = N - 2; i >= 0; --i) sum = sum * x + coefficients[i];
  return sum;
}

// 1/n! for the Taylor series of e^r, |r| ≤ ln2/2: the first term left out is below 1e-17.
constexpr double kExpSeries[] = {
    1.0,        1.0,         1.0 / 2,      1.0 / 6,       1.0 / 24,       1.0 / 120,       1.0 / 720,
    1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800.0};
constexpr double kCosSeries[] = {1.0,
                                 -1.0 / 2,
                                 1.0 / 24,
                                 -1.0 / 720,
                                 1.0 / 40320,
                                 -1.0 / 3628800,
                                 1.0 / 479001600,
                                 -1.0 / 87178291200.0,
                                 1.0 / 20922789888000.0};
constexpr double kSinSeries[] = {1.0,
                                 -1.0 / 6,
                                 1.0 / 120,
                                 -1.0 / 5040,
                                 1.0 / 362880,
                                 -1.0 / 39916800,
                                 1.0 / 6227020800.0,
                                 -1.0 / 1307674368000.0,
                                 1.0 / 355687428096000.0};

// cos(r + quarter_turns · π/2) for |r| ≤ π/4.
double cos_quadrant(double r, int64_t quarter_turns) {
  const double r2 = r * r;
  switch (quarter_turns & 3) {
    case 0:
      return polynomial(kCosSeries, r2);
    case 1:
      return -r * polynomial(kSinSeries, r2);
    case 2:
      return -polynomial(kCosSeries, r2);
    default:
      return r * polynomial(kSinSeries, r2);
  }
}

double cos_shifted(double x, int64_t extra_quarter_turns) {
  const double turns = std::floor(x / (kHalfPiHigh + kHalfPiLow) + 0.5);
  const double r = (x - turns * kHalfPiHigh) - turns * kHalfPiLow;
  return cos_quadrant(r, static_cast<int64_t>(turns) + extra_quarter_turns);
}

}  // namespace

double portable_exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 709.78) return std::numeric_limits<double>::infinity();
  if (x < -745.0) return 0.0;
  const double power = std::floor(x / (kLn2High + kLn2Low) + 0.5);
  const double r = (x - power * kLn2High) - power * kLn2Low;
  return std::ldexp(polynomial(kExpSeries, r), static_cast<int>(power));
}

double portable_log(double x) {
  if (std::isnan(x)) return x;
  if (x <= 0.0) return -std::numeric_limits<double>::infinity();
  int power = 0;
  double mantissa = std::frexp(x, &power);
  if (mantissa < 0.70710678118654752440) {
    mantissa *= 2.0;
    --power;
  }
  // ln m = 2 artanh(s) with s = (m − 1)/(m + 1), |s| ≤ 0.172: the series ends below 1e-17.
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  const double s2 = s * s;
  double series = 0.0;
  for (int n = 21; n >= 3; n -= 2) series = (series + 1.0 / n) * s2;
  return power * kLn2High + (power * kLn2Low + 2.0 * (s + s * series));
}

double portable_pow(double x, double y) {
  if (x <= 0.0) return y == 0.0 ? 1.0 : 0.0;
  return portable_exp(y * portable_log(x));
}

double portable_cbrt(double x) {
  if (x == 0.0 || !std::isfinite(x)) return x;
  const double magnitude = std::fabs(x);
  double root = portable_exp(portable_log(magnitude) / 3.0);
  root -= (root * root * root - magnitude) / (3.0 * root * root);  // one Newton step removes what the logarithm lost
  return x < 0.0 ? -root : root;
}

double portable_cos(double x) { return cos_shifted(x, 0); }
double portable_sin(double x) { return cos_shifted(x, -1); }

}  // namespace texbake
