#include "libbake/report/rendering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/planes/prepare.h"

namespace texbake {
namespace {

TEST(Rendering, WhatNoiseTakesBelowBlackIsBlack) {
  const Image<V3f> dark(32, 32, V3f(0.001f));
  const Image<float> mask(32, 32, 1.0f);
  Image<V3f> noise(16, 16);
  for (size_t i = 0; i < noise.size(); ++i) noise.data()[i] = i % 2 == 0 ? V3f(0.25f, -0.25f, 0.125f) : V3f(-0.25f);
  EvaluatorInput input;
  input.base = dark;
  input.noise = NoiseInput{{mask}, {noise}, 161, NoiseSpace::linear};
  const Image<V3f> luv = bundle_luv(prepare(input), {2, 2}, 1);
  for (const V3f& c : luv) {
    EXPECT_GE(c.x, 0.0f);
    // The most saturated colors of a screen, blue and red, are within 180 of gray.
    EXPECT_LE(std::hypot(c.y, c.z), 180.0f);
  }
  EXPECT_EQ(luv(1, 0), V3f(0)) << "black has no colour";
}

}  // namespace
}  // namespace texbake
