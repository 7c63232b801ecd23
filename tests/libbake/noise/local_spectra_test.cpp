#include "libbake/noise/local_spectra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "libbake/base/error.h"
#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

/// The definition, word for word, in double: all segments, all windows, a full transform of each.
double slow_spectrum(const Image<float>& image, int size, int x, int y, int u, int v) {
  double window_sum = 0.0;
  std::vector<double> window;
  for (int n = 0; n < size; ++n) {
    window.push_back(std::pow(std::sin(M_PI * (n + 0.5) / size), 2));
    window_sum += window.back();
  }
  double power = 0.0;
  for (int sy = -size; sy <= 1; ++sy)
    for (int sx = -size; sx <= 1; ++sx) {
      // T + 1 origins, centered on the texel: the outermost of T + 2 count half.
      const double share = (sx == -size || sx == 1 ? 0.5 : 1.0) * (sy == -size || sy == 1 ? 0.5 : 1.0);
      std::complex<double> sum = 0.0;
      for (int b = 0; b < size; ++b)
        for (int a = 0; a < size; ++a)
          sum += window[size_t(a)] * window[size_t(b)] *
                 double(image(wrap(x + sx + a, image.width()), wrap(y + sy + b, image.height()))) *
                 std::polar(1.0, -2.0 * M_PI * (u * a + v * b) / size);
      power += share * std::norm(sum);
    }
  return std::sqrt(power / ((size + 1) * (size + 1))) / (window_sum * window_sum) / (10.0 * standard_deviation(image));
}

TEST(LocalSpectra, EqualTheSlowTwin) {
  const Image<float> image = synthetic_noise(ring_power, 36, 0.04, 3);
  for (const int size : kLocalSizes) {
    const LocalSpectra spectra(image, size);
    const SpectraRows rows = spectra.rows(-3, 4);
    for (const V2i& p : {V2i(0, 0), V2i(35, -3), V2i(17, 3), V2i(-8, 1), V2i(43, 2)})
      for (size_t b = 0; b < spectra.bins().size(); b += (size == 16 ? 17 : 1)) {
        const SpectrumBin& bin = spectra.bins()[b];
        EXPECT_NEAR(rows.row(p.y, static_cast<int>(b))[p.x],
                    std::sqrt(bin.weight) * slow_spectrum(image, size, p.x, p.y, bin.u, bin.v),
                    1e-6)  // float sums of values up to 0.1
            << "T " << size << " texel " << p.x << ", " << p.y << " bin " << bin.u << ", " << bin.v;
      }
  }
}

TEST(LocalSpectra, BinsStandForTheWholeSpectrumOnce) {
  const Image<float> image = white_noise(32, 1);
  for (const int size : kLocalSizes) {
    const LocalSpectra spectra(image, size);
    int total = 0;
    Image<int> seen(size, size);
    for (const SpectrumBin& bin : spectra.bins()) {
      total += bin.weight;
      ++seen(bin.u, bin.v);
      if (bin.weight == 2) ++seen(wrap(-bin.u, size), wrap(-bin.v, size));
    }
    EXPECT_EQ(total, size * size);
    for (const int count : seen) EXPECT_EQ(count, 1);
  }
}

TEST(LocalSpectra, DoNotDependOnTheScaleOfTheLuminance) {
  Image<float> image = synthetic_noise(blob_power, 32, 0.01, 2);
  const LocalSpectra dim(image, 4);
  const SpectraRows a = dim.rows(0, 1);
  for (float& value : image) value *= 8.0f;
  const LocalSpectra bright(image, 4);
  const SpectraRows b = bright.rows(0, 1);
  for (int bin = 0; bin < a.bins(); ++bin) EXPECT_NEAR(a.row(0, bin)[5], b.row(0, bin)[5], 1e-6);
}

TEST(LocalSpectra, BandsAreSeamless) {
  const Image<float> image = synthetic_noise(ring_power, 48, 0.01, 2);
  const LocalSpectra spectra(image, 8);
  const SpectraRows whole = spectra.rows(0, 48);
  const SpectraRows part = spectra.rows(20, 25);
  for (int bin = 0; bin < whole.bins(); ++bin)
    for (int x = 0; x < 48; ++x) EXPECT_EQ(whole.row(22, bin)[x], part.row(22, bin)[x]);
}

TEST(LocalSpectra, RefuseWhatHasNoSpectrum) {
  const auto kind = [](const Image<float>& image, int size) {
    try {
      LocalSpectra(image, size);
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::limit;
  };
  EXPECT_EQ(kind(Image<float>(32, 32, 0.5f), 4), ErrorKind::infeasible);  // constant
  EXPECT_EQ(kind(white_noise(30, 1), 16), ErrorKind::infeasible);         // smaller than two windows
  EXPECT_EQ(kind(white_noise(32, 1), 3), ErrorKind::usage);
}

}  // namespace
}  // namespace texbake
