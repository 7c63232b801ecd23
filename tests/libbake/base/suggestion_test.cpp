#include "libbake/base/suggestion.h"

#include <gtest/gtest.h>

namespace texbake {
namespace {

const std::vector<std::string> kVerbs = {"bake", "convert", "fragment", "patch", "render", "verify"};

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("patch", "patch"), 0);
  EXPECT_EQ(edit_distance("ptch", "patch"), 1);
  EXPECT_EQ(edit_distance("paatch", "patch"), 1);
  EXPECT_EQ(edit_distance("petch", "patch"), 1);
  EXPECT_EQ(edit_distance("aptch", "patch"), 1);
  EXPECT_EQ(edit_distance("", "patch"), 5);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(EditDistance, IsSymmetric) { EXPECT_EQ(edit_distance("render", "verify"), edit_distance("verify", "render")); }

TEST(NearestWord, IsTheWordThatWasMeant) {
  EXPECT_EQ(nearest_word("convrt", kVerbs), "convert");
  EXPECT_EQ(nearest_word("rendre", kVerbs), "render");
  EXPECT_EQ(nearest_word("verfiy", kVerbs), "verify");
}

TEST(NearestWord, IsNoneWhenNothingIsNear) {
  EXPECT_EQ(nearest_word("photograph", kVerbs), std::nullopt);
  EXPECT_EQ(nearest_word("leaves.png", kVerbs), std::nullopt);
}

}  // namespace
}  // namespace texbake
