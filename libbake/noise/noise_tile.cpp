// Every realisation is one inverse transform; the phases are drawn in reading order of the upper half of the
// frequencies.
#include "libbake/noise/noise_tile.h"

#include <cassert>
#include <cmath>

#include "libbake/base/fft.h"
#include "libbake/base/portable_math.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The mean over 2^level texels from texel 0 on, along one axis: Π cos(π 2^j f), and the phase of its centre.
std::complex<double> box_transfer(double f_cpp, int level) {
  double magnitude = 1.0;
  for (int j = 0; j < level; ++j) magnitude *= portable_cos(kPi * f_cpp * (1 << j));
  const double angle = kPi * f_cpp * ((1 << level) - 1);
  return {magnitude * portable_cos(angle), magnitude * portable_sin(angle)};
}

/// The transform of one channel, faded and cut to the frequencies below the Nyquist limit of the level.
Image<std::complex<float>> fade(const Image<std::complex<float>>& transform, int level) {
  const int from = transform.width();
  const int size = from >> level;
  std::vector<std::complex<double>> along(static_cast<size_t>(size));
  for (int i = 0; i < size; ++i)
    if (2 * i != size)
      along[static_cast<size_t>(i)] = box_transfer(shortest(i, size) / static_cast<double>(from), level);
  Image<std::complex<float>> faded(size, size);
  const double scale = 1.0 / (static_cast<double>(1 << level) * (1 << level));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const std::complex<double> value = transform(wrap(shortest(x, size), from), wrap(shortest(y, size), from));
      faded(x, y) = std::complex<float>(value * along[static_cast<size_t>(x)] * along[static_cast<size_t>(y)] * scale);
    }
  return faded;
}

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

std::vector<Image<V3f>> noise_levels(ImageView<const V3f> tile, int levels) {
  std::vector<Image<V3f>> result;
  for (int level = 0; level < levels; ++level) result.emplace_back(tile.width() >> level, tile.height() >> level);
  for (int c = 0; c < 3; ++c) {
    Image<float> channel(tile.width(), tile.height());
    for (size_t i = 0; i < tile.size(); ++i) channel.data()[i] = tile.data()[i][c];
    const Image<std::complex<float>> transform = fft<float>(channel);
    for (int level = 0; level < levels; ++level) {
      const Image<float> plane = level == 0 ? channel.clone() : inverse_fft_real<float>(fade(transform, level));
      for (size_t i = 0; i < plane.size(); ++i) result[static_cast<size_t>(level)].data()[i][c] = plane.data()[i];
    }
  }
  return result;
}

double level_transfer_power(double fx_cpp, double fy_cpp, int level) {
  const double limit = 0.5 / (1 << level);
  if (level > 0 && (std::fabs(fx_cpp) >= limit || std::fabs(fy_cpp) >= limit)) return 0.0;
  return std::norm(box_transfer(fx_cpp, level)) * std::norm(box_transfer(fy_cpp, level));
}

}  // namespace texbake
