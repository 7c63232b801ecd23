// Elementary functions whose every bit is the same on every machine: built from + − × ÷ and sqrt alone. The C library
// picks variants by processor, and their last bits differ; what is stored in a bundle must not.
#pragma once

namespace texbake {

/// Relative error below 1e-15 for |x| ≤ 700; 0 below −745, infinity above 709.78.
double portable_exp(double x);
/// Natural logarithm of a finite x > 0; relative error below 1e-15, absolute near x = 1. x ≤ 0 gives −infinity.
double portable_log(double x);
/// x to the power y for x ≥ 0; pow(0, y) = 0 for y > 0. Relative error below 1e-14 where the result is in 1e-6 … 1e6.
double portable_pow(double x, double y);
/// Cube root; relative error below 1e-15.
double portable_cbrt(double x);
/// Absolute error below 1e-15 for |x| ≤ 1e4.
double portable_cos(double x);
double portable_sin(double x);

}  // namespace texbake
