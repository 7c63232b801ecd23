#include "libbake/color/principal_axis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/random.h"

namespace texbake {
namespace {

// A Aᵀ of a random matrix: symmetric, no negative eigenvalue.
SymmetricMatrix random_covariance(Random& random, size_t dimension) {
  SymmetricMatrix factor{}, product{};
  for (size_t i = 0; i < dimension; ++i)
    for (size_t j = 0; j < dimension; ++j) factor[i][j] = random.uniform() - 0.5f;
  for (size_t i = 0; i < dimension; ++i)
    for (size_t j = 0; j < dimension; ++j)
      for (size_t k = 0; k < dimension; ++k) product[i][j] += factor[i][k] * factor[j][k];
  return product;
}

double quadratic_form(const SymmetricMatrix& matrix, const PointD& x) {
  double sum = 0;
  for (size_t i = 0; i < x.size(); ++i)
    for (size_t j = 0; j < x.size(); ++j) sum += x[i] * matrix[i][j] * x[j];
  return sum;
}

// The obvious slow way: multiply by the matrix until only the largest eigenvalue is left.
double largest_eigenvalue_by_power_iteration(const SymmetricMatrix& matrix) {
  PointD x{1, 0.9, 0.8, 0.7};
  double length = 0;
  for (int step = 0; step < 20000; ++step) {
    PointD next{};
    for (size_t i = 0; i < x.size(); ++i)
      for (size_t j = 0; j < x.size(); ++j) next[i] += matrix[i][j] * x[j];
    length = 0;
    for (const double component : next) length += component * component;
    length = std::sqrt(length);
    for (size_t i = 0; i < x.size(); ++i) x[i] = next[i] / length;
  }
  return length;
}

TEST(PrincipalAxis, FindsTheDirectionOfPlantedPoints) {
  Moments moments;
  for (int t = -10; t <= 10; ++t)
    moments.add<3>({50 + 2.0 * t, 10 - 1.0 * t, 5 + 2.0 * t, 0});  // direction (2, −1, 2)/3
  const PrincipalAxis axis = principal_axis(moments.covariance(), 3);
  EXPECT_NEAR(axis.direction[0], 2.0 / 3, 1e-12);
  EXPECT_NEAR(axis.direction[1], -1.0 / 3, 1e-12);
  EXPECT_NEAR(axis.direction[2], 2.0 / 3, 1e-12);
  EXPECT_NEAR(axis.variance, 9 * 110.0 * 2 * 35 / 10 / 21, 1e-9);  // |step|² · Σ t² / 21 with Σ t² = 770
  EXPECT_NEAR(axis.total, axis.variance, 1e-9);
}

TEST(PrincipalAxis, AgreesWithPowerIteration) {
  Random random(3);
  for (size_t dimension : {3u, 4u})
    for (int i = 0; i < 50; ++i) {
      const SymmetricMatrix covariance = random_covariance(random, dimension);
      const PrincipalAxis axis = principal_axis(covariance, static_cast<int>(dimension));
      EXPECT_NEAR(axis.variance, largest_eigenvalue_by_power_iteration(covariance), 1e-9);
      EXPECT_NEAR(quadratic_form(covariance, axis.direction), axis.variance, 1e-12);
    }
}

TEST(PrincipalAxis, IsAUnitVectorWhoseLargestComponentIsPositive) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const PointD d = principal_axis(random_covariance(random, 4), 4).direction;
    EXPECT_NEAR(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + d[3] * d[3], 1, 1e-12);
    double largest = 0;
    for (const double component : d)
      if (std::fabs(component) > std::fabs(largest)) largest = component;
    EXPECT_GT(largest, 0);
  }
}

TEST(PrincipalAxis, EqualPointsHaveNoDirection) {
  Moments moments;
  for (int i = 0; i < 1000; ++i) moments.add<3>({33.3, -12.7, 81.1, 0});
  const PrincipalAxis axis = principal_axis(moments.covariance(), 3);
  EXPECT_EQ(axis.direction, PointD{});
  EXPECT_EQ(axis.variance, 0);
}

TEST(Moments, OfPartsAddUpToTheWhole) {
  Moments first, second, whole;
  for (int i = 0; i < 20; ++i) {
    const PointD point{1.0 * i, 2.0 * (i % 3), 0.5 * (i % 7), 0.25 * i};  // sums of small dyadic numbers are exact
    (i < 7 ? first : second).add<4>(point);
    whole.add<4>(point);
  }
  first.add(second);
  EXPECT_EQ(first.count, whole.count);
  EXPECT_EQ(first.mean(), whole.mean());
  EXPECT_EQ(first.covariance(), whole.covariance());
}

}  // namespace
}  // namespace texbake
