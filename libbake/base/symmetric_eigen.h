// Eigenvalues and eigenvectors of a small symmetric matrix.
// Based on: cyclic Jacobi rotations (Golub & Van Loan, §8.5), which need no more than + − × ÷ and sqrt, so that every
// machine finds the same bits.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace texbake {

template <size_t N>
using SquareMatrix = std::array<std::array<double, N>, N>;

template <size_t N>
struct SymmetricEigen {
  SquareMatrix<N> values;   ///< on the diagonal, in no order; the rest is 0 up to rounding
  SquareMatrix<N> vectors;  ///< one in each column, orthonormal
};

/// Rotates the plane (p, q) so that values[p][q] becomes 0.
template <size_t N>
void rotate_to_zero(SymmetricEigen<N>& eigen, size_t p, size_t q, size_t dimension) {
  auto& [values, vectors] = eigen;
  if (values[p][q] == 0) return;
  const double theta = (values[q][q] - values[p][p]) / (2 * values[p][q]);
  const double tangent = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
  const double cosine = 1 / std::sqrt(tangent * tangent + 1), sine = tangent * cosine;
  const auto turn = [&](double& first, double& second) {
    const double x = first, y = second;
    first = cosine * x - sine * y;
    second = sine * x + cosine * y;
  };
  for (size_t i = 0; i < dimension; ++i) turn(values[i][p], values[i][q]);
  for (size_t i = 0; i < dimension; ++i) turn(values[p][i], values[q][i]);
  for (size_t i = 0; i < dimension; ++i) turn(vectors[i][p], vectors[i][q]);
}

/// Of the first `dimension` rows and columns of a symmetric matrix; beyond them, the vectors are those of the identity.
template <size_t N>
SymmetricEigen<N> symmetric_eigen(const SquareMatrix<N>& symmetric, size_t dimension = N) {
  constexpr int kSweeps = 12;  // convergence is quadratic: six sweeps reach the last bit
  SymmetricEigen<N> eigen{symmetric, {}};
  for (size_t i = 0; i < N; ++i) eigen.vectors[i][i] = 1;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (size_t p = 0; p < dimension; ++p)
      for (size_t q = p + 1; q < dimension; ++q) rotate_to_zero(eigen, p, q, dimension);
  return eigen;
}

}  // namespace texbake
