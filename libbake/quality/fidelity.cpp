#include "libbake/quality/fidelity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "libbake/base/parallel.h"
#include "libbake/quality/low_pass.h"

namespace texbake {
namespace {

constexpr int kDirections = 64;
constexpr int kQuantiles = 1024;
constexpr size_t kMaxSamples = 1 << 16;  // colors: a distance of 0.004 is left to chance
constexpr size_t kMaxGradients = 1 << 19;

// Value of a sorted sample at quantile (i + ½) / kQuantiles, linear between samples.
double quantile(const std::vector<float>& sorted, int i) {
  const double position = (i + 0.5) / kQuantiles * static_cast<double>(sorted.size()) - 0.5;
  const double clamped = std::clamp(position, 0.0, static_cast<double>(sorted.size() - 1));
  const auto low = static_cast<size_t>(clamped);
  const size_t high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (sorted[high] - sorted[low]) * (clamped - static_cast<double>(low));
}

// Directions evenly spread over the sphere: the golden spiral.
V3f direction(int i) {
  const double z = 1.0 - (2.0 * i + 1.0) / kDirections;
  const double radius = std::sqrt(1.0 - z * z);
  const double angle = i * 2.39996322972865332;  // π (3 − √5)
  return {static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle)),
          static_cast<float>(z)};
}

// A step through `size` texels that takes at most `most` of them and visits all columns alike.
size_t even_step(size_t size, int width, size_t most) {
  size_t step = size / (most + 1) + 1;
  while (step > 1 && std::gcd(step, static_cast<size_t>(width)) != 1) ++step;
  return step;
}

// At most kMaxSamples texels, evenly spread over the picture: quantiles need no more.
std::vector<V3f> samples(ImageView<const V3f> image) {
  const size_t step = even_step(image.size(), image.width(), kMaxSamples);
  std::vector<V3f> colors;
  for (size_t i = 0; i < image.size(); i += step) colors.push_back(image.data()[i]);
  return colors;
}

std::vector<float> sorted_projection(const std::vector<V3f>& colors, const V3f& axis) {
  std::vector<float> values;
  values.reserve(colors.size());
  for (const V3f& c : colors) values.push_back(c.dot(axis));
  std::sort(values.begin(), values.end());
  return values;
}

// Variance of each coordinate.
V3f variances(ImageView<const V3f> image) {
  V3f result(0);
  for (int i = 0; i < 3; ++i) {
    double sum = 0.0;
    double squares = 0.0;
    for (const V3f& c : image) {
      sum += c[i];
      squares += static_cast<double>(c[i]) * c[i];
    }
    const auto n = static_cast<double>(image.size());
    result[i] = static_cast<float>(std::max(squares / n - sum * sum / (n * n), 0.0));
  }
  return result;
}
double total_variance(ImageView<const V3f> image) {
  const V3f v = variances(image);
  return static_cast<double>(v.x) + v.y + v.z;
}

// At most kMaxGradients magnitudes, evenly spread over the picture.
std::vector<float> sorted_gradients(ImageView<const V3f> image) {
  std::vector<float> magnitudes;
  const int columns = image.width() - 1;
  if (columns < 1 || image.height() < 2) return magnitudes;
  const size_t count = static_cast<size_t>(columns) * static_cast<size_t>(image.height() - 1);
  const size_t step = even_step(count, columns, kMaxGradients);
  for (size_t i = 0; i < count; i += step) {
    const int x = static_cast<int>(i % static_cast<size_t>(columns));
    const int y = static_cast<int>(i / static_cast<size_t>(columns));
    const float dx = (image(x + 1, y) - image(x, y)).length2();
    const float dy = (image(x, y + 1) - image(x, y)).length2();
    magnitudes.push_back(std::sqrt(dx + dy));
  }
  std::sort(magnitudes.begin(), magnitudes.end());
  return magnitudes;
}
double mean(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

}  // namespace

std::optional<double> color_distance(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv) {
  const double deviation = std::sqrt(total_variance(exemplar_luv));
  if (deviation < 1e-3 || rendering_luv.empty()) return std::nullopt;  // below 0.001 ΔE: float noise
  const std::vector<V3f> expected_colors = samples(exemplar_luv);
  const std::vector<V3f> found_colors = samples(rendering_luv);
  std::array<double, kDirections> squared{};
  parallel_for(0, kDirections, [&](int i) {
    const std::vector<float> expected = sorted_projection(expected_colors, direction(i));
    const std::vector<float> found = sorted_projection(found_colors, direction(i));
    for (int q = 0; q < kQuantiles; ++q) {
      const double difference = quantile(expected, q) - quantile(found, q);
      squared[static_cast<size_t>(i)] += difference * difference / kQuantiles;
    }
  });
  double sum = 0.0;
  for (const double value : squared) sum += value;
  return std::sqrt(sum / kDirections) / deviation;
}

std::optional<GradientMatch> gradient_match(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv) {
  const std::vector<float> expected = sorted_gradients(exemplar_luv);
  const std::vector<float> found = sorted_gradients(rendering_luv);
  if (expected.empty() || found.empty() || mean(expected) <= 0.0) return std::nullopt;
  double distance = 0.0;
  for (int q = 0; q < kQuantiles; ++q) distance += std::fabs(quantile(expected, q) - quantile(found, q)) / kQuantiles;
  return GradientMatch{distance / mean(expected), mean(found) / mean(expected)};
}

std::vector<std::optional<double>> octave_band_ratios(ImageView<const V3f> exemplar_luv,
                                                      ImageView<const V3f> rendering_luv) {
  const V2i size(exemplar_luv.width(), exemplar_luv.height());
  const double finest_px = std::min(size.x, size.y) / 128.0;
  const auto band_variance = [](ImageView<const V3f> image, double sigma_px, int factor) {
    Image<V3f> band = low_pass(image, sigma_px, factor);
    const Image<V3f> coarser = low_pass(image, 2.0 * sigma_px, factor);
    for (size_t i = 0; i < band.size(); ++i) band.data()[i] -= coarser.data()[i];
    return total_variance(band);
  };
  const auto ratio = [](double found, double expected) {
    return expected > 1e-6 ? std::optional(std::sqrt(found / expected)) : std::nullopt;
  };
  std::vector<std::optional<double>> ratios;
  for (double sigma_px = finest_px; sigma_px < 16.0 * finest_px; sigma_px *= 2.0) {
    const int factor = reduction_factor(size, sigma_px);
    ratios.push_back(
        ratio(band_variance(rendering_luv, sigma_px, factor), band_variance(exemplar_luv, sigma_px, factor)));
  }
  const double coarsest_px = 16.0 * finest_px;
  const int factor = reduction_factor(size, coarsest_px);
  ratios.push_back(ratio(total_variance(low_pass(rendering_luv, coarsest_px, factor)),
                         total_variance(low_pass(exemplar_luv, coarsest_px, factor))));
  return ratios;
}

}  // namespace texbake
