#include "libbake/noise/local_size.h"

#include <gtest/gtest.h>

namespace texbake {
namespace {

TEST(ChooseLocalSize, IsTheLargestWithinTheTolerance) {
  const SynthesisTest tested[] = {{2, 0.10, 0.06}, {4, 0.13, 0.07}, {8, 0.15, 0.07}, {16, 0.25, 0.08}};
  EXPECT_EQ(choose_local_size(tested).local_size, 4);
}

TEST(ChooseLocalSize, IsMoreTolerantWhereNoDirectionIsLost) {
  const SynthesisTest tested[] = {{2, 0.10, 0.00}, {4, 0.12, 0.00}, {8, 0.17, 0.01}, {16, 0.18, 0.01}};
  EXPECT_EQ(choose_local_size(tested).local_size, 16);
}

TEST(ChooseLocalSize, FallsBackToTheSmallestAndSaysWhy) {
  const SynthesisTest tested[] = {{2, 0.10, 0.06}, {4, 0.20, 0.09}};
  const LocalSizeChoice choice = choose_local_size(tested);
  EXPECT_EQ(choice.local_size, 2);
  EXPECT_NE(choice.reason.find("4 (0.200, 0.090)"), std::string::npos) << choice.reason;
}

}  // namespace
}  // namespace texbake
