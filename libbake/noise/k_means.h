// K-means clustering of vectors, repeatable: seeded k-means++ starts, Lloyd's iteration, the best of several restarts.
// Based on: Arthur and Vassilvitskii 2007; Lloyd 1982.
#pragma once

#include <cstdint>
#include <vector>

#include "libbake/noise/lanes.h"

namespace texbake {

/// `count` vectors of `dimensions` floats; rows are padded with zeros to whole lanes.
class Vectors {
 public:
  Vectors(int count, int dimensions)
      : count_(count),
        dimensions_(dimensions),
        stride_(round_to_lanes(dimensions)),
        data_(static_cast<size_t>(count) * static_cast<size_t>(stride_)) {}
  float* row(int i) { return data_.data() + static_cast<size_t>(i) * static_cast<size_t>(stride_); }
  const float* row(int i) const { return data_.data() + static_cast<size_t>(i) * static_cast<size_t>(stride_); }
  int count() const { return count_; }
  int dimensions() const { return dimensions_; }
  int stride() const { return stride_; }

 private:
  int count_;
  int dimensions_;
  int stride_;
  std::vector<float> data_;
};

/// ‖a − b‖² of two rows of `stride` floats.
float squared_distance(const float* a, const float* b, int stride);

struct KMeansOptions {
  int clusters = 2;
  int restarts = 5;
  int max_iterations = 100;
  uint32_t seed = 1;
};

struct Clustering {
  Vectors centers;         ///< one row for each cluster
  std::vector<int> label;  ///< of each vector
  double error = 0;        ///< Σ squared distances to the own center
};

/// The clustering of least error; the first of equal ones. No cluster is empty. Throws Error(infeasible) when there are
/// fewer distinct vectors than clusters.
Clustering k_means(const Vectors& vectors, const KMeansOptions& options);

}  // namespace texbake
