#include "formats/normal_vectors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libbake/base/torus.h"

namespace texbake {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A row of vectors.
struct Vectors {
  Image<float> planes[3];
  explicit Vectors(const std::vector<V3f>& list) {
    for (int c = 0; c < 3; ++c) {
      planes[c] = Image<float>(static_cast<int>(list.size()), 1);
      for (size_t i = 0; i < list.size(); ++i) planes[c].data()[i] = list[i][c];
    }
  }
  V3f operator[](int x) const { return {planes[0](x, 0), planes[1](x, 0), planes[2](x, 0)}; }
};

TEST(NormalVectors, FloatsOfUnitLengthAreVectorsThoughNoneIsNegative) {
  Vectors flat({{0, 0, 1}, {0, 0, 1}});
  EXPECT_THAT(finish_normals(flat.planes, 3, NormalNumbers::floats), IsEmpty());
  EXPECT_EQ(flat[0], V3f(0, 0, 1));
}

TEST(NormalVectors, OtherFloatsWithoutNegativesAreZeroToOne) {
  Vectors stored({{0.5f, 0.5f, 1}, {1, 0.5f, 0.5f}});
  EXPECT_THAT(finish_normals(stored.planes, 3, NormalNumbers::floats), ElementsAre(HasSubstr("0 to 1")));
  EXPECT_EQ(stored[0], V3f(0, 0, 1));
  EXPECT_EQ(stored[1], V3f(1, 0, 0));
}

TEST(NormalVectors, NamedVectorsAreNeverShifted) {
  Vectors stored({{0.5f, 0.5f, 1}});
  EXPECT_THAT(finish_normals(stored.planes, 3, NormalNumbers::vectors), ElementsAre(HasSubstr("1 of 1 vectors")));
  EXPECT_EQ(stored[0], V3f(0.5f, 0.5f, 1));
}

TEST(NormalVectors, AMissingZFollowsFromXAndY) {
  Vectors codes({{0.6f, 0, -1}, {0, -0.8f, -1}});  // code 0 of blue is −1
  EXPECT_THAT(finish_normals(codes.planes, 3, NormalNumbers::codes), ElementsAre(HasSubstr("computed from x and y")));
  EXPECT_NEAR(codes[0].z, 0.8f, 1e-6f);  // a float step of the root
  EXPECT_NEAR(codes[1].z, 0.6f, 1e-6f);
  Vectors floats({{-0.6f, 0, 0}, {0.6f, 0.8f, 0}});
  finish_normals(floats.planes, 3, NormalNumbers::floats);
  EXPECT_NEAR(floats[0].z, 0.8f, 1e-6f);
  EXPECT_NEAR(floats[1].z, 0, 1e-3f);  // 1 − 0.36 − 0.64 is not exactly 0 in floats
}

TEST(NormalVectors, WhatIsNoUnitVectorIsCounted) {
  Vectors codes({{0, 0, 1}, {0.5f, 0, 0.5f}, {0, 0, 0.98f}});
  EXPECT_THAT(finish_normals(codes.planes, 3, NormalNumbers::codes), ElementsAre(HasSubstr("1 of 3 vectors")));
}

}  // namespace
}  // namespace texbake
