// The direction in which a cloud of points varies most, from its moments. Based on: principal component analysis.
#pragma once

#include <array>
#include <cstddef>

#include "libbake/base/symmetric_eigen.h"

namespace texbake {

inline constexpr int kMaxPointDimension = 4;  ///< L, u*, v* and the weighted height
using PointD = std::array<double, kMaxPointDimension>;
using SymmetricMatrix = SquareMatrix<kMaxPointDimension>;

/// Sums over points, from which mean and covariance follow. Coordinates beyond the dimension of the points stay 0.
struct Moments {
  double count = 0;
  PointD sum{};
  SymmetricMatrix product{};  ///< Σ x_i x_j for j ≤ i; the rest is not used

  template <int Dimension>
  void add(const PointD& point);
  void add(const Moments& other);
  PointD mean() const;                 ///< count > 0
  SymmetricMatrix covariance() const;  ///< divided by count > 0, full matrix
};

template <int Dimension>
void Moments::add(const PointD& point) {
  count += 1;
  for (std::size_t i = 0; i < Dimension; ++i) {
    sum[i] += point[i];
    for (std::size_t j = 0; j <= i; ++j) product[i][j] += point[i] * point[j];
  }
}

struct PrincipalAxis {
  PointD direction{};   ///< unit; its component of largest magnitude is positive. 0 when all points are equal
  double variance = 0;  ///< along the direction
  double total = 0;     ///< over all directions
};

/// Of the first `dimension` coordinates. Variances below 1e-9 are taken for rounding: no direction.
PrincipalAxis principal_axis(const SymmetricMatrix& covariance, int dimension);

}  // namespace texbake
