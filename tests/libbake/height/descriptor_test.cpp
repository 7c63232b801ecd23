#include "libbake/height/descriptor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/random.h"

namespace texbake {
namespace {

PrincipalVariation of_one_class(Image<float> variation) {
  PrincipalVariation colors;
  colors.palette.classes.resize(1);
  colors.index = Image<uint8_t>(variation.width(), variation.height());
  colors.variation = std::move(variation);
  return colors;
}

TEST(Descriptor, ARampHasItsSlopeAtEveryScale) {
  Image<float> ramp(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) ramp(x, y) = 0.25f * static_cast<float>(x) - 0.5f * static_cast<float>(y);
  const Descriptor descriptor = ClassGradients(of_one_class(std::move(ramp)), 0).at({32, 32});  // far from the wrap
  for (size_t i = 0; i < descriptor.size(); i += 2) {
    EXPECT_NEAR(descriptor[i], 0.25f, 1e-4f);
    EXPECT_NEAR(descriptor[i + 1], -0.5f, 1e-4f);
  }
}

TEST(Descriptor, TexelsOfOtherClassesWeighNothing) {
  PrincipalVariation colors = of_one_class(Image<float>(32, 32, 2.0f));
  colors.palette.classes.resize(2);
  for (int y = 0; y < 32; ++y)
    for (int x = 16; x < 32; ++x) {
      colors.index(x, y) = 1;
      colors.variation(x, y) = 50.0f;
    }
  for (const float g : ClassGradients(colors, 0).at({14, 16})) EXPECT_NEAR(g, 0.0f, 1e-5f);
}

TEST(Descriptor, TurningTheDescriptorTurnsThePicture) {
  // A wave turned by π/8 is described, at its middle, as the turned description of the wave.
  const double turn = M_PI / 8;
  const V2i middle(48, 48);
  const auto centerd = [&](double angle) {
    Image<float> image(96, 96);
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 96; ++x)
        image(x, y) = static_cast<float>(
            std::sin(0.35 * ((x - middle.x) * std::cos(angle) + (y - middle.y) * std::sin(angle)) + 0.4));
    return of_one_class(std::move(image));
  };
  const Descriptor straight = ClassGradients(centerd(0.0), 0).at(middle);
  const Descriptor turned_picture = ClassGradients(centerd(turn), 0).at(middle);
  const Descriptor turned_descriptor = ClassGradients(centerd(0.0), 0).turned(middle, turn);
  const float apart = descriptor_distance(straight.data(), turned_picture.data());
  // Bilinear reading and central differences of an 18-texel wave lose up to (0.35 / 2)² · 2 = 6 %.
  EXPECT_LT(descriptor_distance(turned_descriptor.data(), turned_picture.data()), 0.06f * apart);
  const Descriptor wrong_way = ClassGradients(centerd(0.0), 0).turned(middle, -turn);
  EXPECT_GT(descriptor_distance(wrong_way.data(), turned_picture.data()), 1.5f * apart);
}

TEST(Descriptor, DistanceIsASumOfLengths) {
  Descriptor a{};
  Descriptor b{};
  b[0] = 3.0f, b[1] = 4.0f;       // first gradient: length 5
  b[106] = 5.0f, b[107] = 12.0f;  // last gradient: length 13
  EXPECT_EQ(descriptor_distance(a.data(), b.data()), 18.0f);
}

}  // namespace
}  // namespace texbake
