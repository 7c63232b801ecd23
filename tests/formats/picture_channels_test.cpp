#include "formats/picture_channels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/formats/picture_fixtures.h"

namespace texbake {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Names = std::vector<std::string>;

ChannelChoice chosen(const Names& names, PictureRole role = PictureRole::color, const std::string& layer = "") {
  return choose_channels("a.exr", names, role, layer);
}
Refusal channel_refusal(const Names& names, PictureRole role = PictureRole::color, const std::string& layer = "") {
  return refusal([&] { chosen(names, role, layer); });
}

TEST(PictureChannels, RedGreenAndBlueComeFromOneLayer) {
  const ChannelChoice choice = chosen({"AO.R", "diffuse.R", "diffuse.G", "diffuse.B", "diffuse.A"});
  EXPECT_THAT(choice.color, ElementsAre(1, 2, 3));
  EXPECT_EQ(choice.alpha, 4);
  EXPECT_EQ(choice.layer, "diffuse");
}

TEST(PictureChannels, ChannelsWithoutALayerComeFirst) {
  const ChannelChoice choice = chosen({"a.B", "a.G", "a.R", "B", "G", "R", "A"});
  EXPECT_THAT(choice.color, ElementsAre(5, 4, 3));
  EXPECT_EQ(choice.layer, "");
  EXPECT_THAT(choice.other_layers, ElementsAre("a"));
}

TEST(PictureChannels, TheLayerThatIsAskedForIsRead) {
  const Names names = {"R", "G", "B", "spec.R", "spec.G", "spec.B", "spec.A", "mask.value"};
  EXPECT_THAT(chosen(names, PictureRole::color, "spec").color, ElementsAre(3, 4, 5));
  EXPECT_THAT(chosen(names, PictureRole::color, "SPEC").color, ElementsAre(3, 4, 5));
  EXPECT_THAT(chosen(names, PictureRole::color, "mask").color, ElementsAre(7));
  EXPECT_THAT(chosen(names, PictureRole::color, "spec.G").color, ElementsAre(4));
  const Refusal none = channel_refusal(names, PictureRole::color, "diffuse");
  EXPECT_EQ(none.kind, ErrorKind::usage);
  EXPECT_THAT(none.words, AllOf(HasSubstr("--layer diffuse"), HasSubstr("spec.R")));
}

TEST(PictureChannels, AFirstLetterIsNoName) {
  const Refusal found = channel_refusal({"Bump", "Gloss", "Roughness"});
  EXPECT_EQ(found.kind, ErrorKind::bad_data);
  EXPECT_THAT(found.words, AllOf(HasSubstr("Bump, Gloss, Roughness"), HasSubstr("--layer")));
  EXPECT_THAT(chosen({"red", "Green", "BLUE"}).color, ElementsAre(0, 1, 2));
}

TEST(PictureChannels, LuminanceWithChromaIsUnsupported) {
  EXPECT_EQ(channel_refusal({"BY", "RY", "Y"}).kind, ErrorKind::unsupported);
}

TEST(PictureChannels, AVectorIsXYZOfOneLayer) {
  const ChannelChoice bare = chosen({"X", "Y", "Z"}, PictureRole::normal);
  EXPECT_THAT(bare.color, ElementsAre(0, 1, 2));
  EXPECT_TRUE(bare.is_vector);
  EXPECT_THAT(chosen({"B", "G", "N.X", "N.Y", "N.Z", "R"}, PictureRole::normal, "N").color, ElementsAre(2, 3, 4));
  EXPECT_THAT(chosen({"P", "N.X", "N.Y", "N.Z"}, PictureRole::normal).color, ElementsAre(1, 2, 3));
  EXPECT_FALSE(chosen({"R", "G", "B"}, PictureRole::normal).is_vector);
  EXPECT_THAT(chosen({"R", "G"}, PictureRole::normal).color, ElementsAre(0, 1));
}

TEST(PictureChannels, DepthIsLeftOutButASingleZIsData) {
  EXPECT_THAT(chosen({"Y", "Z"}, PictureRole::data).color, ElementsAre(0));
  EXPECT_THAT(chosen({"Z"}, PictureRole::data).color, ElementsAre(0));
  EXPECT_EQ(channel_refusal({"Z"}, PictureRole::color).kind, ErrorKind::bad_data);
}

}  // namespace
}  // namespace texbake
