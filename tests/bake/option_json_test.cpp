#include "bake/option_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libbake/content/select_contents.h"
#include "libbake/segment/fragment.h"

namespace texbake {
namespace {

template <class Options>
Options round_trip(const Options& options) {
  Options read;
  JsonReader reader(json_of(options), "recipe.json");
  reader.read(read);
  reader.finish();
  return read;
}

std::string refusal(const Json& json) {
  try {
    FragmentOptions options;
    JsonReader reader(json, "recipe.json: fragment");
    reader.read(options);
    reader.finish();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    return error.what();
  }
  return "accepted";
}

TEST(OptionJson, OptionsSurviveTheRoundTrip) {
  SelectContentsOptions options;
  options.candidates = 77;
  options.choice = Choice::impact;
  options.search = Search::refined;
  options.seed = 4294967295u;
  EXPECT_EQ(json_of(round_trip(options)), json_of(options));
  EXPECT_EQ(round_trip(options).separation_px, std::nullopt);
}

TEST(OptionJson, EveryFloatComesBackWithItsBits) {
  FragmentOptions options;
  for (const float threshold : {0.1f, 1.0f / 3, 999.99994f, 0.010000001f}) {
    options.threshold = threshold;
    EXPECT_EQ(round_trip(options).threshold, threshold);
  }
}

TEST(OptionJson, UnsetOptionalsAreAutomatic) {
  FragmentOptions asked, resolved;
  resolved.threshold = 4.0f;
  Json json = Json::object();
  add_parameters(json, asked, resolved);
  EXPECT_EQ(json["threshold"], 4.0);
  EXPECT_THAT(json["automatic"].dump(), ::testing::HasSubstr("\"threshold\""));
  EXPECT_EQ(asked_parameters(json), json_of(asked));
}

TEST(OptionJson, UnknownMembersAndWrongValuesAreRefusedWithTheirPlace) {
  EXPECT_EQ(refusal({{"thershold", 3}}),
            "recipe.json: fragment: unknown member \"thershold\"; did you mean \"threshold\"?");
  EXPECT_THAT(refusal({{"threshold", "wide"}}), ::testing::HasSubstr("recipe.json: fragment: --threshold: expected"));
  EXPECT_THAT(refusal({{"seed", 1.5}}), ::testing::HasSubstr("expected a whole number"));
  EXPECT_NE(refusal(Json::array()), "accepted");
  EXPECT_EQ(refusal({{"threshold", "auto"}}), "accepted");
}

}  // namespace
}  // namespace texbake
