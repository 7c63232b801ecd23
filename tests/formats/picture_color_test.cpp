#include "formats/picture_color.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lcms2.h>

#include "libbake/color/luv.h"
#include "tests/formats/picture_fixtures.h"
#include "tests/formats/profile_fixtures.h"

namespace texbake {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Chromaticities kBt2020 = {{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}}};
constexpr Chromaticities kAp1 = {{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}}};

ColorReading reading_of(const ColorFacts& facts, InputSpace space = InputSpace::automatic, int channels = 3) {
  return color_reading("a.png", facts, space, channels, InputCurve::srgb());
}
ColorReading reading_of(const Chromaticities& primaries) {
  ColorFacts facts;
  facts.primaries = primaries;
  facts.source = "its chunk cHRM";
  return reading_of(facts);
}

// ITU-R BT.2087-0, M2^-1: linear BT.2020 to BT.709, printed to four digits.
TEST(PictureColor, PrimariesOfBt2020AreExchangedByThePublishedMatrix) {
  const ColorReading reading = reading_of(kBt2020);
  ASSERT_TRUE(reading.rec709_from_file);
  const double published[3][3] = {{1.6605, -0.5876, -0.0728}, {-0.1246, 1.1329, -0.0083}, {-0.0182, -0.1006, 1.1187}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      EXPECT_NEAR((*reading.rec709_from_file)[column][row], published[row][column], 1e-4);  // printed digits
  EXPECT_THAT(reading.notes, ElementsAre(HasSubstr("cHRM")));
}

TEST(PictureColor, WhiteStaysWhiteWhateverItsChromaticity) {
  const ColorReading reading = reading_of(kAp1);
  ASSERT_TRUE(reading.rec709_from_file);
  const Imath::V3d white = Imath::V3d(1, 1, 1) * *reading.rec709_from_file;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1, 1e-9);
}

TEST(PictureColor, PrimariesOfRec709AreLeftAlone) {
  const ColorReading reading = reading_of({{{0.6401, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3127, 0.329}}});
  EXPECT_FALSE(reading.rec709_from_file);
  EXPECT_THAT(reading.notes, IsEmpty());
}

TEST(PictureColor, ImpossiblePrimariesAreIgnored) {
  EXPECT_FALSE(reading_of({{{0.3, 0.3}, {0.3, 0.3}, {0.3, 0.3}, {0.3127, 0.329}}}).rec709_from_file);
  EXPECT_FALSE(reading_of({{{0.64, 0}, {0.3, 0.6}, {0.15, 0.06}, {0.3127, 0.329}}}).rec709_from_file);
}

TEST(PictureColor, InputSpaceOverrulesTheFile) {
  ColorFacts facts;
  facts.primaries = kBt2020;
  facts.profile = profile_bytes(kBt2020, 1.8);
  const ColorReading reading = reading_of(facts, InputSpace::srgb);
  EXPECT_FALSE(reading.rec709_from_file);
  EXPECT_EQ(reading.space, "srgb");
}

TEST(PictureColor, AMatrixProfileGivesItsCurveAndItsPrimaries) {
  ColorFacts facts;
  facts.profile = profile_bytes(kBt2020, 1.8);
  const ColorReading reading = reading_of(facts);
  EXPECT_EQ(reading.space, "gamma 1.8");
  EXPECT_NEAR(reading.curves[0].decode(0.5f), 0.28717f, 1e-4f);  // 0.5^1.8, in a profile of 8 fractional bits
  ASSERT_TRUE(reading.rec709_from_file);
  EXPECT_NEAR((*reading.rec709_from_file)[0][0], 1.6605, 2e-3);  // profiles round to 16 bits, about another white
}

TEST(PictureColor, AProfileOfSrgbIsSrgbExactlyAndALinearOneIsLinear) {
  ColorFacts facts;
  cmsHPROFILE srgb = cmsCreate_sRGBProfile();
  facts.profile = saved_profile(srgb);
  const ColorReading reading = reading_of(facts);
  EXPECT_EQ(reading.space, "srgb");
  EXPECT_FALSE(reading.rec709_from_file);
  EXPECT_EQ(reading.curves[0].decode(0.25f), linear_from_srgb(0.25f));
  EXPECT_THAT(reading.notes, IsEmpty());

  facts.profile = profile_bytes({{{0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3127, 0.329}}}, 1, "Linear sRGB");
  EXPECT_EQ(reading_of(facts).space, "linear");
}

TEST(PictureColor, InksNeedAProfile) {
  EXPECT_EQ(refusal([] { reading_of(ColorFacts{}, InputSpace::automatic, 4); }).kind, ErrorKind::unsupported);
  ColorFacts facts;
  facts.profile = ink_profile_bytes();
  const ColorReading reading = reading_of(facts, InputSpace::automatic, 4);
  ASSERT_TRUE(reading.transform);
  const float inks[8] = {0, 0, 0, 0, 0, 0, 0, 1};  // paper, and black alone
  float light[6];
  reading.transform->apply(inks, light, 2);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(light[c], 1, 0.01f);  // the table of the profile has 16 bits, of Lab
    EXPECT_NEAR(light[3 + c], 0, 0.01f);
  }
}

TEST(PictureColor, CodePointsAreThoseOfH273) {
  ColorFacts facts;
  add_code_points("a.png", 9, 8, facts);
  EXPECT_EQ(facts.primaries->xy[0][0], 0.708);
  EXPECT_EQ(facts.curve->name(), "linear");
  EXPECT_EQ(refusal([&] { add_code_points("a.png", 9, 16, facts); }).kind, ErrorKind::unsupported);
}

TEST(PictureColor, BytesThatAreNoProfileAreSaidAndIgnored) {
  ColorFacts facts;
  facts.profile = "no profile";
  const ColorReading reading = reading_of(facts);
  EXPECT_EQ(reading.space, "srgb");
  EXPECT_THAT(reading.notes, ElementsAre(HasSubstr("profile cannot be used")));
}

}  // namespace
}  // namespace texbake
