#include "cli/option_flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bake/convert_stage.h"
#include "cli/parser.h"
#include "libbake/content/select_contents.h"
#include "libbake/segment/fragment.h"

namespace texbake {
namespace {

using ::testing::HasSubstr;
using Words = std::vector<std::string>;

TEST(OptionFlags, EveryFieldIsAFlagWithItsUnitRangeAndDefault) {
  Arguments arguments;
  FragmentOptions options;
  add_flags(arguments, options, "Options");
  size_t i = 0;
  FragmentOptions::fields(options, [&](const auto&, const Field& field) {
    ASSERT_LT(i, arguments.list().size());
    const Argument& argument = arguments.list()[i++];
    EXPECT_EQ(argument.name, field.name);
    EXPECT_THAT(argument.value, HasSubstr(field.unit));
    EXPECT_THAT(argument.help, HasSubstr(field.help));
    EXPECT_NE(argument.standard, "");
  });
  EXPECT_EQ(i, arguments.list().size());
  EXPECT_THAT(arguments.list().front().standard, HasSubstr("auto ("));
  EXPECT_EQ(arguments.list().back().standard, "1");
}

TEST(OptionFlags, WordsOfAnEnumAreChoices) {
  Arguments arguments;
  SelectContentsOptions options;
  add_flags(arguments, options, "Options");
  const auto choices = [&](const std::string& name) {
    return std::ranges::find(arguments.list(), name, &Argument::name)->choices;
  };
  EXPECT_EQ(choices("choice"), (Words{"impact", "balanced"}));
  EXPECT_EQ(choices("search"), (Words{"exact", "refined", "auto"}));
  EXPECT_EQ(choices("count"), Words());
}

TEST(OptionFlags, ValuesArriveInTheStruct) {
  Arguments arguments;
  FragmentOptions options;
  add_flags(arguments, options, "Options");
  parse(arguments, Words{"--threshold", "12.5", "--seed=4294967295"});
  EXPECT_EQ(options.threshold, 12.5f);
  EXPECT_EQ(options.seed, 4294967295u);
  EXPECT_EQ(options.min_area_px, std::nullopt);
}

TEST(OptionFlags, ColorIsAcceptedInBothSpellings) {
  for (const char* flag : {"--color", "--colour"}) {
    Arguments arguments;
    StorageOptions options;
    add_flags(arguments, options, "Options");
    EXPECT_EQ(arguments.list().front().name, "color");
    parse(arguments, Words{flag, "palette"});
    EXPECT_EQ(options.color, ColorForm::palette) << flag;
  }
}

TEST(OptionFlags, PrefixKeepsEqualNamesApart) {
  Arguments arguments;
  FragmentOptions first, second;
  add_flags(arguments, first, "Options", "first-");
  add_flags(arguments, second, "Options", "second-");
  parse(arguments, Words{"--second-seed", "9"});
  EXPECT_EQ(first.seed, FragmentOptions().seed);
  EXPECT_EQ(second.seed, 9u);
}

TEST(OptionFlags, AWrongValueNamesTheFlagThatWasWritten) {
  Arguments arguments;
  FragmentOptions options;
  add_flags(arguments, options, "Options", "fragment-");
  try {
    parse(arguments, Words{"--fragment-seed", "many"});
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("--fragment-seed: expected a whole number"));
  }
}

}  // namespace
}  // namespace texbake
