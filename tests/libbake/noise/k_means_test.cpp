#include "libbake/noise/k_means.h"

#include <gtest/gtest.h>

#include <set>

#include "libbake/base/error.h"
#include "libbake/base/random.h"

namespace texbake {
namespace {

Vectors three_clouds() {
  Vectors vectors(300, 5);
  Random random(9);
  for (int i = 0; i < 300; ++i)
    for (int d = 0; d < 5; ++d) vectors.row(i)[d] = random.uniform() + (d == i % 3 ? 5.0f : 0.0f);
  return vectors;
}

TEST(KMeans, FindsCloudsThatLieApart) {
  const Clustering found = k_means(three_clouds(), {.clusters = 3});
  for (int i = 0; i < 300; ++i) EXPECT_EQ(found.label[size_t(i)], found.label[size_t(i % 3)]);
  EXPECT_EQ((std::set<int>{found.label[0], found.label[1], found.label[2]}), (std::set<int>{0, 1, 2}));
}

TEST(KMeans, CentersAreMeansAndVectorsAreNearest) {
  const Vectors vectors = three_clouds();
  const Clustering found = k_means(vectors, {.clusters = 4, .seed = 5});
  for (int k = 0; k < 4; ++k) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < vectors.count(); ++i)
      if (found.label[size_t(i)] == k) {
        sum += double(vectors.row(i)[1]);
        ++count;
      }
    ASSERT_GT(count, 0);
    EXPECT_NEAR(found.centers.row(k)[1], sum / count, 1e-5);
  }
  for (int i = 0; i < vectors.count(); ++i)
    for (int k = 0; k < 4; ++k)
      EXPECT_LE(squared_distance(vectors.row(i), found.centers.row(found.label[size_t(i)]), vectors.stride()),
                squared_distance(vectors.row(i), found.centers.row(k), vectors.stride()));
}

TEST(KMeans, IsTheSameEveryTime) {
  const Vectors vectors = three_clouds();
  EXPECT_EQ(k_means(vectors, {.clusters = 5, .seed = 3}).label, k_means(vectors, {.clusters = 5, .seed = 3}).label);
}

TEST(KMeans, RefusesMoreClustersThanDistinctVectors) {
  Vectors vectors(20, 2);
  for (int i = 0; i < 20; ++i) vectors.row(i)[0] = static_cast<float>(i % 2);
  EXPECT_NO_THROW(k_means(vectors, {.clusters = 2}));
  try {
    k_means(vectors, {.clusters = 3});
    FAIL() << "three clusters of two points";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::infeasible);
    EXPECT_NE(std::string(error.what()).find("only 2 distinct"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace texbake
