#include "libbake/noise/structure.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

Image<V3f> colored(const Image<float>& light) {
  Image<V3f> image(light.width(), light.height());
  for (size_t i = 0; i < image.size(); ++i)
    image.data()[i] = V3f(0.5f, 0.4f, 0.3f) + V3f(1.0f, 0.5f, -0.25f) * light.data()[i];
  return image;
}

/// The filter as the header writes it, in double.
Image<V3f> slow_structure(const Image<V3f>& image, const LocalSpectra& guide, double sigma, int iterations) {
  const int width = image.width();
  const int height = image.height();
  const SpectraRows rows = guide.rows(0, height);
  Image<V3f> from = image.clone();
  for (int iteration = 0; iteration < iterations; ++iteration) {
    Image<V3f> to(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        double total = 0.0;
        double sum[3] = {};
        for (int dy = kFilterBegin; dy <= kFilterEnd; ++dy)
          for (int dx = kFilterBegin; dx <= kFilterEnd; ++dx) {
            const int sx = wrap(x + dx, width);
            const int sy = wrap(y + dy, height);
            double squared = 0.0;
            for (int b = 0; b < rows.bins(); ++b) {
              const double d = double(rows.row(y, b)[x]) - double(rows.row(sy, b)[sx]);
              squared += d * d;
            }
            const double weight = std::exp(-squared / (2.0 * sigma * sigma));
            total += weight;
            for (int c = 0; c < 3; ++c) sum[c] += weight * double(from(sx, sy)[c]);
          }
        for (int c = 0; c < 3; ++c) to(x, y)[c] = float(sum[c] / total);
      }
    from = std::move(to);
  }
  return from;
}

TEST(Structure, EqualsTheSlowTwin) {
  const Image<float> light = synthetic_noise(ring_power, 37, 0.01, 4);  // no multiple of the lanes
  const Image<V3f> image = colored(light);
  for (const int size : {2, 8}) {
    const LocalSpectra guide(light, size);
    const Image<V3f> fast = extract_structure(image, guide, {.sigma = 0.02, .iterations = 2});
    const Image<V3f> slow = slow_structure(image, guide, 0.02, 2);
    for (size_t i = 0; i < fast.size(); ++i)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(fast.data()[i][c], slow.data()[i][c], 2e-4);  // up to 255 weights, each rounded to 2^-17
  }
}

TEST(Structure, LeavesAFlatColorAlone) {
  const Image<float> light = synthetic_noise(ring_power, 32, 0.01, 4);
  const Image<V3f> flat(32, 32, V3f(0.25f, 0.5f, 0.75f));
  const Image<V3f> structure = extract_structure(flat, LocalSpectra(light, 4));
  for (const V3f& c : structure) EXPECT_NEAR((c - V3f(0.25f, 0.5f, 0.75f)).length(), 0.0f, 1e-5f);  // rounding of sums
}

TEST(Structure, KeepsAnEdgeBetweenTwoGrains) {
  const Image<float> grain = synthetic_noise(ring_power, 64, 1e-4, 1);
  Image<V3f> image(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) image(x, y) = V3f((x < 32 ? 0.2f : 0.8f) + grain(x, y));
  const Image<float> light = luminance(image);
  const Image<V3f> structure = extract_structure(image, LocalSpectra(light, 2));
  for (int y = 0; y < 64; ++y) {
    EXPECT_NEAR(structure(29, y).x, 0.2f, 0.03f);  // 3 σ of the grain
    EXPECT_NEAR(structure(35, y).x, 0.8f, 0.03f);
  }
}

TEST(Structure, DoesNotDependOnThreads) {
  const Image<float> light = synthetic_noise(blob_power, 80, 0.01, 4);
  const Image<V3f> image = colored(light);
  const LocalSpectra guide(light, 4);
  const Image<V3f> many = extract_structure(image, guide);
  tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_TRUE(many == extract_structure(image, guide));
}

}  // namespace
}  // namespace texbake
