// Bundles that somebody made to do harm: right hashes, wrong intentions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/limits.h"
#include "formats/verify.h"
#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

/// Changes the manifest, and gives the payload of its scale the name that it then must have.
void alter(const fs::path& bundle, const std::function<void(Json& scale)>& change) {
  IssueLog log("", IssueLog::OnError::throw_first);
  Json json = parse_json(file_text(bundle / "bundle.json"), log);
  change(json["scales"][0]);
  Json& scale = json["scales"][0];
  const V2i size(scale["size"][0].get<int>(), scale["size"][1].get<int>());
  PlaneRefs refs;
  std::vector<Json*> planes;
  for (auto& [key, plane] : scale["planes"].items()) {
    const bool is_table = key == "fragmentClass" || key == "fragmentColor";
    refs.push_back(
        plane_ref(key, plane, "", is_table ? table_size(scale["fragments"]["count"].get<size_t>(), size) : size, log));
    planes.push_back(&plane);
  }
  for (Json& map : scale["maps"]) {
    refs.push_back(plane_ref(kMapKey, map["plane"], "", size, log));
    planes.push_back(&map["plane"]);
  }
  const std::string name = payload_name(scale["name"], refs);
  fs::rename(payload_of(bundle), bundle / name);
  for (Json* plane : planes) (*plane)["file"] = name;
  write_text(bundle / "bundle.json", print_json(json));
}

/// A bundle without stages, which would tell of every change.
Bundle bundle_without_history() {
  Bundle bundle = bundle_with_everything();
  bundle.noise.reset();
  bundle.stages.clear();
  return bundle;
}

std::vector<IssueId> errors_of(const fs::path& bundle) {
  std::vector<IssueId> ids;
  for (const Issue& issue : verify_bundle(bundle))
    if (issue.kind().severity == Severity::error) ids.push_back(issue.id);
  return ids;
}

TEST(HostileBundle, TwoMapsThatNameOnePartAreBothRead) {
  const TemporaryFolder folder;
  Bundle bundle = bundle_without_history();
  Random random(1);
  bundle.scales[0].maps.push_back(map_of("occlusion", 1, 16, 64, random));
  write_bundle(bundle, folder / "a.texbundle");
  alter(folder / "a.texbundle", [](Json& scale) { scale["maps"][2]["plane"] = scale["maps"][1]["plane"]; });

  EXPECT_THAT(errors_of(folder / "a.texbundle"), IsEmpty());
  const Bundle read = read_bundle(folder / "a.texbundle");
  EXPECT_TRUE(read.scales[0].maps[1].planes[0] == bundle.scales[0].maps[1].planes[0]);
  EXPECT_TRUE(read.scales[0].maps[2].planes[0] == bundle.scales[0].maps[1].planes[0]);
}

TEST(HostileBundle, PatchesThatNameThePartOfTheFragmentsAreJudgedNotFollowed) {
  const TemporaryFolder folder;
  write_bundle(bundle_without_history(), folder / "a.texbundle");
  alter(folder / "a.texbundle", [](Json& scale) { scale["planes"]["patch"] = scale["planes"]["fragment"]; });

  EXPECT_THAT(errors_of(folder / "a.texbundle"), testing::Contains(IssueId::label_range));
  EXPECT_THROW(read_bundle(folder / "a.texbundle"), Error);
}

TEST(HostileBundle, ThePreviewIsNeverTakenForTheExemplar) {
  // A part of its own for each; the manifest names the preview after the exemplar.
  const TemporaryFolder folder;
  const Bundle bundle = bundle_without_history();
  write_bundle(bundle, folder / "a.texbundle");
  alter(folder / "a.texbundle", [](Json& scale) {
    Json planes = Json::object();
    planes["exemplar"] = scale["planes"]["exemplar"];
    planes["preview"] = scale["planes"]["structure"];
    for (const auto& [key, plane] : scale["planes"].items())
      if (!planes.contains(key)) planes[key] = plane;
    scale["planes"] = planes;
  });
  EXPECT_TRUE(read_bundle(folder / "a.texbundle").scales[0].exemplar == bundle.scales[0].exemplar);
}

TEST(HostileBundle, WhatNoFileHoldsTakesNoMemory) {
  const TemporaryFolder folder;
  write_bundle(bundle_without_history(), folder / "a.texbundle");
  alter(folder / "a.texbundle", [](Json& scale) {
    scale["size"] = {16384, 16384};
    scale["fragments"]["count"] = 16384 * 16384;
  });
  IssueLog log("", IssueLog::OnError::collect);
  const LoadedBundle loaded = load_bundle(folder / "a.texbundle", {}, log);
  EXPECT_GT(log.error_count(), 0u);
  const Scale& scale = loaded.bundle.scales.at(0);
  EXPECT_TRUE(scale.exemplar.empty());
  EXPECT_TRUE(scale.fragments->fragments.empty());
  EXPECT_TRUE(scale.fragments->partition.centers.empty());
  EXPECT_TRUE(scale.patches->partition.idx.empty());
}

TEST(HostileBundle, PlanesOfOneFileMustFitIntoItTogether) {
  // Each of the maps reads the preview in another order of its channels: one would fit, all of them do not.
  const TemporaryFolder folder;
  Bundle bundle;
  bundle.scales.emplace_back().exemplar = Image<V3f>(1024, 1024, V3f(0.5f));
  write_bundle(bundle, folder / "a.texbundle");
  alter(folder / "a.texbundle", [](Json& scale) {
    scale["maps"] = Json::array();
    const Json preview = scale["planes"]["preview"];
    std::vector<std::string> channels = {"B", "G", "R"};
    do {
      Json map = {{"name", "map" + channels[0] + channels[1]},
                  {"channels", 3},
                  {"sourceBits", 8},
                  {"sourceFloat", true},
                  {"convention", ""},
                  {"plane", preview}};
      map["plane"]["channels"] = channels;
      scale["maps"].push_back(map);
    } while (std::ranges::next_permutation(channels).found);
  });
  EXPECT_THAT(errors_of(folder / "a.texbundle"), testing::ElementsAre(IssueId::file_too_small));
}

TEST(HostileBundle, APartOfFiveChannelsIsRefused) {
  const TemporaryFolder folder;
  write_bundle(bundle_without_history(), folder / "a.texbundle");
  const PlaneShape shape{"preview", {"R", "G", "B", "A", "Z"}, PixelType::half, 64, 64};
  SafeFile file(payload_of(folder / "a.texbundle"));
  write_exr(file, {64, 64}, {{shape, [&](int, std::byte* row) { std::fill_n(row, shape.row_bytes(), std::byte{}); }}});
  file.commit();
  EXPECT_THAT(errors_of(folder / "a.texbundle"), testing::Contains(IssueId::part_channels));
}

TEST(HostileBundle, MoreIssuesThanAreShownAreCounted) {
  const TemporaryFolder folder;
  write_bundle(bundle_without_history(), folder / "a.texbundle");
  IssueLog reading("", IssueLog::OnError::throw_first);
  Json json = parse_json(file_text(folder / "a.texbundle/bundle.json"), reading);
  json["sources"] = Json::array();
  for (int i = 0; i < 1000; ++i) json["sources"].push_back(i);
  json["scales"][0]["size"] = "large";  // found after the list of issues is full, and must still be heeded
  json["scales"][0]["planes"].erase("index");
  write_text(folder / "a.texbundle/bundle.json", print_json(json));
  const std::vector<Issue> issues = verify_bundle(folder / "a.texbundle");
  uint64_t violations = 0;
  for (const Issue& issue : issues)
    if (issue.id == IssueId::schema_violation) violations += issue.count;
  EXPECT_LE(issues.size(), kMaxIssuesOfKind + 10);
  EXPECT_EQ(violations, 1001u);
}

TEST(HostileBundle, TheLastIssueThatIsKeptCountsTheOthers) {
  IssueLog log("", IssueLog::OnError::collect);
  for (size_t i = 0; i < kMaxIssuesOfKind; ++i) log.add({IssueId::stray_file, {.file = "a"}, ""});
  EXPECT_FALSE(log.error_below("/scales"));
  log.add({IssueId::stray_file, {.file = "b"}, "", 5});
  EXPECT_EQ(log.issues().size(), kMaxIssuesOfKind);
  EXPECT_EQ(log.issues().back().count, 6u);
  EXPECT_FALSE(log.error_below("/scales")) << "a warning";
  for (size_t i = 0; i < kMaxIssuesOfKind + 1; ++i) log.add({IssueId::name_taken, {.pointer = "/stages"}, ""});
  EXPECT_TRUE(log.error_below("/scales")) << "it may have been there";
}

TEST(HostileBundle, AnObjectOfManyMembersIsRefused) {
  std::string text = "{";
  for (int i = 0; i < 5000; ++i) text += "\"k" + std::to_string(i) + "\": 0, ";
  IssueLog log("", IssueLog::OnError::collect);
  parse_json(text + "\"last\": 0}", log);
  ASSERT_EQ(log.issues().size(), 1u);
  EXPECT_EQ(log.issues()[0].id, IssueId::json_too_deep);
}

TEST(HostileBundle, ALongListOfObjectsTakesTimeInProportion) {
  // A list that is searched for each of its elements would take minutes, and the test's time limit.
  std::string text = "[{}";
  for (int i = 0; i < 1000000; ++i) text += ",{}";
  IssueLog log("", IssueLog::OnError::collect);
  EXPECT_EQ(parse_json(text + "]", log).size(), 1000001u);
  EXPECT_THAT(log.issues(), IsEmpty());
}

/// A bundle whose manifest has these members beside those that say that it is one.
fs::path bundle_of_text(const TemporaryFolder& folder, const std::string& members) {
  fs::create_directories(folder / "a.texbundle");
  write_text(folder / "a.texbundle/bundle.json",
             R"({"asset": {"kind": "texbake.bundle", "version": "1.0", "minVersion": "1.0", "semantics": 1}, )" +
                 members + "}");
  return folder / "a.texbundle";
}

std::string repeated(const std::string& text, int count) {
  std::string all = text;
  for (int i = 1; i < count; ++i) all += "," + text;
  return all;
}

TEST(HostileBundle, MoreScalesThanThereMayBeAreOneIssue) {
  const TemporaryFolder folder;
  const fs::path bundle =
      bundle_of_text(folder, R"("sources": [], "stages": [], "scales": [)" + repeated("{}", 350000) + "]");
  uint64_t about_scales = 0;
  for (const Issue& issue : verify_bundle(bundle))
    if (issue.where.pointer.starts_with("/scales")) {
      about_scales += issue.count;
      EXPECT_THAT(text(issue), testing::HasSubstr("at most 16 elements"));
    }
  EXPECT_EQ(about_scales, 1u);
}

TEST(HostileBundle, AListThatIsTooLongIsOneIssueWhateverIsInIt) {
  const TemporaryFolder folder;
  const fs::path bundle = bundle_of_text(
      folder, R"("generator": "", "scales": [], "sources": [], "stages": [)" + repeated("{}", 2000) + "]");
  uint64_t about_stages = 0;
  for (const Issue& issue : verify_bundle(bundle))
    if (issue.where.pointer.starts_with("/stages")) about_stages += issue.count;
  EXPECT_EQ(about_stages, 1u);
}

TEST(HostileBundle, AManifestHasAsManyValuesAsItsReaderHasRoomFor) {
  const auto issues_of = [](size_t values) {
    IssueLog log("", IssueLog::OnError::collect);
    parse_json("[" + repeated("{}", static_cast<int>(values) - 1) + "]", log);
    return log.issues();
  };
  EXPECT_THAT(issues_of(kMaxValues), IsEmpty());
  const std::vector<Issue> issues = issues_of(kMaxValues + 1);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].id, IssueId::json_too_deep);
  EXPECT_THAT(text(issues[0]), testing::HasSubstr("1048576 values"));
}

TEST(HostileBundle, WhatNoReaderTakesIsNotWritten) {
  const TemporaryFolder folder;
  Bundle bundle = bundle_without_history();
  write_bundle(bundle, folder / "a.texbundle");
  const auto before = folder_contents(folder / "a.texbundle");
  bundle.extras = {{"long", std::vector<int>(kMaxValues, 0)}};
  EXPECT_THROW(write_bundle(bundle, folder / "a.texbundle"), Error);
  bundle.extras = {{"large", std::string(kMaxManifestBytes, 'x')}};
  EXPECT_THROW(write_bundle(bundle, folder / "a.texbundle"), Error);
  EXPECT_EQ(folder_contents(folder / "a.texbundle"), before);
}

TEST(HostileBundle, AMessageShowsTheBeginningOfALongValue) {
  EXPECT_EQ(shortened_json(Json::parse("[[1, 2], [3, 4]]"), 100), "[[1,2],[3,4]]");
  EXPECT_EQ(shortened_json(Json::parse("[[1, 2], [3, 4]]"), 5), "[[1,2...");
  EXPECT_EQ(shortened_json(std::string(100, 'a'), 4), "\"aaa...");
}

TEST(HostileBundle, NamesOfAnyLengthAreShownInAFewBytes) {
  const TemporaryFolder folder;
  write_bundle(bundle_without_history(), folder / "a.texbundle");
  IssueLog reading("", IssueLog::OnError::throw_first);
  Json json = parse_json(file_text(folder / "a.texbundle/bundle.json"), reading);
  json["scales"][0][std::string(100000, '/')] = 1;
  write_text(folder / "a.texbundle/bundle.json", print_json(json));
  for (const Issue& issue : verify_bundle(folder / "a.texbundle")) EXPECT_LT(text(issue).size(), 1000u);
}

}  // namespace
}  // namespace texbake
