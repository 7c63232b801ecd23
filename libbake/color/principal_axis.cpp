#include "libbake/color/principal_axis.h"

#include <cmath>

namespace texbake {
namespace {

constexpr double kLeastVariance = 1e-9;   // (3e-5 ΔE)²: below the float steps of the coordinates
constexpr double kSignMargin = 1 + 1e-9;  // components this close are equal; the first of them decides the sign

// Makes the component of largest magnitude positive.
void fix_sign(PointD& direction) {
  size_t largest = 0;
  for (size_t i = 1; i < direction.size(); ++i)
    if (std::fabs(direction[i]) > kSignMargin * std::fabs(direction[largest])) largest = i;
  if (direction[largest] < 0)
    for (double& component : direction) component = -component;
}

}  // namespace

void Moments::add(const Moments& other) {
  count += other.count;
  for (size_t i = 0; i < sum.size(); ++i) {
    sum[i] += other.sum[i];
    for (size_t j = 0; j <= i; ++j) product[i][j] += other.product[i][j];
  }
}

PointD Moments::mean() const {
  PointD mean;
  for (size_t i = 0; i < mean.size(); ++i) mean[i] = sum[i] / count;
  return mean;
}

SymmetricMatrix Moments::covariance() const {
  const PointD center = mean();
  SymmetricMatrix covariance;
  for (size_t i = 0; i < center.size(); ++i)
    for (size_t j = 0; j <= i; ++j) covariance[i][j] = covariance[j][i] = product[i][j] / count - center[i] * center[j];
  return covariance;
}

PrincipalAxis principal_axis(const SymmetricMatrix& covariance, int dimension) {
  const auto [matrix, vectors] = symmetric_eigen(covariance, static_cast<size_t>(dimension));
  PrincipalAxis axis;
  size_t largest = 0;
  for (size_t i = 0; i < static_cast<size_t>(dimension); ++i) {
    axis.total += covariance[i][i];
    if (matrix[i][i] > matrix[largest][largest]) largest = i;
  }
  if (matrix[largest][largest] < kLeastVariance) return {.total = axis.total > 0 ? axis.total : 0};
  axis.variance = matrix[largest][largest];
  for (size_t i = 0; i < static_cast<size_t>(dimension); ++i) axis.direction[i] = vectors[i][largest];
  fix_sign(axis.direction);
  return axis;
}

}  // namespace texbake
