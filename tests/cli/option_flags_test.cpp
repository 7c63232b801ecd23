#include "cli/option_flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libbake/segment/fragment.h"

namespace texbake {
namespace {

using ::testing::HasSubstr;

TEST(OptionFlags, EveryFieldIsAFlagWithItsUnitRangeAndDefault) {
  CLI::App app;
  FragmentOptions options;
  add_flags(app, options, "Options");
  const std::string help = app.help();
  FragmentOptions::fields(options, [&](const auto&, const Field& field) {
    EXPECT_THAT(help, HasSubstr(std::string("--") + field.name));
    EXPECT_THAT(help, HasSubstr(field.unit));
  });
  EXPECT_THAT(help, HasSubstr("default: auto ("));
  EXPECT_THAT(help, HasSubstr("default: 1"));
}

TEST(OptionFlags, ValuesArriveInTheStruct) {
  CLI::App app;
  FragmentOptions options;
  add_flags(app, options, "Options");
  app.parse("--threshold 12.5 --seed=4294967295");
  EXPECT_EQ(options.threshold, 12.5f);
  EXPECT_EQ(options.seed, 4294967295u);
  EXPECT_EQ(options.min_area_px, std::nullopt);
}

TEST(OptionFlags, PrefixKeepsEqualNamesApart) {
  CLI::App app;
  FragmentOptions first, second;
  add_flags(app, first, "Options", "first-");
  add_flags(app, second, "Options", "second-");
  app.parse("--second-seed 9");
  EXPECT_EQ(first.seed, FragmentOptions().seed);
  EXPECT_EQ(second.seed, 9u);
}

TEST(OptionFlags, AWrongValueNamesTheFlagThatWasWritten) {
  CLI::App app;
  FragmentOptions options;
  add_flags(app, options, "Options", "fragment-");
  try {
    app.parse("--fragment-seed many");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("--fragment-seed: expected a whole number"));
  }
}

}  // namespace
}  // namespace texbake
