#include "libbake/base/symmetric_eigen.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "libbake/base/random.h"

namespace texbake {
namespace {

template <size_t N>
SquareMatrix<N> random_symmetric(uint64_t seed) {
  Random random(seed);
  SquareMatrix<N> matrix;
  for (size_t i = 0; i < N; ++i)
    for (size_t j = 0; j <= i; ++j) matrix[i][j] = matrix[j][i] = static_cast<double>(random.uniform()) - 0.5;
  return matrix;
}

/// Largest entry of |M v − λ v| and of |VᵀV − 1|.
template <size_t N>
double largest_error(const SquareMatrix<N>& matrix, const SymmetricEigen<N>& eigen) {
  double error = 0;
  for (size_t k = 0; k < N; ++k)
    for (size_t i = 0; i < N; ++i) {
      double image = -eigen.values[k][k] * eigen.vectors[i][k], dot = i == k ? -1 : 0;
      for (size_t j = 0; j < N; ++j) {
        image += matrix[i][j] * eigen.vectors[j][k];
        dot += eigen.vectors[j][i] * eigen.vectors[j][k];
      }
      error = std::max({error, std::fabs(image), std::fabs(dot)});
    }
  return error;
}

TEST(SymmetricEigen, TheMatrixScalesItsVectorsWhichAreOrthonormal) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const SquareMatrix<3> three = random_symmetric<3>(seed);
    const SquareMatrix<4> four = random_symmetric<4>(seed);
    EXPECT_LT(largest_error(three, symmetric_eigen(three)), 1e-14) << seed;  // tens of roundings of 2^-53
    EXPECT_LT(largest_error(four, symmetric_eigen(four)), 1e-14) << seed;
  }
}

TEST(SymmetricEigen, ADiagonalMatrixIsLeftAsItIs) {
  const SquareMatrix<3> diagonal = {{{3, 0, 0}, {0, 1, 0}, {0, 0, 2}}};
  const SymmetricEigen<3> eigen = symmetric_eigen(diagonal);
  EXPECT_EQ(eigen.values, diagonal);
  EXPECT_EQ(eigen.vectors, (SquareMatrix<3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));
}

TEST(SymmetricEigen, TwoByTwoIsTurnedByHalfARightAngle) {
  const SymmetricEigen<2> eigen =
      symmetric_eigen(SquareMatrix<2>{{{2, 1}, {1, 2}}});  // 1 along (1, −1), 3 along (1, 1)
  EXPECT_DOUBLE_EQ(eigen.values[0][0], 1);
  EXPECT_DOUBLE_EQ(eigen.values[1][1], 3);
  EXPECT_DOUBLE_EQ(eigen.vectors[0][0], std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(eigen.vectors[1][0], -std::sqrt(0.5));
}

TEST(SymmetricEigen, RowsBeyondTheDimensionAreNotRead) {
  SquareMatrix<4> matrix = random_symmetric<4>(5);
  SquareMatrix<3> part;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) part[i][j] = matrix[i][j];
  const SymmetricEigen<3> expected = symmetric_eigen(part);
  const SymmetricEigen<4> found = symmetric_eigen(matrix, 3);
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) EXPECT_EQ(found.vectors[i][j], expected.vectors[i][j]);
}

}  // namespace
}  // namespace texbake
