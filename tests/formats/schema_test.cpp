#include "formats/schema.h"

#include <gtest/gtest.h>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

/// The slow twin: a validator of any schema.
class AnyValidator {
 public:
  AnyValidator() {
    const auto text = nlohmann::json::parse(bundle_schema());
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema_);
  }
  bool allows(const Json& json) {
    const nlohmann::json plain = json;
    return valijson::Validator().validate(schema_, valijson::adapters::NlohmannJsonAdapter(plain), nullptr);
  }

 private:
  valijson::Schema schema_;
};

bool allows(const Json& json) {
  IssueLog log("", IssueLog::OnError::collect);
  check_schema(json, log);
  return log.issues().empty();
}

Json sound_manifest() {
  const Bundle bundle = bundle_with_everything();
  return manifest_json(bundle, state_json(bundle, plane_refs(bundle)));
}

/// Every value of `json`, from the top.
void list_values(Json& json, std::vector<Json*>& all) {
  all.push_back(&json);
  if (json.is_structured())
    for (Json& member : json) list_values(member, all);
}

/// One change somewhere, of a kind that a schema may forbid. 2^64 - 1 is none: the other validator reads it as -1.
void change(Json& json, Random& random) {
  static const std::vector<Json> kOthers = {nullptr,
                                            true,
                                            0,
                                            1,
                                            2,
                                            3,
                                            -1,
                                            65536,
                                            1.5,
                                            -0.25,
                                            1e9,

                                            INT64_MIN,
                                            "",
                                            "fine",
                                            "half",
                                            "a name",
                                            std::string(64, 'a'),
                                            std::string(300, 'x'),
                                            Json::array(),
                                            Json::object(),
                                            {"R", "R", "B"},
                                            {"Y"},
                                            {0, 0},
                                            {1, 2, 3}};
  std::vector<Json*> all;
  list_values(json, all);
  Json& at = *all[random.below(static_cast<uint32_t>(all.size()))];
  const uint32_t what = random.below(3);
  if (what == 0 && at.is_structured() && !at.empty())
    at.erase(std::next(at.begin(), random.below(static_cast<uint32_t>(at.size()))));
  else if (what == 1 && at.is_array() && !at.empty())
    at.push_back(at[0]);
  else
    at = kOthers[random.below(static_cast<uint32_t>(kOthers.size()))];
}

TEST(Schema, AllowsWhatAnyOtherValidatorAllows) {
  AnyValidator any;
  const Json sound = sound_manifest();
  ASSERT_TRUE(allows(sound));
  ASSERT_TRUE(any.allows(sound));
  Random random(5);
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    Json json = sound;
    change(json, random);
    const bool expected = any.allows(json);
    refused += expected ? 0 : 1;
    EXPECT_EQ(allows(json), expected) << compact_json(Json::diff(sound, json));
  }
  EXPECT_GT(refused, 100);
}

TEST(Schema, NamesTheMemberAndWhatItMustBe) {
  Json json = sound_manifest();
  json["scales"][0]["planes"]["index"]["channels"] = {"a", "b", "a"};
  IssueLog log("", IssueLog::OnError::collect);
  check_schema(json, log);
  ASSERT_EQ(log.issues().size(), 2u);  // one channel is allowed, and all must differ
  for (const Issue& issue : log.issues()) {
    EXPECT_EQ(issue.where.pointer, "/scales/0/planes/index/channels");
    EXPECT_NE(issue.detail.find("found [\"a\",\"b\",\"a\"]"), std::string::npos) << issue.detail;
  }
}

}  // namespace
}  // namespace texbake
