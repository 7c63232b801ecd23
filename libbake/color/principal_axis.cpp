#include "libbake/color/principal_axis.h"

#include <cmath>

namespace texbake {
namespace {

constexpr int kSweeps = 12;               // Jacobi converges quadratically: six sweeps suffice for 4×4
constexpr double kLeastVariance = 1e-9;   // (3e-5 ΔE)²: below the float steps of the coordinates
constexpr double kSignMargin = 1 + 1e-9;  // components this close are equal; the first of them decides the sign

// One rotation in the plane (p, q) that makes matrix[p][q] zero; the same rotation turns the columns of `vectors`.
void rotate(SymmetricMatrix& matrix, SymmetricMatrix& vectors, int p, int q, int dimension) {
  const size_t a = static_cast<size_t>(p), b = static_cast<size_t>(q);
  if (matrix[a][b] == 0) return;
  const double theta = (matrix[b][b] - matrix[a][a]) / (2 * matrix[a][b]);
  const double tangent = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
  const double cosine = 1 / std::sqrt(tangent * tangent + 1), sine = tangent * cosine;
  const auto turn = [&](double& first, double& second) {
    const double x = first, y = second;
    first = cosine * x - sine * y;
    second = sine * x + cosine * y;
  };
  for (size_t i = 0; i < static_cast<size_t>(dimension); ++i) turn(matrix[i][a], matrix[i][b]);
  for (size_t i = 0; i < static_cast<size_t>(dimension); ++i) turn(matrix[a][i], matrix[b][i]);
  for (size_t i = 0; i < static_cast<size_t>(dimension); ++i) turn(vectors[i][a], vectors[i][b]);
}

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
  SymmetricMatrix matrix = covariance, vectors{};
  for (size_t i = 0; i < vectors.size(); ++i) vectors[i][i] = 1;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (int p = 0; p < dimension; ++p)
      for (int q = p + 1; q < dimension; ++q) rotate(matrix, vectors, p, q, dimension);

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
