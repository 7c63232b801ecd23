#include "formats/stage_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace texbake {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> derived(const std::string& verb) {
  std::vector<std::string> verbs;
  for (const StageRow* row : derived_stages(verb)) verbs.push_back(row->verb);
  return verbs;
}

TEST(StageTable, ANewMaskTakesTheNoiseAndTheShapesWithIt) {
  EXPECT_THAT(derived("decompose"), ElementsAre("estimate-psd", "fragment", "patch", "select-contents"));
}

TEST(StageTable, ShapesDoNotReadTheSpectra) { EXPECT_THAT(derived("estimate-psd"), IsEmpty()); }

TEST(StageTable, ContentsFollowFromFragmentsThroughPatches) {
  EXPECT_THAT(derived("fragment"), ElementsAre("patch", "select-contents"));
  EXPECT_THAT(derived("select-contents"), IsEmpty());
}

TEST(StageTable, StagesBesideTheChainDropNothing) {
  EXPECT_THAT(derived("heightmap"), IsEmpty());
  EXPECT_THAT(derived("stack"), IsEmpty());
  EXPECT_THAT(derived("no-stage"), IsEmpty());
}

TEST(StageTable, WhatAStageOfTheChainReadsWasWrittenBeforeIt) {
  std::set<std::string> written;
  for (const StageRow& row : stage_table()) {
    for (const std::string& member : row.reads) EXPECT_TRUE(written.contains(member)) << row.verb << " " << member;
    written.insert(row.writes.begin(), row.writes.end());
  }
}

TEST(StageTable, TheResultThatAStageDropsIsGone) {
  Bundle bundle;
  Scale& scale = bundle.scales.emplace_back();
  scale.structure.emplace();
  bundle.noise.emplace();
  scale.fragments.emplace();
  scale.patches.emplace();
  scale.contents.emplace();
  for (const StageRow& row : stage_table()) {
    if (!row.result.drop) continue;
    EXPECT_TRUE(row.result.is_in(bundle, scale)) << row.verb;
    row.result.drop(bundle, scale);
    EXPECT_FALSE(row.result.is_in(bundle, scale)) << row.verb;
  }
}

}  // namespace
}  // namespace texbake
