#include "cli/text_wrap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texbake {
namespace {

using ::testing::ElementsAre;
using Lines = std::vector<std::string>;

TEST(TextWrap, ColumnsAreCodePoints) {
  EXPECT_EQ(columns_of(""), 0);
  EXPECT_EQ(columns_of("abc"), 3);
  EXPECT_EQ(columns_of("\u03c3 \u2192 \u2026"), 5);
}

TEST(TextWrap, LinesAreFilledUpToTheWidth) {
  EXPECT_THAT(wrapped("one two three", 7), ElementsAre("one two", "three"));
  EXPECT_THAT(wrapped("one two three", 6), ElementsAre("one", "two", "three"));
  EXPECT_THAT(wrapped("a \u2192 b", 5), ElementsAre("a \u2192 b"));  // 7 bytes, 5 columns
  EXPECT_EQ(wrapped("", 7), Lines());
}

TEST(TextWrap, ALongWordIsBrokenAfterItsSigns) {
  EXPECT_THAT(wrapped("--show color|patches|noise", 10), ElementsAre("--show", "color|", "patches|", "noise"));
  EXPECT_THAT(wrapped("1,2,3,4", 4), ElementsAre("1,2,", "3,4"));
  EXPECT_THAT(wrapped("a unbreakable b", 5), ElementsAre("a", "unbreakable", "b"));
}

TEST(TextWrap, ACommandIsContinuedAsAShellReadsIt) {
  const std::string command = "texbake render a.texbundle -o a.png --size 64x64 --map normal";
  EXPECT_THAT(wrapped_command(command, 80), ElementsAre(command));
  const Lines lines = wrapped_command(command, 30);
  EXPECT_THAT(lines, ElementsAre("texbake render a.texbundle \\", "-o a.png --size 64x64 \\", "--map normal"));
  std::string read;
  for (const std::string& line : lines) read += line.ends_with(" \\") ? line.substr(0, line.size() - 1) : line;
  EXPECT_EQ(read, command);
}

TEST(TextWrap, AnOptionStaysWithItsValueAndAFlagTakesTheNextWordAlong) {
  EXPECT_THAT(wrapped_command("texbake bake photo.png --output name", 24),
              ElementsAre("texbake bake photo.png \\", "--output name"));
}

}  // namespace
}  // namespace texbake
