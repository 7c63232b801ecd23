#include "cli/camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libbake/base/error.h"

namespace texbake {
namespace {

using testing::HasSubstr;

std::string refusal(const char* text) {
  try {
    camera_of(Json::parse(text), "a.json");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data) << text;
    return error.what();
  }
  ADD_FAILURE() << "accepted: " << text;
  return "";
}

TEST(Camera, EveryMemberIsRead) {
  const Camera camera = camera_of(Json::parse(R"({"window": {"origin": ["-512.25", 99999999999], "step": 0.5,
      "seed": 4294967295, "filter": "nearest", "map": "normal", "size": [320, 200]}})"),
                                  "a.json");
  EXPECT_EQ(camera.window.origin, "-512.25,99999999999");
  EXPECT_EQ(camera.window.step_texels, 0.5);
  EXPECT_EQ(camera.window.seed, 4294967295u);
  EXPECT_EQ(camera.window.filter, Filter::nearest);
  EXPECT_EQ(camera.map, "normal");
  ASSERT_TRUE(camera.frame_size);
  EXPECT_EQ(camera.frame_size->height, 200);
}

TEST(Camera, WhatIsLeftOutIsRendersDefault) {
  const Camera camera = camera_of(Json::parse(R"({"window": {"map": null}})"), "a.json");
  EXPECT_EQ(camera.window.origin, WindowOptions().origin);
  EXPECT_EQ(camera.window.step_texels, 1);
  EXPECT_EQ(camera.window.filter, Filter::trilinear);
  EXPECT_FALSE(camera.map);
  EXPECT_FALSE(camera.frame_size);
}

TEST(Camera, ATypoIsRefusedWithTheWordThatWasMeant) {
  EXPECT_THAT(refusal(R"({"windw": {}})"), HasSubstr("did you mean \"window\"?"));
  EXPECT_THAT(refusal(R"({"window": {"orgin": [0, 0]}})"), HasSubstr("did you mean \"origin\"?"));
  EXPECT_THAT(refusal(R"({"window": {"filter": "nearst"}})"), HasSubstr("did you mean \"nearest\"?"));
}

TEST(Camera, ValuesOfAnotherKindAreRefused) {
  EXPECT_THAT(refusal("[]"), HasSubstr("expected an object"));
  EXPECT_THAT(refusal("{}"), HasSubstr("expected a member \"window\""));
  EXPECT_THAT(refusal(R"({"window": 3})"), HasSubstr("window: expected an object"));
  EXPECT_THAT(refusal(R"({"window": {"origin": 5}})"), HasSubstr("window.origin: expected [x, y]"));
  EXPECT_THAT(refusal(R"({"window": {"origin": [1, 2, 3]}})"), HasSubstr("window.origin: expected [x, y]"));
  EXPECT_THAT(refusal(R"({"window": {"origin": ["left", 0]}})"), HasSubstr("origin"));
  EXPECT_THAT(refusal(R"({"window": {"step": "1"}})"), HasSubstr("window.step: expected a number"));
  EXPECT_THAT(refusal(R"({"window": {"step": null}})"), HasSubstr("window.step: expected a number"));
  EXPECT_THAT(refusal(R"({"window": {"step": 0}})"), HasSubstr("step"));
  EXPECT_THAT(refusal(R"({"window": {"seed": -1}})"), HasSubstr("seed"));
  EXPECT_THAT(refusal(R"({"window": {"seed": 1.5}})"), HasSubstr("window.seed: expected a whole number"));
  EXPECT_THAT(refusal(R"({"window": {"map": 3}})"), HasSubstr("window.map: expected the name of a map"));
  EXPECT_THAT(refusal(R"({"window": {"size": [0, 4]}})"), HasSubstr("size"));
}

}  // namespace
}  // namespace texbake
