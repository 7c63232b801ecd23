// Each restart runs in one thread with sums in index order; restarts run side by side and are compared in order.
#include "libbake/noise/k_means.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "libbake/base/error.h"
#include "libbake/base/parallel.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

struct Nearest {
  int cluster = 0;
  float squared = std::numeric_limits<float>::max();
};

Nearest nearest_center(const float* vector, const Vectors& centers, int count) {
  Nearest nearest;
  for (int k = 0; k < count; ++k) {
    const float squared = squared_distance(vector, centers.row(k), centers.stride());
    if (squared < nearest.squared) nearest = {k, squared};
  }
  return nearest;
}

void copy_row(const Vectors& from, int i, Vectors& to, int k) { std::copy_n(from.row(i), from.stride(), to.row(k)); }

/// k-means++: each further center is a vector drawn with probability ∝ its squared distance to those there are.
Vectors first_centers(const Vectors& vectors, int clusters, Random& random) {
  Vectors centers(clusters, vectors.dimensions());
  copy_row(vectors, static_cast<int>(random.below(static_cast<uint32_t>(vectors.count()))), centers, 0);
  std::vector<float> squared(static_cast<size_t>(vectors.count()), std::numeric_limits<float>::max());
  for (int k = 1; k < clusters; ++k) {
    double total = 0.0;
    for (int i = 0; i < vectors.count(); ++i) {
      float& d = squared[static_cast<size_t>(i)];
      d = std::min(d, squared_distance(vectors.row(i), centers.row(k - 1), vectors.stride()));
      total += d;
    }
    if (!(total > 0.0))
      throw Error(
          ErrorKind::infeasible,
          fmt::format("{} clusters were requested, but there are only {} distinct local spectra; ask for fewer noises",
                      clusters, k));
    double left = total * static_cast<double>(random.uniform());
    int chosen = -1;
    for (int i = 0; i < vectors.count() && left >= 0.0; ++i) {
      const double d = squared[static_cast<size_t>(i)];
      if (d > 0.0) chosen = i;
      left -= d;
    }
    copy_row(vectors, chosen, centers, k);
  }
  return centers;
}

/// Each empty cluster takes the vector that lies farthest from its center.
void fill_empty_clusters(const Vectors& vectors, std::vector<int>& label, std::vector<float>& squared, int clusters) {
  std::vector<int> count(static_cast<size_t>(clusters));
  for (const int k : label) ++count[static_cast<size_t>(k)];
  for (int k = 0; k < clusters; ++k) {
    if (count[static_cast<size_t>(k)] > 0) continue;
    int farthest = -1;
    for (int i = 0; i < vectors.count(); ++i)
      if (count[static_cast<size_t>(label[static_cast<size_t>(i)])] > 1 &&
          (farthest < 0 || squared[static_cast<size_t>(i)] > squared[static_cast<size_t>(farthest)]))
        farthest = i;
    --count[static_cast<size_t>(label[static_cast<size_t>(farthest)])];
    ++count[static_cast<size_t>(k)];
    label[static_cast<size_t>(farthest)] = k;
    squared[static_cast<size_t>(farthest)] = 0.0f;
  }
}

void move_to_means(const Vectors& vectors, const std::vector<int>& label, Vectors& centers) {
  const auto stride = static_cast<size_t>(vectors.stride());
  std::vector<double> sum(static_cast<size_t>(centers.count()) * stride);
  std::vector<int> count(static_cast<size_t>(centers.count()));
  for (int i = 0; i < vectors.count(); ++i) {
    const auto k = static_cast<size_t>(label[static_cast<size_t>(i)]);
    ++count[k];
    const float* vector = vectors.row(i);
    double* to = sum.data() + k * stride;
    for (size_t d = 0; d < stride; ++d) to[d] += static_cast<double>(vector[d]);
  }
  for (int k = 0; k < centers.count(); ++k)
    for (size_t d = 0; d < stride; ++d)
      centers.row(k)[d] = static_cast<float>(sum[static_cast<size_t>(k) * stride + d] / count[static_cast<size_t>(k)]);
}

Clustering lloyd(const Vectors& vectors, const KMeansOptions& options, int restart) {
  Random random(options.seed, static_cast<uint64_t>(restart));
  Clustering result{first_centers(vectors, options.clusters, random),
                    std::vector<int>(static_cast<size_t>(vectors.count()), -1), 0.0};
  std::vector<float> squared(static_cast<size_t>(vectors.count()));
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    bool changed = false;
    result.error = 0.0;
    for (int i = 0; i < vectors.count(); ++i) {
      const Nearest nearest = nearest_center(vectors.row(i), result.centers, options.clusters);
      changed = changed || nearest.cluster != result.label[static_cast<size_t>(i)];
      result.label[static_cast<size_t>(i)] = nearest.cluster;
      squared[static_cast<size_t>(i)] = nearest.squared;
      result.error += static_cast<double>(nearest.squared);
    }
    fill_empty_clusters(vectors, result.label, squared, options.clusters);
    if (!changed) break;
    move_to_means(vectors, result.label, result.centers);
  }
  return result;
}

}  // namespace

float squared_distance(const float* a, const float* b, int stride) {
  Lanes sum{};
  for (int d = 0; d < stride; d += kLanes) {
    const Lanes difference = load_lanes(a + d) - load_lanes(b + d);
    sum += difference * difference;
  }
  return sum_lanes(sum);
}

Clustering k_means(const Vectors& vectors, const KMeansOptions& options) {
  std::vector<std::optional<Clustering>> results(static_cast<size_t>(options.restarts));
  parallel_for(0, options.restarts,
               [&](int restart) { results[static_cast<size_t>(restart)] = lloyd(vectors, options, restart); });
  size_t best = 0;
  for (size_t i = 1; i < results.size(); ++i)
    if (results[i]->error < results[best]->error) best = i;
  return std::move(*results[best]);
}

}  // namespace texbake
