#include "formats/bundle_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "formats/sha256.h"
#include "formats/verify.h"
#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

ErrorKind kind_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("expected"));
    EXPECT_THAT(error.what(), testing::HasSubstr("found"));
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorKind::usage;
}

void expect_round_trip(const Bundle& bundle) {
  const TemporaryFolder folder;
  write_bundle(bundle, folder / "a.texbundle");
  expect_equal(read_bundle(folder / "a.texbundle"), bundle);
  EXPECT_FALSE(has_errors(verify_bundle(folder / "a.texbundle")));
}

/// The bundle after `verb` and what is before it in the chain.
Bundle state_after(const std::string& verb) {
  Bundle bundle = bundle_with_everything();
  bundle.stages.clear();
  Scale& scale = bundle.scales[0];
  scale.contents.reset();
  if (verb == "patch") return bundle;
  scale.patches.reset();
  if (verb == "fragment") return bundle;
  scale.fragments.reset();
  return bundle;
}

TEST(BundleIo, EverythingIsReadBackBitForBit) { expect_round_trip(bundle_with_everything()); }

TEST(BundleIo, ABundleIsWrittenAtEveryStateOfTheChain) {
  for (const char* verb : {"convert", "fragment", "patch"}) {
    SCOPED_TRACE(verb);
    expect_round_trip(state_after(verb));
  }
}

TEST(BundleIo, AnExemplarWithoutAnalysisIsABundle) {
  Bundle bundle = state_after("convert");
  bundle.scales[0].colors.reset();
  bundle.scales[0].height.reset();
  bundle.scales[0].maps.clear();
  bundle.scales[0].tile_from_source.reset();
  expect_round_trip(bundle);
}

TEST(BundleIo, StructureIsTheBaseAndTravelsBesideTheExemplar) {
  Bundle bundle = state_after("convert");
  bundle.scales[0].structure = Image<V3f>(64, 64, V3f(0.25f));
  expect_round_trip(bundle);
  EXPECT_EQ(&bundle.scales[0].base(), &*bundle.scales[0].structure);
}

TEST(BundleIo, ThePaletteFormStoresNoExemplarAndDecodesIt) {
  Bundle bundle = state_after("convert");
  bundle.scales[0].stores_exemplar = false;
  bundle.scales[0].exemplar = palette_exemplar(*bundle.scales[0].colors);
  expect_round_trip(bundle);
  const TemporaryFolder folder;
  write_bundle(bundle, folder / "a.texbundle");
  IssueLog log("", IssueLog::OnError::throw_first);
  const Json manifest = parse_json(file_text(folder / "a.texbundle/bundle.json"), log);
  EXPECT_FALSE(manifest["scales"][0]["planes"].contains("exemplar"));
}

TEST(BundleIo, SeveralScalesHaveAFileEach) {
  Bundle bundle = bundle_with_everything();
  bundle.stages.clear();
  bundle.scales.insert(bundle.scales.begin(), scale_with_everything(32, "coarse"));
  bundle.scales[1].transfer = {.ratio = 7,
                               .mode = TransferMode::bilinear,
                               .detail_mean = DetailMean::local,
                               .variation = VariationFrom::fine,
                               .variation_fade = 1.1f,
                               .weights = {0, 0.3f, 1},
                               .coarse_weights = {1, 1, 0.1f},
                               .detail_gains = {2, 1, 1}};
  expect_round_trip(bundle);
}

TEST(BundleIo, ATileNeedNotBeSquareOrEven) {
  Bundle bundle;
  Scale& scale = bundle.scales.emplace_back();
  scale.exemplar = Image<V3f>(7, 3, V3f(0.5f, 0, 65504));
  expect_round_trip(bundle);
}

TEST(BundleIo, WritingTwiceGivesTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Bundle bundle = bundle_with_everything();
  write_bundle(bundle, folder / "a.texbundle");
  const auto bytes = folder_contents(folder / "a.texbundle");
  EXPECT_EQ(bytes.size(), 4u);
  for (const size_t threads : {1u, 2u, 8u}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const fs::path again = folder / (std::to_string(threads) + ".texbundle");
    write_bundle(bundle, again);
    EXPECT_EQ(folder_contents(again), bytes) << threads;
    write_bundle(read_bundle(again), again);
    EXPECT_EQ(folder_contents(again), bytes) << threads << " after reading";
  }
}

TEST(BundleIo, EqualContentHasEqualNamesAndOtherContentAnother) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(0.5f), folder / "a.texbundle");
  write_bundle(bundle_with_everything(0.5f), folder / "b.texbundle");
  write_bundle(bundle_with_everything(0.25f), folder / "c.texbundle");
  EXPECT_EQ(payload_of(folder / "a.texbundle").filename(), payload_of(folder / "b.texbundle").filename());
  EXPECT_NE(payload_of(folder / "a.texbundle").filename(), payload_of(folder / "c.texbundle").filename());
}

TEST(BundleIo, ReplacingABundleLeavesOnlyTheNewOne) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(0.5f), folder / "a.texbundle");
  write_bundle(bundle_with_everything(0.25f), folder / "a.texbundle/");
  write_bundle(bundle_with_everything(0.25f), folder / "b.texbundle");
  EXPECT_EQ(folder_contents(folder / "a.texbundle"), folder_contents(folder / "b.texbundle"));
}

TEST(BundleIo, ASpoiledPayloadUnderTheRightNameIsWrittenAnew) {
  const TemporaryFolder folder;
  const Bundle bundle = bundle_with_everything();
  write_bundle(bundle, folder / "a.texbundle");
  const auto bytes = folder_contents(folder / "a.texbundle");
  write_text(payload_of(folder / "a.texbundle"), "not an image");
  write_bundle(bundle, folder / "a.texbundle");
  EXPECT_EQ(folder_contents(folder / "a.texbundle"), bytes);
}

TEST(BundleIo, UnknownMembersOfANewerMinorVersionAreIgnoredAndKept) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(), folder / "a.texbundle");
  IssueLog log("", IssueLog::OnError::throw_first);
  Json manifest = parse_json(file_text(folder / "a.texbundle/bundle.json"), log);
  manifest["asset"]["version"] = "1.7";
  manifest["weather"] = {{"rain", 0.5}};
  write_text(folder / "a.texbundle/bundle.json", print_json(manifest));
  const Bundle read = read_bundle(folder / "a.texbundle");
  EXPECT_EQ(read.unknown["weather"]["rain"], 0.5);
  write_bundle(read, folder / "b.texbundle");
  EXPECT_EQ(read_bundle(folder / "b.texbundle").unknown, read.unknown);
}

TEST(BundleIo, UnknownSemanticsAreReadOnlyOnRequestAndNeverWritten) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(), folder / "a.texbundle");
  IssueLog log("", IssueLog::OnError::throw_first);
  Json manifest = parse_json(file_text(folder / "a.texbundle/bundle.json"), log);
  manifest["asset"]["semantics"] = 9;
  write_text(folder / "a.texbundle/bundle.json", print_json(manifest));
  EXPECT_EQ(kind_of([&] { read_bundle(folder / "a.texbundle"); }), ErrorKind::unsupported);
  const Bundle read = read_bundle(folder / "a.texbundle", {.semantics = Semantics::any});
  EXPECT_EQ(read.semantics, 9);
  EXPECT_EQ(kind_of([&] { write_bundle(read, folder / "b.texbundle"); }), ErrorKind::unsupported);
}

TEST(BundleIo, NothingOfTheMachineIsInside) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(), folder / "a.texbundle");
  for (const auto& [name, bytes] : folder_contents(folder / "a.texbundle"))
    for (const char* word : {"capDate", "utcOffset", "/tmp", "hostname"})
      EXPECT_EQ(bytes.find(word), std::string::npos) << word << " in " << name;
}

TEST(BundleIo, AMissingBundleIsAnIoErrorAndAnEmptyFolderBadData) {
  const TemporaryFolder folder;
  EXPECT_EQ(kind_of([&] { read_bundle(folder / "none.texbundle"); }), ErrorKind::io);
  EXPECT_EQ(kind_of([&] { read_bundle(folder.path()); }), ErrorKind::bad_data);
}

TEST(BundleIo, WhatIsNotABundleIsRefusedAndStaysAsItWas) {
  const TemporaryFolder folder;
  const Bundle bundle = bundle_with_everything();
  write_text(folder / "file", "precious");
  fs::create_directory(folder / "foreign");
  write_text(folder / "foreign/fine-0123456789ab.exr", "precious");
  fs::create_directory(folder / "other");
  write_text(folder / "other/bundle.json", R"({"asset": {"kind": "something else"}})");
  const auto before = folder_contents(folder.path());
  for (const char* name : {"file", "foreign", "other", "none/a.texbundle"})
    EXPECT_EQ(kind_of([&] { write_bundle(bundle, folder / name); }), ErrorKind::io) << name;
  EXPECT_EQ(folder_contents(folder.path()), before);
  EXPECT_EQ(file_text(folder / "foreign/fine-0123456789ab.exr"), "precious");
}

TEST(BundleIo, AnEmptyFolderBecomesTheBundle) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "a.texbundle");
  write_bundle(bundle_with_everything(), folder / "a.texbundle");
  EXPECT_TRUE(verify_bundle(folder / "a.texbundle").empty());
}

TEST(BundleIo, ANameThatTheSchemaForbidsIsNotWritten) {
  const TemporaryFolder folder;
  Bundle bundle = bundle_with_everything();
  bundle.scales[0].maps[0].name = "a b";
  EXPECT_EQ(kind_of([&] { write_bundle(bundle, folder / "a.texbundle"); }), ErrorKind::bad_data);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace texbake
