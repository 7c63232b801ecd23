#include "libbake/color/point_set.h"

#include <gtest/gtest.h>

#include <set>

#include "libbake/color/luv.h"

namespace texbake {
namespace {

// Every texel another color.
Image<V3f> ramp(int width, int height) {
  Image<V3f> image(width, height);
  for (size_t i = 0; i < image.size(); ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(image.size());
    image.data()[i] = V3f(t, 1 - t, 0.3f);
  }
  return image;
}

TEST(PointSet, SmallExemplarIsSampledWholeInRowOrder) {
  const Image<V3f> image = ramp(7, 5);
  const PointSet points = sample({image, {}, 0}, 35);
  ASSERT_EQ(points.size(), 35);
  for (int i = 0; i < 35; ++i) {
    const V3f luv = luv_from_linear(image.data()[i]);
    EXPECT_EQ(points.point(i), (PointF{luv.x, luv.y, luv.z, 0}));
  }
}

TEST(PointSet, LargeExemplarIsSampledOnceInEveryCell) {
  const Image<V3f> image = ramp(640, 320);
  const PointSet points = sample({image, {}, 0}, 5000);
  EXPECT_LE(points.size(), 5000);
  EXPECT_GE(points.size(), 4500);  // whole cells only
  std::set<PointF> different;
  for (int i = 0; i < points.size(); ++i) different.insert(points.point(i));
  EXPECT_EQ(different.size(), static_cast<size_t>(points.size()));
}

TEST(PointSet, OneWideExemplarIsSampled) {
  const Image<V3f> image = ramp(1, 4096);
  const PointSet points = sample({image, {}, 0}, 256);
  EXPECT_GE(points.size(), 128);
  EXPECT_LE(points.size(), 512);
}

TEST(PointSet, HeightIsTheWeightedFourthCoordinate) {
  const Image<V3f> image = ramp(2, 2);
  Image<float> height(2, 2);
  height(1, 1) = 0.5f;
  const PointSet points = sample({image, height, 30}, 4);
  EXPECT_EQ(points.dimension, 4);
  EXPECT_EQ(points.point(0)[3], 0);
  EXPECT_EQ(points.point(3)[3], 15);
}

TEST(PointSet, DistinctPointsAreAllThereAreOrTheLimit) {
  Image<V3f> image(50, 50, V3f(0.2f));
  image(49, 49) = V3f(0.3f);
  image(3, 7) = V3f(0.1f, 0.2f, 0.3f);
  EXPECT_EQ(distinct_points({image, {}, 0}, 10).size(), 3u);
  EXPECT_EQ(distinct_points({image, {}, 0}, 2).size(), 2u);
  EXPECT_EQ(distinct_points({ramp(40, 40), {}, 0}, 256).size(), 256u);
}

}  // namespace
}  // namespace texbake
