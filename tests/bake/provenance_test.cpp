#include "bake/provenance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bake/stage_verbs.h"

namespace texbake {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A bundle in which the whole chain has run.
Bundle baked() {
  Bundle bundle;
  bundle.scales.emplace_back();
  bundle.scales[0].structure.emplace();
  bundle.scales[0].masks.emplace_back(1, 1, 1.0f);
  bundle.noise.emplace();
  bundle.scales[0].fragments.emplace();
  bundle.scales[0].patches.emplace();
  bundle.scales[0].contents.emplace();
  for (const char* verb : {"convert", "decompose", "estimate-psd", "fragment", "patch", "select-contents", "heightmap"})
    bundle.stages.emplace_back().verb = verb;
  return bundle;
}

TEST(Provenance, AStageThatRunsAgainDropsWhatWasMadeFromIt) {
  Bundle bundle = baked();
  EXPECT_THAT(drop_stage(bundle, "fragment"), ElementsAre("patch", "select-contents"));
  EXPECT_THAT(verbs(bundle), ElementsAre("convert", "decompose", "estimate-psd", "heightmap"));
  EXPECT_FALSE(bundle.scales[0].fragments || bundle.scales[0].patches || bundle.scales[0].contents);
  EXPECT_TRUE(bundle.scales[0].structure);
}

TEST(Provenance, ADecompositionDropsItsMasksAndTheNoise) {
  Bundle bundle = baked();
  EXPECT_THAT(drop_stage(bundle, "decompose"), ElementsAre("estimate-psd", "fragment", "patch", "select-contents"));
  EXPECT_FALSE(bundle.scales[0].structure || bundle.noise);
  EXPECT_TRUE(bundle.scales[0].masks.empty());
}

TEST(Provenance, TheLastStageDropsNothingElse) {
  Bundle bundle = baked();
  EXPECT_THAT(drop_stage(bundle, "select-contents"), IsEmpty());
  EXPECT_TRUE(bundle.scales[0].patches);
  EXPECT_FALSE(bundle.scales[0].contents);
}

TEST(Provenance, SpectraAndHeightsDropNothing) {
  Bundle bundle = baked();
  EXPECT_THAT(drop_stage(bundle, "estimate-psd"), IsEmpty());
  EXPECT_FALSE(bundle.noise);
  EXPECT_THAT(drop_stage(bundle, "heightmap"), IsEmpty());
  EXPECT_TRUE(bundle.scales[0].contents);
}

TEST(Provenance, FindStageFindsTheRecord) {
  const Bundle bundle = baked();
  ASSERT_NE(find_stage(bundle, "patch"), nullptr);
  EXPECT_EQ(find_stage(bundle, "patch")->verb, "patch");
  EXPECT_EQ(find_stage(bundle, "stack"), nullptr);
}

}  // namespace
}  // namespace texbake
