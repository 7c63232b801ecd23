// Masks are measured one after the other; the channels of all of them are worked on side by side.
#include "libbake/noise/estimate_psd.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "libbake/base/error.h"
#include "libbake/base/half.h"
#include "libbake/base/parallel.h"
#include "libbake/noise/masks.h"
#include "libbake/noise/noise_tile.h"
#include "libbake/noise/spectrum_difference.h"

namespace texbake {
namespace {

constexpr int kDefaultLocalSize = 8;

void check_input(ImageView<const V3f> exemplar, ImageView<const V3f> structure, std::span<const Image<float>> masks,
                 const EstimatePsdOptions& options) {
  check_options(options);
  for (const auto& [name, value] :
       {std::pair("spectrum-size", options.spectrum_size), std::pair("noise-tile", options.tile_size)})
    if ((value & (value - 1)) != 0)
      throw Error(ErrorKind::usage, fmt::format("--{}: expected a power of two, found {}", name, value));
  check_masks(masks);
  if (!same_size(exemplar, structure) || !same_size(exemplar, masks.front()))
    throw Error(ErrorKind::bad_data,
                fmt::format("expected exemplar, structure and masks of one size, found {} x {}, {} x {} and {} x {}",
                            exemplar.width(), exemplar.height(), structure.width(), structure.height(),
                            masks.front().width(), masks.front().height()));
}

/// The texels each noise is measured on: the core of its cluster. Where the exemplar has no local spectra (it is too
/// small or constant) all texels of the cluster.
std::vector<Image<uint8_t>> measured_texels(ImageView<const V3f> exemplar, NoiseSpace space,
                                            std::span<const Image<float>> masks, const EstimatePsdOptions& options) {
  const Image<V3f> values = in_noise_space(exemplar, space);
  const Image<float> light = luminance(values);
  const int local_size = options.local_size.value_or(kDefaultLocalSize);
  const bool has_spectra =
      std::min(exemplar.width(), exemplar.height()) >= 2 * local_size && standard_deviation(light) > 1e-6;
  if (options.core_share < 1.0f && has_spectra) {
    const LocalSpectra spectra(light, local_size);
    return cluster_cores(GrainFeatures(values, spectra, 1.0), masks, static_cast<double>(options.core_share));
  }
  const Image<uint8_t> strongest = strongest_mask(masks);
  std::vector<Image<uint8_t>> cores;
  for (size_t k = 0; k < masks.size(); ++k) {
    cores.emplace_back(strongest.width(), strongest.height());
    for (size_t i = 0; i < strongest.size(); ++i) cores[k].data()[i] = strongest.data()[i] == k ? 1 : 0;
  }
  return cores;
}

Image<float> channel_of(ImageView<const V3f> noise, const ColorBasis& basis, size_t channel) {
  Image<float> plane(noise.width(), noise.height());
  for (size_t i = 0; i < noise.size(); ++i) plane.data()[i] = (noise.data()[i] - basis.mean).dot(basis.axis[channel]);
  return plane;
}

struct Moments {
  double variance = 0;
  double excess_kurtosis = 0;
};

Moments moments(ImageView<const float> channel, ImageView<const uint8_t> mask, double mean) {
  double second = 0.0;
  double fourth = 0.0;
  double count = 0.0;
  for (size_t i = 0; i < channel.size(); ++i) {
    if (mask.data()[i] == 0) continue;
    const double square =
        (static_cast<double>(channel.data()[i]) - mean) * (static_cast<double>(channel.data()[i]) - mean);
    second += square;
    fourth += square * square;
    count += 1.0;
  }
  if (!(second > 0.0)) return {};
  return {second / count, fourth / count / (second / count * second / count) - 3.0};
}

/// One noise while it is being made.
struct Work {
  Image<uint8_t> texels;
  std::optional<MaskedSpectrum> estimator;  // none where the noise is zero
};

bool is_zero(ImageView<const V3f> noise, ImageView<const uint8_t> texels) {
  for (size_t i = 0; i < noise.size(); ++i)
    if (texels.data()[i] != 0 && noise.data()[i] != V3f(0)) return false;
  return true;
}

void estimate_channel(ImageView<const V3f> layer, const Work& work, const EstimatePsdOptions& options, size_t c,
                      Noise& noise) {
  NoiseChannel& channel = noise.channels[c];
  if (!work.estimator) {
    channel.spectrum = Image<float>(options.spectrum_size, options.spectrum_size);
    channel.equalization.values.assign(Equalization::kEntries, 0.0f);
    return;
  }
  const Image<float> plane = channel_of(layer, noise.basis, c);
  const double mean = masked_mean(plane, work.texels);
  const Moments measured = moments(plane, work.texels, mean);
  noise.figures.variance[c] = measured.variance;
  noise.figures.excess_kurtosis[c] = measured.excess_kurtosis;
  channel.spectrum = work.estimator->estimate(plane);
  channel.equalization = match_histogram(plane, work.texels, mean);
  if (options.lobes == 0) return;
  channel.lobes = fit_lobes(channel.spectrum, options.lobes);
  if (channel.lobes.error > static_cast<double>(options.lobe_error)) channel.lobes.lobes.clear();
}

/// One channel of all values, equalized where the options say so.
Image<float> realise_channel(const NoiseChannel& channel, const NoiseLattice& lattice,
                             ImageView<const std::complex<float>> phases, NoiseHistogram histogram) {
  Image<float> plane = realise_noise(lattice_spectrum(channel.spectrum, lattice), phases);
  const double deviation = std::sqrt(spectrum_power(channel.spectrum));
  if (histogram == NoiseHistogram::gaussian || !(deviation > 0.0)) return plane;
  for (float& value : plane) value = channel.equalization(static_cast<double>(value) / deviation);
  return plane;
}

/// How far equalization has moved the first channel from its model.
void measure_tile(ImageView<const float> channel, const NoiseLattice& lattice, Noise& noise) {
  const Image<float>& model = noise.channels[0].spectrum;
  if (!(spectrum_power(model) > 0.0)) return;
  const Image<float> measured = periodogram(channel);
  noise.figures.tile_difference_db = spectrum_difference_db(measured, lattice_spectrum(model, lattice), lattice);
  noise.figures.tile_variance_ratio = spectrum_power(measured) / spectrum_power(model);
}

void bake_tiles(NoiseModel& model, const EstimatePsdOptions& options) {
  const int size = options.tile_size;
  model.lattice = noise_lattice(size);
  const NoiseLattice& lattice = model.lattice;
  std::vector<Noise>& noises = model.noises;
  std::array<Image<std::complex<float>>, 3> phases;
  parallel_for(0, 3, [&](int c) { phases[static_cast<size_t>(c)] = random_phases(lattice.count, options.seed, c); });
  std::vector<std::array<Image<float>, 3>> planes(noises.size());
  parallel_for(0, static_cast<int>(3 * noises.size()), [&](int i) {
    const auto k = static_cast<size_t>(i / 3);
    const auto c = static_cast<size_t>(i % 3);
    planes[k][c] = realise_channel(noises[k].channels[c], lattice, phases[c], options.histogram);
    if (c == 0) measure_tile(planes[k][c], lattice, noises[k]);
  });
  parallel_for(0, static_cast<int>(noises.size()), [&](int i) {
    const auto k = static_cast<size_t>(i);
    noises[k].tile = Image<V3f>(size, size);
    for (size_t p = 0; p < noises[k].tile.size(); ++p)
      noises[k].tile.data()[p] =
          half_exact(noises[k].basis.color({planes[k][0].data()[p], planes[k][1].data()[p], planes[k][2].data()[p]}));
  });
}

std::vector<std::string> warnings_of(const std::vector<Noise>& noises, const EstimatePsdOptions& options) {
  std::vector<std::string> warnings;
  for (size_t k = 0; k < noises.size(); ++k) {
    if (noises[k].spectrum_size() < options.spectrum_size)
      warnings.push_back(
          fmt::format("noise {}: its mask has {} texels, too few for a spectrum of {} x {}; {} x {} is used instead", k,
                      noises[k].figures.texels, options.spectrum_size, options.spectrum_size, noises[k].spectrum_size(),
                      noises[k].spectrum_size()));
    if (noises[k].figures.used_share < 0.5)
      warnings.push_back(
          fmt::format("noise {}: only {:.0f} % of its texels lie in windows that its mask covers to at least 70 %; "
                      "--estimator autocovariance uses all of them",
                      k, 100.0 * noises[k].figures.used_share));
  }
  return warnings;
}

}  // namespace

Image<V3f> noise_layer(ImageView<const V3f> exemplar, ImageView<const V3f> structure, NoiseSpace space) {
  Image<V3f> noise = in_noise_space(exemplar, space);
  const Image<V3f> beneath = in_noise_space(structure, space);
  for (size_t i = 0; i < noise.size(); ++i) noise.data()[i] -= beneath.data()[i];
  return noise;
}

NoiseModel estimate_psd(ImageView<const V3f> exemplar, ImageView<const V3f> structure,
                        std::span<const Image<float>> masks, const EstimatePsdOptions& options,
                        const Progress& progress) {
  check_input(exemplar, structure, masks, options);
  NoiseModel model;
  model.space = options.space.value_or(NoiseSpace::root);
  const Image<V3f> layer = noise_layer(exemplar, structure, model.space);
  std::vector<Image<uint8_t>> cores = measured_texels(exemplar, model.space, masks, options);
  report_progress(progress, 0.2);

  // Color spaces, the later ones matched to the first.
  model.noises.resize(masks.size());
  std::vector<Work> work(masks.size());
  parallel_for(0, static_cast<int>(masks.size()), [&](int i) {
    const auto k = static_cast<size_t>(i);
    work[k].texels = std::move(cores[k]);
    model.noises[k].basis = principal_basis(layer, work[k].texels);
    model.noises[k].figures.texels = std::count(work[k].texels.begin(), work[k].texels.end(), 1);
    if (is_zero(layer, work[k].texels)) return;
    work[k].estimator.emplace(work[k].texels, options.spectrum_size, options.estimator);
    model.noises[k].figures.used_share = work[k].estimator->used_share();
  });
  for (size_t k = 1; k < masks.size(); ++k)
    model.noises[k].basis = match_axes(model.noises[k].basis, model.noises[0].basis);
  report_progress(progress, 0.4);

  // Spectra, histograms and lobes, then tiles.
  parallel_for(0, static_cast<int>(3 * masks.size()), [&](int i) {
    const auto k = static_cast<size_t>(i / 3);
    estimate_channel(layer, work[k], options, static_cast<size_t>(i % 3), model.noises[k]);
  });
  report_progress(progress, 0.8);
  bake_tiles(model, options);
  model.warnings = warnings_of(model.noises, options);
  report_progress(progress, 1.0);
  return model;
}

Image<V3f> synthesise_noise(const NoiseModel& model, std::span<const Image<float>> masks) {
  const int width = masks.front().width();
  const int height = masks.front().height();
  Image<V3f> noise(width, height);
  for (size_t k = 0; k < masks.size(); ++k) {
    const Image<V3f>& tile = model.noises[k].tile;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        noise(x, y) +=
            tile.data()[model.lattice.index(static_cast<uint32_t>(x), static_cast<uint32_t>(y))] * masks[k](x, y);
  }
  return noise;
}

Image<V3f> synthesise(ImageView<const V3f> structure, const NoiseModel& model, std::span<const Image<float>> masks) {
  Image<V3f> sum = in_noise_space(structure, model.space);
  const Image<V3f> noise = synthesise_noise(model, masks);
  for (size_t i = 0; i < sum.size(); ++i) sum.data()[i] += noise.data()[i];
  return to_light(sum, model.space);
}

}  // namespace texbake
