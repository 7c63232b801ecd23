#include "libbake/noise/batch_fft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "libbake/base/random.h"

namespace texbake {
namespace {

template <int N>
void expect_equals_the_sum() {
  Random random(N);
  std::array<Lanes, N> re;
  std::array<Lanes, N> im;
  for (size_t n = 0; n < N; ++n)
    for (int lane = 0; lane < kLanes; ++lane) {
      re[n][lane] = random.uniform() - 0.5f;
      im[n][lane] = random.uniform() - 0.5f;
    }
  const auto re_in = re;
  const auto im_in = im;
  batch_fft<N>(re, im);
  for (int lane = 0; lane < kLanes; ++lane)
    for (int f = 0; f < N; ++f) {
      std::complex<double> sum = 0.0;
      for (int n = 0; n < N; ++n)
        sum += std::complex<double>(re_in[size_t(n)][lane], im_in[size_t(n)][lane]) *
               std::polar(1.0, -2.0 * M_PI * n * f / N);
      EXPECT_NEAR(re[size_t(f)][lane], sum.real(), 1e-6);  // a few float steps of values up to 8
      EXPECT_NEAR(im[size_t(f)][lane], sum.imag(), 1e-6);
    }
}

TEST(BatchFft, EqualsTheSumOfItsDefinition) {
  expect_equals_the_sum<2>();
  expect_equals_the_sum<4>();
  expect_equals_the_sum<8>();
  expect_equals_the_sum<16>();
}

}  // namespace
}  // namespace texbake
