// Every realisation is one inverse transform; the phases are drawn in reading order of the upper half of the
// frequencies.
#include "libbake/noise/noise_tile.h"

#include <cassert>
#include <cmath>

#include "libbake/base/fft.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/random.h"
#include "libbake/base/torus.h"

namespace texbake {
namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

Image<std::complex<float>> random_phases(int size, uint32_t seed, int channel) {
  assert(size % 2 == 0);
  Random random(seed, static_cast<uint64_t>(channel));
  Image<std::complex<float>> phases(size, size);
  for (int y = 0; y <= size / 2; ++y)
    for (int x = 0; x < size; ++x) {
      const int mirror_x = wrap(-x, size);
      const int mirror_y = wrap(-y, size);
      if (mirror_y == y && mirror_x < x) continue;  // drawn as its mirror
      const auto turn = static_cast<double>(random.uniform());
      if (mirror_x == x && mirror_y == y) {
        phases(x, y) = turn < 0.5 ? 1.0f : -1.0f;
        continue;
      }
      phases(x, y) = {static_cast<float>(portable_cos(2.0 * kPi * turn)),
                      static_cast<float>(portable_sin(2.0 * kPi * turn))};
      phases(mirror_x, mirror_y) = std::conj(phases(x, y));
    }
  return phases;
}

Image<float> realise_noise(ImageView<const float> spectrum, ImageView<const std::complex<float>> phases) {
  assert(same_size(spectrum, phases));
  Image<std::complex<float>> transform(spectrum.width(), spectrum.height());
  const auto texels = static_cast<float>(spectrum.size());
  for (size_t i = 0; i < spectrum.size(); ++i) transform.data()[i] = phases.data()[i] * (spectrum.data()[i] * texels);
  return inverse_fft_real<float>(transform);
}

}  // namespace texbake
