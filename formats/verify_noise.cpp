#include "formats/verify_noise.h"

#include <fmt/format.h>

#include <cmath>

#include "formats/noise_planes.h"
#include "libbake/noise/masks.h"

namespace texbake {
namespace {

constexpr double kAxisTolerance = 1e-4;  // three products of floats near 1
constexpr double kFarRatio = 2;          // of variances: clipped tails and the cores that were measured stay within
constexpr double kLeastVariance = 1e-9;  // below it there is no noise to compare: a hundredth of an 8-bit code

std::string pointer_of(size_t k) { return fmt::format("/noise/noises/{}", k); }

/// The first frequency at which S(f) ≠ S(−f) or S(0) ≠ 0, and how many there are.
void check_spectrum(const Image<float>& spectrum, const std::string& file, const std::string& part, IssueLog& log) {
  Issue issue{IssueId::spectrum_form, {.file = file, .part = part}, "", 0};
  for (int y = 0; y < spectrum.height(); ++y)
    for (int x = 0; x < spectrum.width(); ++x) {
      const float mirrored = spectrum(wrap(-x, spectrum.width()), wrap(-y, spectrum.height()));
      const float expected = x == 0 && y == 0 ? 0.0f : mirrored;
      if (spectrum(x, y) == expected || issue.count++ > 0) continue;
      issue.where.texel = V2i(x, y);
      issue.detail = fmt::format("expected {}, found {}", expected, spectrum(x, y));
    }
  if (issue.count > 0) log.add(issue);
}

void check_axes(const ColorBasis& basis, size_t k, IssueLog& log) {
  for (size_t a = 0; a < 3; ++a)
    for (size_t b = a; b < 3; ++b) {
      const auto product = static_cast<double>(basis.axis[a].dot(basis.axis[b]));
      const double expected = a == b ? 1 : 0;
      if (std::abs(product - expected) <= kAxisTolerance) continue;
      return log.add(
          {IssueId::noise_axes,
           {.pointer = pointer_of(k) + "/axes"},
           fmt::format("expected axes {} and {} to have the product {}, found {}", a, b, expected, product)});
    }
}

double power_of(const Noise& noise) {
  double power = 0;
  for (const NoiseChannel& channel : noise.channels) power += spectrum_power(channel.spectrum);
  return power;
}

/// Sums of weighted colors and of their squares.
struct Moments {
  double weight = 0;
  Imath::V3d sum{0};
  double squares = 0;

  void add(const V3f& color, double by) {
    const Imath::V3d c(color);
    weight += by;
    sum += c * by;
    squares += c.dot(c) * by;
  }
  /// Of all channels together.
  double variance() const {
    if (weight <= 0) return 0;
    const Imath::V3d mean = sum / weight;
    return squares / weight - mean.dot(mean);
  }
};

bool is_far(double a, double b) {
  if (a < kLeastVariance && b < kLeastVariance) return false;
  return a > kFarRatio * b || b > kFarRatio * a;
}

void check_tile(const Noise& noise, size_t k, IssueLog& log) {
  Moments moments;
  for (const V3f& color : noise.tile) moments.add(color, 1);
  const double expected = power_of(noise);
  if (is_far(moments.variance(), expected))
    log.add({IssueId::noise_tile,
             {.pointer = pointer_of(k) + "/tile"},
             fmt::format("expected a variance of about {:.3g}, found {:.3g}", expected, moments.variance())});
}

void check_strength(const Image<V3f>& layer, const Image<float>& mask, const Noise& noise, size_t k, IssueLog& log) {
  Moments moments;
  for (size_t i = 0; i < mask.size(); ++i)
    if (mask.data()[i] > 0.5f) moments.add(layer.data()[i], 1);
  const double expected = power_of(noise);
  if (moments.weight > 0 && is_far(moments.variance(), expected))
    log.add({IssueId::noise_strength,
             {.pointer = pointer_of(k)},
             fmt::format("expected a variance of about {:.3g}, found {:.3g}", moments.variance(), expected)});
}

bool has_both_layers(const LoadedBundle& loaded, size_t scale) {
  const std::set<std::string>& read = loaded.planes[scale];
  return read.contains("exemplar") && read.contains("structure") && read.contains(kMasksKey);
}

}  // namespace

void check_mask_sums(const ScaleUnderTest& test, IssueLog& log) {
  const std::vector<Image<float>>& masks = test.scale.masks;
  Issue issue{IssueId::mask_sum, {.file = test.file, .part = "mask"}, "", 0};
  for (int y = 0; y < test.size.y; ++y)
    for (int x = 0; x < test.size.x; ++x) {
      float sum = 0;
      bool whole = true;
      for (const Image<float>& mask : masks) {
        const float steps = mask(x, y) * kMaskSteps;
        whole = whole && steps == std::floor(steps);
        sum += mask(x, y);  // exact: multiples of 1/2048 up to 4
      }
      if ((whole && sum == 1.0f) || issue.count++ > 0) continue;
      issue.where.texel = V2i(x, y);
      issue.detail = whole ? fmt::format("expected the sum 1, found {}", sum)
                           : std::string("expected multiples of 1/2048, found another weight");
    }
  if (issue.count > 0) log.add(issue);
}

void check_noise(const LoadedBundle& loaded, IssueLog& log) {
  if (!loaded.bundle.noise || !loaded.has_whole_noise()) return;
  const std::vector<Noise>& noises = loaded.bundle.noise->noises;
  const size_t finest = loaded.refs.size() - 1;
  for (size_t k = 0; k < noises.size(); ++k) {
    const PlaneRef& ref = loaded.noise_refs.spectra[k];
    for (const NoiseChannel& channel : noises[k].channels)
      check_spectrum(channel.spectrum, ref.file, ref.shape.part, log);
    check_axes(noises[k].basis, k, log);
    check_tile(noises[k], k, log);
  }
  if (!has_both_layers(loaded, finest)) return;
  const Scale& scale = loaded.bundle.scales[finest];
  const Image<V3f> layer = noise_layer(scale.exemplar, *scale.structure, loaded.bundle.noise->space);
  for (size_t k = 0; k < noises.size(); ++k) check_strength(layer, scale.masks[k], noises[k], k, log);
}

}  // namespace texbake
