#include "formats/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace texbake {
namespace {

std::vector<IssueId> issues_of(const std::string& text) {
  IssueLog log("test", IssueLog::OnError::collect);
  parse_json(text, log);
  std::vector<IssueId> ids;
  for (const Issue& issue : log.issues()) ids.push_back(issue.id);
  return ids;
}

Json parsed(const std::string& text) {
  IssueLog log("test", IssueLog::OnError::throw_first);
  return parse_json(text, log);
}

TEST(JsonText, FloatsPrintAsTheShortestDecimalThatReadsBack) {
  for (const float value : {0.1f, 1.0f / 3, 16777217.0f, 1e-30f, 3.4028235e38f, -0.0f, 5.9604645e-08f}) {
    const std::string text = compact_json(json_number(value));
    EXPECT_EQ(parsed(text).get<float>(), value) << text;
  }
  EXPECT_EQ(compact_json(json_number(0.1f)), "0.1");
  EXPECT_EQ(compact_json(json_number(1.0f)), "1.0");
}

TEST(JsonText, DoublesKeepEveryBitAndIntegersStayIntegers) {
  const Json json = {0.1, 1.0 / 3, 1e300, 5e-324, 7, -3, 18446744073709551615ull};
  EXPECT_EQ(compact_json(json), "[0.1,0.3333333333333333,1e+300,5e-324,7,-3,18446744073709551615]");
  EXPECT_EQ(parsed(compact_json(json)), json);
}

TEST(JsonText, WhatIsNotFiniteBecomesNull) {
  EXPECT_EQ(compact_json(Json(std::numeric_limits<double>::quiet_NaN())), "null");
  EXPECT_EQ(compact_json(json_number(std::numeric_limits<float>::infinity())), "null");
}

TEST(JsonText, ShortValuesStayOnOneLineAndLongOnesBreak) {
  const Json json = {{"size", {64, 64}}, {"long", {std::string(70, 'x'), std::string(70, 'y')}}};
  EXPECT_EQ(print_json(json), "{\n  \"size\": [64, 64],\n  \"long\": [\n    \"" + std::string(70, 'x') + "\",\n    \"" +
                                  std::string(70, 'y') + "\"\n  ]\n}\n");
}

TEST(JsonText, PrintingIsUndoneByParsing) {
  const Json json = {{"a", {1, 2.5, "π \" \\ \n", nullptr, true}}, {"b", Json::object()}, {"c", Json::array()}};
  EXPECT_EQ(parsed(print_json(json)), json);
  EXPECT_EQ(print_json(parsed(print_json(json))), print_json(json));
}

TEST(JsonText, BytesThatAreNotUtf8BecomeTextThatKeepsThem) {
  EXPECT_EQ(parsed(compact_json(Json("caf\xe9.jpg"))), Json("caf\uefe9.jpg"));
  const Json json = {{"\xff", {"caf\xe9", "caf\u00e9", 1.5, nullptr}}, {"file", "\xc3"}};
  const Json text = {{"\uefff", {"caf\uefe9", "caf\u00e9", 1.5, nullptr}}, {"file", "\uefc3"}};
  EXPECT_EQ(with_text(json), text);
  EXPECT_EQ(parsed(print_lines(json)), text);
}

TEST(JsonText, WhatIsWrongWithAFileIsToldWithItsNameAndNotThatOfAManifest) {
  const auto message = [](const std::string& text) {
    try {
      parse_json(text, "clicks.json");
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_data);
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(message("[1,\n 2"),
              testing::StartsWith("clicks.json: expected JSON in UTF-8, found: parse error at line 2"));
  EXPECT_EQ(message(R"({"x": 1, "x": 2})"), "clicks.json: expected each key only once, found \"x\" twice");
  EXPECT_THAT(message(std::string(100, '[')), testing::StartsWith("clicks.json: expected at most"));
  EXPECT_EQ(parse_json("[1]", std::string("clicks.json")), Json({1}));
}

TEST(JsonText, DuplicateKeysAreRefusedInEveryObject) {
  EXPECT_THAT(issues_of(R"({"a": 1, "b": {"c": 1, "c": 2}})"), testing::ElementsAre(IssueId::json_duplicate_key));
  EXPECT_THAT(issues_of(R"([{"a": 1}, {"a": 2}])"), testing::IsEmpty());
}

TEST(JsonText, DeepNestingIsRefusedBeforeItCosts) {
  EXPECT_THAT(issues_of(std::string(1000000, '[')), testing::ElementsAre(IssueId::json_too_deep));
  EXPECT_THAT(issues_of(std::string(60, '[') + std::string(60, ']')), testing::IsEmpty());
}

TEST(JsonText, WhatIsNotJsonIsRefused) {
  for (const char* text : {"", "{", "{\"a\": NaN}", "[1,]", "{} {}", "\"\xff\"", "[1e999]", "// x\n{}"})
    EXPECT_THAT(issues_of(text), testing::ElementsAre(IssueId::json_syntax)) << text;
}

}  // namespace
}  // namespace texbake
