// Wraps cv::dft around our own images, without a copy of the input.
#include "libbake/base/fft.h"

#include <opencv2/core.hpp>

namespace texbake {
namespace {

template <class T>
cv::Mat real_matrix(const T* data, int width, int height) {
  return cv::Mat(height, width, cv::DataType<T>::type, const_cast<T*>(data));
}
template <class T>
cv::Mat complex_matrix(const std::complex<T>* data, int width, int height) {
  return cv::Mat(height, width, CV_MAKETYPE(cv::DataType<T>::depth, 2), const_cast<std::complex<T>*>(data));
}

}  // namespace

template <class T>
Image<std::complex<T>> fft(ImageView<const T> image) {
  Image<std::complex<T>> spectrum(image.width(), image.height());
  cv::Mat out = complex_matrix(spectrum.data(), image.width(), image.height());
  cv::dft(real_matrix(image.data(), image.width(), image.height()), out, cv::DFT_COMPLEX_OUTPUT);
  CV_Assert(out.ptr() == reinterpret_cast<unsigned char*>(spectrum.data()));
  return spectrum;
}

template <class T>
Image<T> inverse_fft_real(ImageView<const std::complex<T>> spectrum) {
  cv::Mat complex_result;
  cv::dft(complex_matrix(spectrum.data(), spectrum.width(), spectrum.height()), complex_result,
          cv::DFT_INVERSE | cv::DFT_SCALE);
  Image<T> result(spectrum.width(), spectrum.height());
  for (int y = 0; y < result.height(); ++y) {
    const auto* row = complex_result.ptr<std::complex<T>>(y);
    for (int x = 0; x < result.width(); ++x) result(x, y) = row[x].real();
  }
  return result;
}

int fast_fft_size(int n) { return cv::getOptimalDFTSize(n); }

template Image<std::complex<float>> fft(ImageView<const float>);
template Image<std::complex<double>> fft(ImageView<const double>);
template Image<float> inverse_fft_real(ImageView<const std::complex<float>>);
template Image<double> inverse_fft_real(ImageView<const std::complex<double>>);

}  // namespace texbake
