// Clusters are found on a lattice of texels (neighboring spectra are nearly equal), then every texel is assigned.
#include "libbake/noise/masks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "libbake/base/error.h"
#include "libbake/base/parallel.h"
#include "libbake/noise/lanes.h"

namespace texbake {
namespace {

constexpr int kBandRows = 32;

/// Calls body(features, y) for every row y of the image.
template <class Body>
void for_each_row(const GrainFeatures& features, int height, const Body& body) {
  parallel_for(0, (height + kBandRows - 1) / kBandRows, [&](int band) {
    const int begin = band * kBandRows;
    const int end = std::min(begin + kBandRows, height);
    const SpectraRows rows = features.rows(begin, end);
    for (int y = begin; y < end; ++y) body(rows, y);
  });
}

/// ‖f(x) − center‖² of four texels from x.
Lanes squared_distances(const SpectraRows& features, int y, int x, const float* center) {
  Lanes sum{};
  const float* in = features.row(y, 0) + x;
  for (int d = 0; d < features.bins(); ++d, in += features.stride()) {
    const Lanes difference = load_lanes(in) - splat(center[d]);
    sum += difference * difference;
  }
  return sum;
}

/// Where two noises meet, a local spectrum sees both: half of the power of each. On the way from center a to center b,
/// in logarithms, that mixture does not lie half-way, but at this share: the border between two masks belongs there.
/// Kept within 0.35 … 0.65, as inside a cluster features spread, too.
float mixture_share(const GrainFeatures& features, const float* a, const float* b) {
  double along = 0.0;
  double squared = 0.0;
  for (int d = 0; d < features.dimensions(); ++d) {
    const double step = static_cast<double>(b[d]) - static_cast<double>(a[d]);
    along += step * (features.mixture(d, a[d], b[d]) - static_cast<double>(a[d]));
    squared += step * step;
  }
  return squared > 0.0 ? static_cast<float>(std::clamp(along / squared, 0.35, 0.65)) : 0.5f;
}

/// The centers, and for each pair where the border between them lies.
struct Borders {
  Borders(const GrainFeatures& features, const Vectors& all_centers)
      : centers(all_centers),
        count(static_cast<size_t>(centers.count())),
        share(count * count),
        squared(count * count) {
    for (size_t a = 0; a < count; ++a)
      for (size_t b = 0; b < count; ++b) {
        const float* from = centers.row(static_cast<int>(a));
        const float* to = centers.row(static_cast<int>(b));
        squared[a * count + b] = squared_distance(from, to, centers.stride());
        share[a * count + b] = a < b ? mixture_share(features, from, to) : 1.0f - mixture_share(features, to, from);
      }
  }
  /// The cluster of a texel at these squared distances from the centers: the nearest one, or the second nearest where
  /// the texel is past the border between the two.
  size_t cluster(const float* distances) const {
    size_t nearest = 0;
    for (size_t k = 1; k < count; ++k)
      if (distances[k] < distances[nearest]) nearest = k;
    size_t second = nearest;
    for (size_t k = 0; k < count; ++k)
      if (k != nearest && (second == nearest || distances[k] < distances[second])) second = k;
    if (second == nearest) return nearest;
    const size_t pair = nearest * count + second;
    const float along = distances[nearest] - distances[second] + squared[pair];  // 2 · squared · the share of the way
    return along > 2.0f * squared[pair] * share[pair] ? second : nearest;
  }
  const Vectors& centers;
  size_t count;
  std::vector<float> share;
  std::vector<float> squared;
};

void assign_binary(const SpectraRows& features, int y, const Borders& borders, std::vector<Image<float>>& masks) {
  const int width = masks.front().width();
  std::vector<Lanes> squared(borders.count);
  std::vector<float> distances(borders.count);
  for (int x = 0; x < width; x += kLanes) {
    for (size_t k = 0; k < borders.count; ++k)
      squared[k] = squared_distances(features, y, x, borders.centers.row(static_cast<int>(k)));
    for (int i = 0; i < kLanes && x + i < width; ++i) {
      for (size_t k = 0; k < borders.count; ++k) distances[k] = squared[k][i];
      masks[borders.cluster(distances.data())](x + i, y) = 1.0f;
    }
  }
}

/// Orthonormal axes of the affine hull of the centers, and the centers in them. Origin: center 0.
struct Hull {
  explicit Hull(const Vectors& centers) : axes(centers.count() - 1, centers.dimensions()) {
    for (int k = 1; k < centers.count(); ++k) {
      std::vector<double> axis(static_cast<size_t>(centers.dimensions()));
      for (size_t d = 0; d < axis.size(); ++d)
        axis[d] = static_cast<double>(centers.row(k)[d]) - static_cast<double>(centers.row(0)[d]);
      // Gram and Schmidt; an axis that the earlier ones already span stays zero.
      const double length_before = std::sqrt(std::inner_product(axis.begin(), axis.end(), axis.begin(), 0.0));
      for (int j = 0; j < k - 1; ++j) {
        double dot = 0.0;
        for (size_t d = 0; d < axis.size(); ++d) dot += axis[d] * static_cast<double>(axes.row(j)[d]);
        for (size_t d = 0; d < axis.size(); ++d) axis[d] -= dot * static_cast<double>(axes.row(j)[d]);
      }
      const double length = std::sqrt(std::inner_product(axis.begin(), axis.end(), axis.begin(), 0.0));
      if (length > 1e-4 * length_before)
        for (size_t d = 0; d < axis.size(); ++d) axes.row(k - 1)[d] = static_cast<float>(axis[d] / length);
    }
    for (int k = 0; k < centers.count(); ++k) {
      std::vector<float> place(static_cast<size_t>(axes.count()));
      for (int j = 0; j < axes.count(); ++j)
        for (int d = 0; d < centers.dimensions(); ++d)
          place[static_cast<size_t>(j)] += (centers.row(k)[d] - centers.row(0)[d]) * axes.row(j)[d];
      center_places.push_back(std::move(place));
    }
  }
  Vectors axes;
  std::vector<std::vector<float>> center_places;
};

/// M_k ∝ 1/d_k², d_k the distance to center k inside the affine hull of the centers.
void assign_soft(const SpectraRows& features, int y, const Vectors& centers, const Hull& hull,
                 std::vector<Image<float>>& masks) {
  const int width = masks.front().width();
  const auto count = static_cast<size_t>(centers.count());
  std::vector<Lanes> place(count - 1);
  std::vector<double> weights(count);
  std::vector<float> quantized(count);
  for (int x = 0; x < width; x += kLanes) {
    for (int j = 0; j < hull.axes.count(); ++j) {
      Lanes sum{};
      const float* in = features.row(y, 0) + x;
      for (int d = 0; d < features.bins(); ++d, in += features.stride())
        sum += (load_lanes(in) - splat(centers.row(0)[d])) * hull.axes.row(j)[d];
      place[static_cast<size_t>(j)] = sum;
    }
    for (int i = 0; i < kLanes && x + i < width; ++i) {
      for (size_t k = 0; k < count; ++k) {
        double squared = 1e-12;  // at a center itself its weight is all
        for (size_t j = 0; j + 1 < count; ++j) {
          const double difference = static_cast<double>(place[j][i]) - static_cast<double>(hull.center_places[k][j]);
          squared += difference * difference;
        }
        weights[k] = 1.0 / squared;
      }
      quantize_weights(weights, quantized);
      for (size_t k = 0; k < count; ++k) masks[k](x + i, y) = quantized[k];
    }
  }
}

/// The mean features of the texels of each strongest mask, from the texels of a lattice; empty where it has none there.
std::vector<std::vector<float>> mean_features(const GrainFeatures& features, const Image<uint8_t>& strongest,
                                              size_t masks) {
  const Vectors& samples = features.samples();
  const auto dimensions = static_cast<size_t>(features.dimensions());
  std::vector<std::vector<double>> sum(masks, std::vector<double>(dimensions));
  std::vector<int> count(masks);
  for (int i = 0; i < samples.count(); ++i) {
    const V2i place = features.sample_place(i);
    const size_t k = strongest(place.x, place.y);
    ++count[k];
    for (size_t d = 0; d < dimensions; ++d) sum[k][d] += static_cast<double>(samples.row(i)[d]);
  }
  std::vector<std::vector<float>> mean(masks);
  for (size_t k = 0; k < masks; ++k)
    for (size_t d = 0; d < dimensions && count[k] > 0; ++d) mean[k].push_back(static_cast<float>(sum[k][d] / count[k]));
  return mean;
}

/// The distance that `share` of the texels of label k do not exceed.
float distance_of_share(const Image<float>& distance, const Image<uint8_t>& label, size_t k, double share) {
  std::vector<float> own;
  for (size_t i = 0; i < label.size(); ++i)
    if (label.data()[i] == k) own.push_back(distance.data()[i]);
  if (own.empty()) return 0.0f;
  const auto rank = static_cast<size_t>(share * static_cast<double>(own.size() - 1));
  std::nth_element(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(rank), own.end());
  return own[rank];
}

}  // namespace

void quantize_weights(std::span<const double> weights, std::span<float> quantized) {
  constexpr size_t kMost = 64;
  assert(weights.size() == quantized.size() && weights.size() <= kMost);
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::array<int, kMost> steps;
  std::array<double, kMost> remainder;
  int left = kMaskSteps;
  for (size_t k = 0; k < weights.size(); ++k) {
    const double exact = weights[k] / total * kMaskSteps;
    steps[k] = static_cast<int>(std::floor(exact));
    remainder[k] = exact - steps[k];
    left -= steps[k];
  }
  for (; left > 0; --left) {
    const auto largest = std::max_element(remainder.begin(), remainder.begin() + weights.size());
    ++steps[static_cast<size_t>(largest - remainder.begin())];
    *largest = -1.0;
  }
  for (size_t k = 0; k < weights.size(); ++k) quantized[k] = static_cast<float>(steps[k]) / kMaskSteps;
}

void check_masks(std::span<const Image<float>> masks) {
  if (masks.empty()) throw Error(ErrorKind::bad_data, "masks: expected at least one, found none");
  for (const Image<float>& mask : masks)
    if (!same_size(mask, masks.front()))
      throw Error(ErrorKind::bad_data,
                  fmt::format("masks: expected planes of one size, found {} x {} and {} x {}", masks.front().width(),
                              masks.front().height(), mask.width(), mask.height()));
  const int width = masks.front().width();
  for (size_t i = 0; i < masks.front().size(); ++i) {
    const int x = static_cast<int>(i) % width;
    const int y = static_cast<int>(i) / width;
    double sum = 0.0;
    for (size_t k = 0; k < masks.size(); ++k) {
      const double weight = static_cast<double>(masks[k].data()[i]);
      const double steps = weight * kMaskSteps;
      if (!(weight >= 0.0) || steps != std::floor(steps))
        throw Error(ErrorKind::bad_data,
                    fmt::format("mask {}, texel ({}, {}): expected a multiple of 1/{} ≥ 0, found {}", k, x, y,
                                kMaskSteps, weight));
      sum += weight;
    }
    if (sum != 1.0)
      throw Error(ErrorKind::bad_data,
                  fmt::format("masks, texel ({}, {}): expected weights that sum to 1, found {}", x, y, sum));
  }
}

Vectors cluster_grain(const GrainFeatures& features, int noises, uint32_t seed) {
  const Clustering found = k_means(features.samples(), {.clusters = noises, .restarts = 5, .seed = seed});
  std::vector<int> order(static_cast<size_t>(noises));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return features.luminance_of(found.centers.row(a)) < features.luminance_of(found.centers.row(b));
  });
  Vectors centers(noises, features.dimensions());
  for (int k = 0; k < noises; ++k)
    std::copy_n(found.centers.row(order[static_cast<size_t>(k)]), centers.stride(), centers.row(k));
  return centers;
}

std::vector<Image<float>> assign_masks(const GrainFeatures& features, const Vectors& centers, MaskKind kind) {
  std::vector<Image<float>> masks;
  for (int k = 0; k < centers.count(); ++k) masks.emplace_back(features.width(), features.height());
  const Hull hull(centers);
  const Borders borders(features, centers);
  for_each_row(features, features.height(), [&](const SpectraRows& rows, int y) {
    if (kind == MaskKind::binary)
      assign_binary(rows, y, borders, masks);
    else
      assign_soft(rows, y, centers, hull, masks);
  });
  return masks;
}

Image<uint8_t> strongest_mask(std::span<const Image<float>> masks) {
  Image<uint8_t> strongest(masks.front().width(), masks.front().height());
  for (size_t i = 0; i < strongest.size(); ++i) {
    size_t best = 0;
    for (size_t k = 1; k < masks.size(); ++k)
      if (masks[k].data()[i] > masks[best].data()[i]) best = k;
    strongest.data()[i] = static_cast<uint8_t>(best);
  }
  return strongest;
}

std::vector<Image<uint8_t>> cluster_cores(const GrainFeatures& features, std::span<const Image<float>> masks,
                                          double share) {
  const Image<uint8_t> strongest = strongest_mask(masks);
  const std::vector<std::vector<float>> centers = mean_features(features, strongest, masks.size());

  // Distance of each texel to the center of its own cluster.
  Image<float> distance(strongest.width(), strongest.height());
  for_each_row(features, features.height(), [&](const SpectraRows& rows, int y) {
    for (int x = 0; x < strongest.width(); x += kLanes)
      for (size_t k = 0; k < masks.size(); ++k) {
        bool present = false;
        for (int i = 0; i < kLanes && x + i < strongest.width(); ++i) present = present || strongest(x + i, y) == k;
        if (!present || centers[k].empty()) continue;
        const Lanes squared = squared_distances(rows, y, x, centers[k].data());
        for (int i = 0; i < kLanes && x + i < strongest.width(); ++i)
          if (strongest(x + i, y) == k) distance(x + i, y) = squared[i];
      }
  });

  std::vector<Image<uint8_t>> cores;
  for (size_t k = 0; k < masks.size(); ++k) {
    const float most = distance_of_share(distance, strongest, k, share);
    Image<uint8_t> core(strongest.width(), strongest.height());
    for (size_t i = 0; i < core.size(); ++i)
      core.data()[i] = strongest.data()[i] == k && distance.data()[i] <= most ? 1 : 0;
    cores.push_back(std::move(core));
  }
  return cores;
}

}  // namespace texbake
