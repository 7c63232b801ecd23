#include "libbake/quality/fidelity.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/gaussian.h"

namespace texbake {
namespace {

constexpr int kDirections = 64;
constexpr int kQuantiles = 1024;

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

std::vector<float> sorted_projection(ImageView<const V3f> image, const V3f& axis) {
  std::vector<float> values;
  values.reserve(image.size());
  for (const V3f& c : image) values.push_back(c.dot(axis));
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

std::vector<float> sorted_gradients(ImageView<const V3f> image) {
  std::vector<float> magnitudes;
  for (int y = 0; y + 1 < image.height(); ++y)
    for (int x = 0; x + 1 < image.width(); ++x) {
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
  double sum = 0.0;
  for (int i = 0; i < kDirections; ++i) {
    const std::vector<float> expected = sorted_projection(exemplar_luv, direction(i));
    const std::vector<float> found = sorted_projection(rendering_luv, direction(i));
    for (int q = 0; q < kQuantiles; ++q) {
      const double difference = quantile(expected, q) - quantile(found, q);
      sum += difference * difference / kQuantiles;
    }
  }
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
  const int n = std::min(exemplar_luv.width(), exemplar_luv.height());
  std::vector<std::optional<double>> ratios;
  Image<V3f> fine_expected;
  Image<V3f> fine_found;
  for (int divisor = 128; divisor >= 8; divisor /= 2) {
    const double sigma_px = static_cast<double>(n) / divisor;
    Image<V3f> expected = gaussian_blur(exemplar_luv, sigma_px, Wrap::repeat);
    Image<V3f> found = gaussian_blur(rendering_luv, sigma_px, Wrap::repeat);
    if (divisor < 128) {
      for (size_t i = 0; i < expected.size(); ++i) fine_expected.data()[i] -= expected.data()[i];
      for (size_t i = 0; i < found.size(); ++i) fine_found.data()[i] -= found.data()[i];
      const double power = total_variance(fine_expected);
      ratios.push_back(power > 1e-6 ? std::optional(std::sqrt(total_variance(fine_found) / power)) : std::nullopt);
    }
    fine_expected = std::move(expected);
    fine_found = std::move(found);
  }
  const double rest = total_variance(fine_expected);
  ratios.push_back(rest > 1e-6 ? std::optional(std::sqrt(total_variance(fine_found) / rest)) : std::nullopt);
  return ratios;
}

}  // namespace texbake
