// Two-dimensional discrete Fourier transforms, by OpenCV in one thread: its bits do not depend on the processor.
#pragma once

#include <complex>

#include "libbake/base/image.h"

namespace texbake {

/// Σ_p image(p) · exp(−2πi f·p/size), not normalized; all width × height frequencies. T is float or double.
template <class T>
Image<std::complex<T>> fft(ImageView<const T> image);

/// The real part of the inverse, divided by width · height: `inverse_fft_real(fft(x)) == x` up to rounding.
template <class T>
Image<T> inverse_fft_real(ImageView<const std::complex<T>> spectrum);

/// The smallest size ≥ `n` that the transform computes fast (2^a 3^b 5^c).
int fast_fft_size(int n);

}  // namespace texbake
