#include "libbake/draw/feature.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "libbake/base/error.h"

namespace texbake {
namespace {

using testing::HasSubstr;

TEST(Feature, TwoThatDoNotGoTogetherAreRefusedWithTheReason) {
  try {
    check_features({Feature::deformation, Feature::map});
    FAIL() << "expected a refusal";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_STREQ(error.what(), "--rotate, --stretch, --turbulence: deform only the color; expected no --map beside it");
  }
  EXPECT_THROW(check_features({Feature::deformation, Feature::scales}), Error);
  EXPECT_NO_THROW(check_features({Feature::deformation, Feature::supersample}));
  EXPECT_NO_THROW(check_features({Feature::plane, Feature::supersample, Feature::relief, Feature::scales}));
}

TEST(Feature, WhatIsNotOfferedIsToldInOneLineForEach) {
  EXPECT_THAT(not_together(), HasSubstr("--show: not with --map, --view plane, --supersample or --relief\n"));
  EXPECT_THAT(not_together(), HasSubstr("--relief: not with --map\n"));
}

/// The table of README.md.
std::string readme_table() {
  std::string text = "| |", line = "\n|---|";
  const auto cell = [](std::string_view name) {
    return name.starts_with("--") ? " `" + std::string(name) + "` |" : " " + std::string(name) + " |";
  };
  for (int column = 0; column < kFeatures; ++column) {
    text += cell(feature_name(static_cast<Feature>(column)));
    line += "---|";
  }
  text += line;
  for (int row = 0; row < kFeatures; ++row) {
    text += "\n|" + cell(feature_name(static_cast<Feature>(row)));
    for (int column = 0; column < kFeatures; ++column) {
      const bool goes = why_not(static_cast<Feature>(row), static_cast<Feature>(column)).empty();
      text += row == column ? " |" : goes ? " yes |" : " - |";
    }
  }
  return text;
}

TEST(Feature, TheReadmeHasTheSameTable) {
  std::ifstream file(TEXBAKE_README);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find(readme_table()), std::string::npos) << readme_table();
}

}  // namespace
}  // namespace texbake
