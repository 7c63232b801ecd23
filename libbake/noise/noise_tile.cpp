// Every realization is one inverse transform; the phases are drawn in the order of the lower half of the frequencies.
#include "libbake/noise/noise_tile.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "libbake/base/fft.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/random.h"

namespace texbake {

Image<std::complex<float>> random_phases(int count, uint32_t seed, int channel) {
  assert(count % 2 == 0);
  Random random(seed, static_cast<uint64_t>(channel));
  Image<std::complex<float>> phases(count, 1);
  std::complex<float>* of = phases.data();
  for (int k = 0; k <= count / 2; ++k) {
    const auto turn = static_cast<double>(random.uniform());
    if (2 * k % count == 0) {
      of[k] = turn < 0.5 ? 1.0f : -1.0f;
      continue;
    }
    of[k] = {static_cast<float>(portable_cos(2.0 * std::numbers::pi * turn)),
             static_cast<float>(portable_sin(2.0 * std::numbers::pi * turn))};
    of[count - k] = std::conj(of[k]);
  }
  return phases;
}

Image<float> realise_noise(ImageView<const float> spectrum, ImageView<const std::complex<float>> phases) {
  assert(same_size(spectrum, phases) && spectrum.height() == 1);
  Image<std::complex<float>> transform(spectrum.width(), 1);
  const auto count = static_cast<float>(spectrum.size());
  for (size_t i = 0; i < spectrum.size(); ++i) transform.data()[i] = phases.data()[i] * (spectrum.data()[i] * count);
  return inverse_fft_real<float>(transform);
}

}  // namespace texbake
