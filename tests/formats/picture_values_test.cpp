#include "formats/picture_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "libbake/base/error.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

TEST(PictureValues, EveryOrientationMovesTexelsOneToOne) {
  const V2i stored(3, 5);
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const V2i upright = upright_size(stored, orientation);
    std::set<std::pair<int, int>> places;
    for (int y = 0; y < stored.y; ++y)
      for (int x = 0; x < stored.x; ++x) {
        const V2i place = upright_place({x, y}, stored, orientation);
        EXPECT_TRUE(place.x >= 0 && place.x < upright.x && place.y >= 0 && place.y < upright.y);
        places.insert({place.x, place.y});
      }
    EXPECT_EQ(places.size(), 15u);
  }
}

TEST(PictureValues, TurningTwiceBackIsNothing) {
  // 6 turns clockwise, 8 counter-clockwise; the others are their own inverses
  const int inverse[] = {0, 1, 2, 3, 4, 5, 8, 7, 6};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const V2i stored(4, 3);
    const V2i there = upright_place({1, 2}, stored, orientation);
    EXPECT_EQ(upright_place(there, upright_size(stored, orientation), inverse[orientation]), V2i(1, 2));
  }
}

TEST(PictureValues, CurvesKeepZeroOneAndSign) {
  for (const InputCurve& curve : {InputCurve::linear(), InputCurve::srgb(), InputCurve::power(1.8)}) {
    EXPECT_EQ(curve.decode(0), 0);
    EXPECT_EQ(curve.decode(1), 1);
    EXPECT_EQ(curve.decode(-0.5f), -curve.decode(0.5f));
  }
  EXPECT_EQ(InputCurve::power(2.2).decode(0.5f), linear_from_srgb(0.5f));
  EXPECT_EQ(InputCurve::power(1.8).name(), "gamma 1.8");
  EXPECT_NEAR(InputCurve::power(1.8).decode(0.5f), std::pow(0.5, 1.8), 1e-7);
}

TEST(PictureValues, BadValuesInAnyPlaneAreFound) {
  Image<float> a(3, 2), b(3, 2);
  check_finite("p", {a, b});
  check_largest("p", {a, b}, 1);
  b(1, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(check_finite("p", {a, b}), Error);
  b(1, 1) = 1.5f;
  check_finite("p", {a, b});
  EXPECT_THROW(check_largest("p", {a, b}, 1), Error);
}

}  // namespace
}  // namespace texbake
