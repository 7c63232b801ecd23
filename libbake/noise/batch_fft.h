// Short Fourier transforms, four of them at a time. Based on: Cooley and Tukey 1965, decimation in time.
#pragma once

#include <array>
#include <utility>

#include "libbake/noise/lanes.h"

namespace texbake {

/// cos and sin of 2πi/16.
inline constexpr float kCos16[16] = {
    1.0f,  0.923879533f,  0.707106781f,  0.382683432f,  0.0f, -0.382683432f, -0.707106781f, -0.923879533f,
    -1.0f, -0.923879533f, -0.707106781f, -0.382683432f, 0.0f, 0.382683432f,  0.707106781f,  0.923879533f};
inline constexpr float cos16(int i) { return kCos16[i & 15]; }
inline constexpr float sin16(int i) { return kCos16[(i + 12) & 15]; }

/// In place: re + i·im becomes Σ_n (re + i·im)[n] · exp(−2πi n f / N). N is 2, 4, 8 or 16; not normalized.
template <int N>
inline void batch_fft(std::array<Lanes, N>& re, std::array<Lanes, N>& im) {
  static_assert(N == 2 || N == 4 || N == 8 || N == 16);
  // Bit-reversed order.
  for (int i = 1, j = 0; i < N; ++i) {
    int bit = N / 2;
    for (; (j & bit) != 0; bit /= 2) j ^= bit;
    j ^= bit;
    if (i < j) {
      std::swap(re[static_cast<size_t>(i)], re[static_cast<size_t>(j)]);
      std::swap(im[static_cast<size_t>(i)], im[static_cast<size_t>(j)]);
    }
  }
  // Butterflies over lengths 2, 4, … N.
  for (int length = 2; length <= N; length *= 2)
    for (int begin = 0; begin < N; begin += length)
      for (int i = 0; i < length / 2; ++i) {
        const auto a = static_cast<size_t>(begin + i);
        const auto b = static_cast<size_t>(begin + i + length / 2);
        const float c = cos16(i * (16 / length));
        const float s = -sin16(i * (16 / length));
        const Lanes b_re = re[b] * c - im[b] * s;
        const Lanes b_im = re[b] * s + im[b] * c;
        re[b] = re[a] - b_re;
        im[b] = im[a] - b_im;
        re[a] += b_re;
        im[a] += b_im;
      }
}

}  // namespace texbake
