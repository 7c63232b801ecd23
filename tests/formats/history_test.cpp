#include "formats/history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bundle_fixtures.h"
#include "formats/verify.h"

namespace texbake {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

/// What verify finds, once the bundle has been written.
std::vector<IssueId> issues_of(const Bundle& bundle) {
  const TemporaryFolder folder;
  write_bundle(bundle, folder / "a.texbundle");
  std::vector<IssueId> ids;
  for (const Issue& issue : verify_bundle(folder / "a.texbundle")) ids.push_back(issue.id);
  return ids;
}

void give_heights(Bundle& bundle, float height) {
  for (float& h : *bundle.scales[0].height) h = height;
  record_stage(bundle, {.verb = "heightmap"});
}

size_t stage_of(const Bundle& bundle, const std::string& verb) {
  return static_cast<size_t>(std::ranges::find(bundle.stages, verb, &Stage::verb) - bundle.stages.begin());
}

TEST(History, ASideStageStaysTrueWhenTheChainRunsAgain) {
  Bundle bundle = bundle_with_everything();
  give_heights(bundle, 0.25f);
  EXPECT_THAT(issues_of(bundle), IsEmpty());

  // patch runs again: its record and that of select-contents go, the height map stays where it was.
  std::erase_if(bundle.stages, [](const Stage& s) { return s.verb == "patch" || s.verb == "select-contents"; });
  bundle.scales[0].contents.reset();
  bundle.scales[0].patches = PatchMap{squares(64, 32 - 24)};
  record_stage(bundle, {.verb = "patch"});
  EXPECT_THAT(issues_of(bundle), IsEmpty());
  give_heights(bundle, 0.75f);
  EXPECT_THAT(issues_of(bundle), IsEmpty());
}

TEST(History, AStageOwnsWhatNoLaterOneReplaced) {
  Bundle bundle = bundle_with_everything();
  EXPECT_THAT(owned_members(bundle.stages, 0), Contains("planes.height"));
  const std::string before = bundle.stages[0].output;
  give_heights(bundle, 0.25f);
  EXPECT_THAT(owned_members(bundle.stages, 0), Not(Contains("planes.height")));
  EXPECT_THAT(owned_members(bundle.stages, 6), Contains("planes.height"));
  EXPECT_NE(bundle.stages[0].output, before) << "convert tells of what is left";
}

TEST(History, ThePlaneThatWasChangedIsFoundAtTheStageThatMadeIt) {
  Bundle bundle = bundle_with_everything();
  give_heights(bundle, 0.25f);
  bundle.scales[0].height->operator()(3, 3) = 0.5f;
  const TemporaryFolder folder;
  write_bundle(bundle, folder / "a.texbundle");
  const std::vector<Issue> issues = verify_bundle(folder / "a.texbundle");
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].id, IssueId::state_mismatch);
  EXPECT_EQ(issues[0].where.pointer, "/stages/6/output");
}

TEST(History, AStageWhoseInputWasReplacedIsWarnedOf) {
  Bundle bundle = bundle_with_everything();
  give_heights(bundle, 0.25f);
  bundle.scales[0].colors->variation(5, 5) += 1;
  record_stage(bundle, {.verb = "decompose"});
  EXPECT_THAT(issues_of(bundle), Contains(IssueId::chain_broken));
  EXPECT_THAT(issues_of(bundle), Not(Contains(IssueId::state_mismatch)));
}

TEST(History, OtherScalesAreNotTheirBusiness) {
  Bundle bundle = bundle_with_everything();
  const std::vector<Stage> alone = bundle.stages;
  for (Stage& stage : bundle.stages) stage.scale = "coarse";
  for (SourceFile& source : bundle.sources) source.scale = "coarse";
  bundle.scales[0].name = "coarse";
  Scale fine = scale_with_everything(64, "fine");
  fine.transfer.emplace();
  bundle.scales.push_back(std::move(fine));
  for (const Stage& stage : alone) {
    Stage of_fine = stage;
    of_fine.scale = "fine";
    record_stage(bundle, of_fine);
  }
  bundle.sources.push_back(bundle.sources[0]);
  bundle.sources[1].scale = "fine";
  record_stage(bundle, {.verb = "stack"});
  EXPECT_EQ(bundle.stages[0].output, alone[0].output) << "what a stage wrote is the same in a stack";
  EXPECT_EQ(bundle.stages[2].input, alone[2].input);
  bundle.stages[stage_of(bundle, "stack")].figures = Json::object();
  EXPECT_THAT(issues_of(bundle), Not(Contains(IssueId::state_mismatch)));
  EXPECT_THAT(issues_of(bundle), Not(Contains(IssueId::stage_missing)));
}

}  // namespace
}  // namespace texbake
