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
  EXPECT_EQ(camera.picture.window.origin, "-512.25,99999999999");
  EXPECT_EQ(camera.picture.window.step_texels, 0.5);
  EXPECT_EQ(camera.picture.window.seed, 4294967295u);
  EXPECT_EQ(camera.picture.window.filter, Filter::nearest);
  EXPECT_EQ(camera.picture.map, "normal");
  ASSERT_TRUE(camera.frame_size);
  EXPECT_EQ(camera.frame_size->height, 200);
}

TEST(Camera, EveryViewIsRead) {
  const Camera deformed = camera_of(Json::parse(R"({"window": {"rotate": 30, "stretch": [2, 1.5], "turbulence": 12,
      "turbulence-cell": 128, "supersample": 4}})"),
                                    "a.json");
  EXPECT_EQ(deformed.picture.deform.rotate, 30);
  EXPECT_EQ(deformed.picture.deform.stretch, "2,1.5");
  EXPECT_EQ(deformed.picture.deform.turbulence_cell, 128);
  EXPECT_EQ(deformed.picture.view.supersample, 4);
  const Camera lit = camera_of(Json::parse(R"({"window": {"relief": 24, "shade": "normal", "ambient": 0.5,
      "relief-steps": 8, "relief-refinements": 3, "view-direction": [1, 0, 1], "light": [-1, -1, 1]}})"),
                               "a.json");
  EXPECT_EQ(lit.picture.relief.depth_px, 24);
  EXPECT_EQ(lit.picture.relief.shade_by, ShadeBy::normal);
  EXPECT_EQ(lit.picture.slant.view, "1,0,1");
  const Camera plane = camera_of(Json::parse(R"({"plane": {"origin": [3, "-99999999999"], "camera-height": 600,
      "pitch": 15, "yaw": -20, "fov": 70, "filter": "anisotropic"}})"),
                                 "a.json");
  EXPECT_EQ(plane.picture.view.view, View::plane);
  EXPECT_EQ(plane.picture.view.camera_height_texels, 600);
  EXPECT_EQ(plane.picture.view.fov_deg, 70);
  EXPECT_EQ(plane.picture.window.origin, "3,-99999999999");
}

TEST(Camera, WhatDoesNotGoTogetherIsRefused) {
  EXPECT_THAT(refusal(R"({"plane": {"step": 2}})"), HasSubstr("unknown member \"step\""));
  EXPECT_THAT(refusal(R"({"window": {"pitch": 2}})"), HasSubstr("unknown member \"pitch\""));
  EXPECT_THAT(refusal(R"({"window": {"view": "plane"}})"), HasSubstr("unknown member \"view\""));
  EXPECT_THAT(refusal(R"({"window": {}, "plane": {}})"), HasSubstr("or a member \"plane\""));
  EXPECT_THAT(refusal(R"({"window": {"rotate": 30, "map": "normal"}})"), HasSubstr("deform only the color"));
  EXPECT_THAT(refusal(R"({"window": {"light": [1, 1]}})"), HasSubstr("window.light: expected [x, y, z]"));
  EXPECT_THAT(refusal(R"({"window": {"relief": "24"}})"), HasSubstr("window.relief: expected a number"));
}

TEST(Camera, WhatIsLeftOutIsRendersDefault) {
  const Camera camera = camera_of(Json::parse(R"({"window": {"map": null}})"), "a.json");
  EXPECT_EQ(camera.picture.window.origin, WindowOptions().origin);
  EXPECT_EQ(camera.picture.window.step_texels, 1);
  EXPECT_EQ(camera.picture.window.filter, Filter::trilinear);
  EXPECT_FALSE(camera.picture.map);
  EXPECT_FALSE(camera.frame_size);
}

TEST(Camera, ATypoIsRefusedWithTheWordThatWasMeant) {
  EXPECT_THAT(refusal(R"({"windw": {}})"), HasSubstr("did you mean \"window\"?"));
  EXPECT_THAT(refusal(R"({"window": {"orgin": [0, 0]}})"), HasSubstr("did you mean \"origin\"?"));
  EXPECT_THAT(refusal(R"({"window": {"filter": "nearst"}})"), HasSubstr("did you mean \"nearest\"?"));
}

TEST(Camera, ValuesOfAnotherKindAreRefused) {
  EXPECT_THAT(refusal("[]"), HasSubstr("expected an object"));
  EXPECT_THAT(refusal("{}"), HasSubstr("expected a member \"window\" or a member \"plane\""));
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
