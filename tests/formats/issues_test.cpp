#include "formats/issues.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

TEST(Issues, TheReadmeAndTheTableAgree) {
  std::set<std::string> documented;
  std::istringstream readme(file_text(FORMATS_README));
  for (std::string line; std::getline(readme, line);)
    if (line.size() > 5 && line.starts_with("| ") && std::isdigit(line[2]) && line.substr(5, 3) == " | ")
      documented.insert(line);
  std::set<std::string> listed;
  for (const IssueKind& kind : issue_kinds())
    listed.insert("| " + std::to_string(static_cast<int>(kind.id)) + " | " + kind.name + " | " +
                  (kind.severity == Severity::error ? "error" : "warning") + " | " + kind.meaning + " | " + kind.fix +
                  " |");
  EXPECT_EQ(documented, listed);
}

TEST(Issues, NumbersRiseAndNamesDiffer) {
  std::set<std::string> names;
  int before = 0;
  for (const IssueKind& kind : issue_kinds()) {
    EXPECT_GT(static_cast<int>(kind.id), before);
    before = static_cast<int>(kind.id);
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
  }
}

TEST(Issues, TheTextSaysWhatWhereAndHowToMend) {
  Issue issue;
  issue.id = IssueId::height_range;
  issue.where.file = "a.exr";
  issue.where.part = "height";
  issue.where.texel = V2i(3, 4);
  issue.detail = "expected 0 to 1, found 2";
  issue.count = 7;
  EXPECT_EQ(text(issue),
            "error 407 height-range at a.exr, part height, texel (3, 4): expected 0 to 1, found 2 (7 times); bake the "
            "bundle again from its sources");
  const Json json = to_json(issue);
  EXPECT_EQ(json["number"], 407);
  EXPECT_EQ(json["texel"], Json::array({3, 4}));
  EXPECT_EQ(json["count"], 7);
}

TEST(Issues, ALogThrowsTheFirstErrorButNoWarning) {
  IssueLog log("rock.texbundle", IssueLog::OnError::throw_first);
  log.add({IssueId::stray_file, {.file = "x"}, "expected nothing"});
  try {
    log.add({IssueId::semantics_unknown, {.pointer = "/asset/semantics"}, "expected 1, found 2"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::unsupported);
    EXPECT_THAT(error.what(), testing::StartsWith("rock.texbundle: error 204 semantics-unknown at bundle.json /asset"));
  }
}

TEST(Issues, AnErrorIsBelowItsPointerAndNotBelowALongerNumber) {
  IssueLog log("", IssueLog::OnError::collect);
  log.add({IssueId::schema_violation, {.pointer = "/scales/10/name"}, ""});
  EXPECT_TRUE(log.error_below("/scales/10"));
  EXPECT_TRUE(log.error_below("/scales"));
  EXPECT_FALSE(log.error_below("/scales/1"));
}

}  // namespace
}  // namespace texbake
