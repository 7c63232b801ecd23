#include "bake/stages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bake/layer_stages.h"
#include "tests/bake/stage_verbs.h"
#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Remembers what it was told.
class Memory : public SilentListener {
 public:
  void warning(const std::string& text) override { warnings.push_back(text); }
  std::vector<std::string> warnings;
};

/// `run` throws, says nothing, and leaves the records and results of a whole bundle where they were.
template <class Run>
void expect_refused_without_trace(const Run& run) {
  Bundle bundle = bundle_with_everything();
  const std::vector<std::string> before = verbs(bundle);
  Memory memory;
  EXPECT_THROW(run(bundle, memory), Error);
  EXPECT_THAT(memory.warnings, IsEmpty());
  EXPECT_EQ(verbs(bundle), before);
  EXPECT_TRUE(bundle.noise && bundle.scales[0].structure && bundle.scales[0].fragments && bundle.scales[0].patches &&
              bundle.scales[0].contents);
}

TEST(Stages, AStageThatIsRefusedDropsNothing) {
  expect_refused_without_trace([](Bundle& b, Listener& l) { run_patch(b, {.count = 3}, l); });
  expect_refused_without_trace([](Bundle& b, Listener& l) { run_patch(b, {.count = 1000}, l); });
  expect_refused_without_trace(
      [](Bundle& b, Listener& l) { run_fragment(b, {.min_area_px = 100, .max_area_px = 50}, l); });
  expect_refused_without_trace([](Bundle& b, Listener& l) { run_select_contents(b, {.soft_border_px = 32}, l); });
  EstimatePsdOptions psd;
  psd.spectrum_size = 48;
  expect_refused_without_trace([&](Bundle& b, Listener& l) { run_estimate_psd(b, psd, l); });
  DecomposeOptions decompose;
  decompose.local_size = 1000;
  expect_refused_without_trace([&](Bundle& b, Listener& l) { run_decompose(b, decompose, "", l); });
}

TEST(Stages, AStageThatRunsAgainSaysWhatItDropped) {
  Bundle bundle = bundle_with_everything();
  Memory memory;
  run_patch(bundle, {.count = 16}, memory);
  EXPECT_THAT(memory.warnings, ElementsAre(HasSubstr("its last result (select-contents)")));
  EXPECT_THAT(verbs(bundle), ElementsAre("convert", "decompose", "estimate-psd", "fragment", "patch"));
  EXPECT_FALSE(bundle.scales[0].contents);
}

}  // namespace
}  // namespace texbake
