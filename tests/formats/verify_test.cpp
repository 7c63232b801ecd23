#include "formats/verify.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <limits>
#include <set>

#include "tests/formats/bundle_fixtures.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;
using enum IssueId;

/// One way to spoil a bundle, and the issue it must raise.
struct Fault {
  IssueId id;
  std::function<void(Bundle&)> bundle = {};         ///< before it is written, so that all hashes agree
  std::function<void(Json&)> manifest = {};         ///< bundle.json, afterwards
  std::function<void(const fs::path&)> files = {};  ///< the folder, at last
};

Json manifest_at(const fs::path& folder) {
  IssueLog log("", IssueLog::OnError::throw_first);
  return parse_json(file_text(folder / "bundle.json"), log);
}

void replace_in_manifest(const fs::path& folder, const std::string& from, const std::string& to) {
  std::string text = file_text(folder / "bundle.json");
  const size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  write_text(folder / "bundle.json", text.replace(at, from.size(), to));
}

/// Writes the payload again under its old name, with other parts.
void rewrite_payload(const fs::path& folder, const std::function<void(std::vector<ExrPart>&)>& change) {
  const Scale scale = scale_with_everything();
  std::vector<ExrPart> parts;
  for (const ScalePlane& plane : planes_of(scale))
    if (parts.empty() || parts.back().shape.part != plane.shape.part) parts.push_back(exr_part(plane));
  change(parts);
  SafeFile file(payload_of(folder));
  write_exr(file, {64, 64}, parts);
  file.commit();
}

size_t number_of(const std::vector<ExrPart>& parts, const std::string& name) {
  return static_cast<size_t>(std::ranges::find(parts, name, [](const ExrPart& part) { return part.shape.part; }) -
                             parts.begin());
}

ExrPart zeros(const PlaneShape& shape) {
  return {shape, [bytes = shape.row_bytes()](int, std::byte* row) { std::fill_n(row, bytes, std::byte{0}); }};
}

Imf::Header imf_header(const std::string& part, int size, const char* type) {
  Imf::Header header(size, size);
  header.setName(part);
  header.setType(type);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(Imf::HALF));
  return header;
}

/// A file whose header promises a picture of 16384² and that holds none of it.
void promise_too_much(const fs::path& folder) {
  Bundle bundle;
  bundle.scales.emplace_back().exemplar = Image<V3f>(1, 1, V3f(0.5f));
  BundleRefs refs = plane_refs(bundle);
  PlaneRefs& planes = refs.scales[0];
  for (PlaneRef& ref : planes) ref.shape.width = ref.shape.height = 16384;
  for (PlaneRef& ref : planes) ref.file = payload_name("fine", planes);
  StateJson state = state_json(bundle, refs);
  state.scales[0]["size"] = {16384, 16384};
  write_text(folder / "bundle.json", print_json(manifest_json(bundle, state)));
  const Imf::Header header = imf_header("preview", 16384, Imf::SCANLINEIMAGE.c_str());
  const Imf::MultiPartOutputFile file((folder / planes[0].file).c_str(), &header, 1);
}

void write_tiled(const fs::path& folder) {
  Imf::Header header = imf_header("preview", 64, Imf::TILEDIMAGE.c_str());
  header.setTileDescription(Imf::TileDescription(16, 16));
  const Imf::MultiPartOutputFile file(payload_of(folder).c_str(), &header, 1);
}

/// The preview alone, compressed in another way.
void write_compressed(const fs::path& path, Imf::Compression compression) {
  Imf::Header header = imf_header("preview", 64, Imf::SCANLINEIMAGE.c_str());
  header.compression() = compression;
  const Imf::MultiPartOutputFile file(path.c_str(), &header, 1);
}

void cut_to(const fs::path& file, double share) {
  fs::resize_file(file, static_cast<uintmax_t>(share * static_cast<double>(fs::file_size(file))));
}

Partition& fragments_of(Bundle& bundle) { return bundle.scales[0].fragments->partition; }
Partition& patches_of(Bundle& bundle) { return bundle.scales[0].patches->partition; }
Noise& first_noise(Bundle& bundle) { return bundle.noise->noises[0]; }
ColorClass& first_class(Bundle& bundle) { return bundle.scales[0].colors->palette.classes[0]; }
Json& scale_of(Json& manifest) { return manifest["scales"][0]; }

std::vector<Fault> faults_of_the_manifest() {
  return {
      {.id = not_found, .files = [](const fs::path& path) { fs::remove_all(path); }},
      {.id = not_a_bundle, .files = [](const fs::path& path) { fs::remove(path / "bundle.json"); }},
      {.id = manifest_too_large,
       .files = [](const fs::path& path) { fs::resize_file(path / "bundle.json", 65 << 20); }},
      {.id = json_syntax, .files = [](const fs::path& path) { cut_to(path / "bundle.json", 0.5); }},
      {.id = json_too_deep,
       .manifest =
           [](Json& json) {
             Json deep = 1;
             for (int i = 0; i < 100; ++i) deep = Json::array({deep});
             json["extras"]["deep"] = deep;
           }},
      {.id = json_duplicate_key,
       .files = [](const fs::path& path) { replace_in_manifest(path, "\"asset\":", "\"asset\": 1, \"asset\":"); }},
      {.id = stray_file, .files = [](const fs::path& path) { write_text(path / "notes.txt", "x"); }},
      {.id = asset_kind, .manifest = [](Json& json) { json["asset"]["kind"] = "other"; }},
      {.id = version_too_new, .manifest = [](Json& json) { json["asset"]["version"] = "2.0"; }},
      {.id = version_too_new, .manifest = [](Json& json) { json["asset"]["minVersion"] = "1.1"; }},
      {.id = extension_unknown, .manifest = [](Json& json) { json["extensionsRequired"] = {"ACME_wet"}; }},
      {.id = semantics_unknown, .manifest = [](Json& json) { json["asset"]["semantics"] = 2; }},
      {.id = tiling_unknown, .manifest = [](Json& json) { scale_of(json)["tiling"] = 2; }},
      {.id = schema_violation, .manifest = [](Json& json) { scale_of(json)["size"] = "large"; }},
      {.id = schema_violation, .manifest = [](Json& json) { json.erase("generator"); }},
      {.id = schema_violation,
       .manifest =
           [](Json& json) {
             scale_of(json)["size"] = {100000, 64};
           }},
      {.id = name_taken, .manifest = [](Json& json) { scale_of(json)["maps"][1]["name"] = "normal"; }},
      {.id = name_taken, .manifest = [](Json& json) { json["scales"].push_back(scale_of(json)); }},
      {.id = file_name_unsafe,
       .manifest = [](Json& json) { scale_of(json)["planes"]["index"]["file"] = "../../etc/passwd"; }},
      {.id = file_name_unsafe, .manifest = [](Json& json) { scale_of(json)["planes"]["index"]["file"] = ".."; }},
      {.id = plane_missing, .manifest = [](Json& json) { scale_of(json).erase("palette"); }},
      {.id = plane_missing, .manifest = [](Json& json) { scale_of(json)["planes"].erase("fragmentClass"); }},
      {.id = count_mismatch, .manifest = [](Json& json) { scale_of(json)["contents"].erase(0); }},
      {.id = count_mismatch, .manifest = [](Json& json) { scale_of(json)["contents"][3].erase(1); }},
      {.id = count_mismatch, .manifest = [](Json& json) { scale_of(json)["fragments"]["count"] = 5000; }},
      {.id = count_mismatch, .manifest = [](Json& json) { json["noise"]["noises"].erase(1); }},
      {.id = plane_missing, .manifest = [](Json& json) { scale_of(json)["planes"].erase("masks"); }},
      {.id = schema_violation, .manifest = [](Json& json) { json["noise"]["tileSize"] = 500; }},
      {.id = schema_violation, .manifest = [](Json& json) { json["noise"]["rowStep"] = 5000; }},
      {.id = member_unknown, .manifest = [](Json& json) { scale_of(json)["colour"] = 1; }},
      {.id = scale_order,
       .bundle =
           [](Bundle& bundle) {
             bundle.scales.push_back(scale_with_everything(160, "finer"));
             bundle.scales[1].transfer = ScaleTransfer{.ratio = 2};
           }},
  };
}

std::vector<Fault> faults_of_the_payload() {
  return {
      {.id = file_missing, .files = [](const fs::path& path) { fs::remove(payload_of(path)); }},
      {.id = exr_unreadable, .files = [](const fs::path& path) { cut_to(payload_of(path), 0.9); }},
      {.id = exr_unreadable, .files = [](const fs::path& path) { cut_to(payload_of(path, "noise-"), 0.9); }},
      {.id = file_missing, .files = [](const fs::path& path) { fs::remove(payload_of(path, "spectra-")); }},
      {.id = exr_unreadable, .files = [](const fs::path& path) { write_text(payload_of(path), "P6 64 64 255"); }},
      {.id = part_missing,
       .files =
           [](const fs::path& path) {
             rewrite_payload(path, [](auto& parts) { parts.erase(parts.begin() + number_of(parts, "patch")); });
           }},
      {.id = part_kind, .files = write_tiled},
      {.id = part_compression,
       .files = [](const fs::path& path) { write_compressed(payload_of(path), Imf::PIZ_COMPRESSION); }},
      {.id = part_window,
       .files =
           [](const fs::path& path) {
             rewrite_payload(path, [](auto& parts) { parts[number_of(parts, "height")].shape.height = 63; });
           }},
      {.id = part_channels,
       .files =
           [](const fs::path& path) {
             rewrite_payload(path, [](auto& parts) {
               ExrPart& part = parts[number_of(parts, "fragment")];
               part.shape.type = PixelType::float32;
               part = zeros(part.shape);
             });
           }},
      {.id = part_channels,
       .files =
           [](const fs::path& path) {
             rewrite_payload(path, [](auto& parts) { parts[number_of(parts, "patch")].shape.channels[1] = "other"; });
           }},
      {.id = file_too_small, .files = promise_too_much},
      {.id = hash_mismatch,
       .files =
           [](const fs::path& path) {
             rewrite_payload(path, [](auto& parts) {
               ExrPart& part = parts[number_of(parts, "height")];
               part = zeros(part.shape);
             });
           }},
      {.id = file_name_hash,
       .manifest = [](Json& json) { scale_of(json)["planes"]["index"]["pixelHash"] = std::string(64, '7'); }},
      {.id = part_unlisted,
       .files =
           [](const fs::path& path) {
             rewrite_payload(path, [](auto& parts) {
               parts.push_back(zeros({"extra", {"Y"}, PixelType::half, 64, 64}));
             });
           }},
      {.id = preview_not_first,
       .files =
           [](const fs::path& path) { rewrite_payload(path, [](auto& parts) { std::swap(parts[0], parts[1]); }); }},
  };
}

std::vector<Fault> faults_of_the_pixels() {
  return {
      {.id = not_finite,
       .bundle =
           [](Bundle& bundle) {
             bundle.scales[0].colors->variation(5, 6) = std::numeric_limits<float>::quiet_NaN();
             bundle.scales[0].colors->variation(7, 6) = std::numeric_limits<float>::infinity();
           }},
      {.id = color_range, .bundle = [](Bundle& bundle) { bundle.scales[0].exemplar(1, 2).y = -1; }},
      {.id = index_range, .bundle = [](Bundle& bundle) { bundle.scales[0].colors->index(1, 2) = 200; }},
      {.id = label_range, .bundle = [](Bundle& bundle) { fragments_of(bundle).idx(1, 2) = 4000000000u; }},
      {.id = owner_range,
       .bundle =
           [](Bundle& bundle) {
             patches_of(bundle).owner(1, 2) = {5, 1};
           }},
      {.id = fragment_class_range,
       .bundle = [](Bundle& bundle) { bundle.scales[0].fragments->fragments[9].class_idx = 3; }},
      {.id = height_range, .bundle = [](Bundle& bundle) { bundle.scales[0].height->operator()(9, 9) = 1.5f; }},
      {.id = mask_range, .bundle = [](Bundle& bundle) { bundle.scales[0].masks[1](9, 9) = 1.5f; }},
      {.id = spectrum_range, .bundle = [](Bundle& bundle) { first_noise(bundle).channels[1].spectrum(3, 2) = -1; }},
      {.id = map_range, .bundle = [](Bundle& bundle) { bundle.scales[0].maps[1].planes[0](9, 9) = -0.5f; }},
  };
}

std::vector<Fault> faults_of_the_tables() {
  return {
      {.id = palette_unit, .bundle = [](Bundle& bundle) { first_class(bundle).variation *= 1.01f; }},
      {.id = palette_sign, .bundle = [](Bundle& bundle) { first_class(bundle).variation *= -1; }},
      {.id = palette_order, .bundle = [](Bundle& bundle) { first_class(bundle).dominant.x = 70; }},
      {.id = class_unused,
       .bundle =
           [](Bundle& bundle) {
             bundle.scales[0].colors->palette.classes.push_back({{90, 0, 0}, {0, 1, 0}});
           }},
      {.id = mean_mismatch, .manifest = [](Json& json) { scale_of(json)["mean"][1] = 0.9; }},
      {.id = shape_empty,
       .bundle =
           [](Bundle& bundle) {
             bundle.scales[0].fragments->fragments.push_back({});
             fragments_of(bundle).centers.emplace_back(0);
             fragments_of(bundle).areas_px.push_back(0);
           }},
      {.id = shape_not_connected,
       .bundle = [](Bundle& bundle) { fragments_of(bundle).idx(30, 30) = fragments_of(bundle).idx(10, 10); }},
      {.id = shape_owner,
       .bundle =
           [](Bundle& bundle) {
             fragments_of(bundle).owner(30, 30) = {1, 0};
           }},
      {.id = shape_too_large,
       .bundle =
           [](Bundle& bundle) {
             for (int x = 10; x < 45; ++x) fragments_of(bundle).idx(x, 30) = fragments_of(bundle).idx(10, 30);
           }},
      {.id = shape_center, .manifest = [](Json& json) { scale_of(json)["patches"][5]["center"][0] = 1; }},
      {.id = shape_area, .manifest = [](Json& json) { scale_of(json)["patches"][5]["areaPx"] = 17; }},
      {.id = fragment_split,
       .bundle =
           [](Bundle& bundle) {
             Partition& patches = patches_of(bundle);  // squares of 16 texels that start at (-3, -5)
             patches.idx(28, 20) = patches.idx(29, 20);
             patches.owner(28, 20) = patches.owner(29, 20);
           }},
      {.id = fragment_color,
       .bundle = [](Bundle& bundle) { bundle.scales[0].fragments->fragments[9].mean_color.z = 0; }},
      {.id = content_identity, .manifest = [](Json& json) { scale_of(json)["contents"][2][0]["impact"] = 3.5; }},
      {.id = content_translation,
       .manifest =
           [](Json& json) {
             scale_of(json)["contents"][2][1]["translation"] = {40, 0};
           }},
      {.id = content_matrix,
       .manifest =
           [](Json& json) {
             scale_of(json)["contents"][2][1]["matrix"] = {65536, 90};
           }},
      {.id = content_repeated,
       .manifest = [](Json& json) { scale_of(json)["contents"][2][1] = scale_of(json)["contents"][2][2]; }},
      {.id = mask_sum, .bundle = [](Bundle& bundle) { bundle.scales[0].masks[1](9, 9) += 0.5f; }},
      {.id = mask_sum,
       .bundle =
           [](Bundle& bundle) {
             bundle.scales[0].masks[0](9, 9) = 0x1p-13f;  // half-exact, but no multiple of 1/2048
             bundle.scales[0].masks[1](9, 9) = 1.0f;
           }},
      {.id = spectrum_form, .bundle = [](Bundle& bundle) { first_noise(bundle).channels[2].spectrum(1, 2) *= 1.5f; }},
      {.id = spectrum_form, .bundle = [](Bundle& bundle) { first_noise(bundle).channels[2].spectrum(0, 0) = 0.5f; }},
      {.id = noise_axes, .bundle = [](Bundle& bundle) { first_noise(bundle).basis.axis[1] *= 1.01f; }},
      {.id = noise_tile,
       .bundle =
           [](Bundle& bundle) {
             for (V3f& color : first_noise(bundle).tile) color = half_exact(color * 2.0f);
           }},
      {.id = noise_strength,
       .bundle = [](Bundle& bundle) { bundle.scales[0].structure = bundle.scales[0].exemplar.clone(); }},
      {.id = transfer_missing,
       .bundle = [](Bundle& bundle) { bundle.scales.push_back(scale_with_everything(64, "finer")); }},
      {.id = transfer_missing, .bundle = [](Bundle& bundle) { bundle.scales[0].transfer.emplace(); }},
      {.id = transfer_list,
       .bundle =
           [](Bundle& bundle) {
             bundle.scales.push_back(scale_with_everything(64, "finer"));
             bundle.scales[1].transfer = ScaleTransfer{.weights = {1, 0.5f}};
           }},
      {.id = transfer_fragments,
       .bundle =
           [](Bundle& bundle) {
             bundle.scales.push_back(scale_with_everything(64, "finer"));
             bundle.scales[1].transfer.emplace();
             bundle.scales[1].contents.reset(), bundle.scales[1].patches.reset(), bundle.scales[1].fragments.reset();
           }},
      {.id = state_mismatch, .manifest = [](Json& json) { json["stages"][5]["output"] = std::string(64, 'b'); }},
      {.id = soft_border_width, .manifest = [](Json& json) { scale_of(json)["softBorder"] = 30; }},
      {.id = chain_broken, .manifest = [](Json& json) { json["stages"][2]["input"] = std::string(64, 'b'); }},
      {.id = stage_missing, .manifest = [](Json& json) { json["stages"].erase(1); }},
      {.id = stage_missing, .manifest = [](Json& json) { json["stages"].erase(2); }},
      {.id = figure_implausible, .manifest = [](Json& json) { json["stages"][0]["figures"]["meanDeltaE"] = nullptr; }},
      {.id = figure_implausible, .manifest = [](Json& json) { json["stages"][3]["figures"]["count"] = 63; }},
  };
}

std::vector<Fault> all_faults() {
  std::vector<Fault> all;
  for (auto* list : {&faults_of_the_manifest, &faults_of_the_payload, &faults_of_the_pixels, &faults_of_the_tables})
    for (Fault& fault : list()) all.push_back(std::move(fault));
  return all;
}

/// A copy of a sound bundle that is written once.
void copy_sound(const fs::path& path) {
  static const TemporaryFolder folder;
  if (fs::is_empty(folder.path())) write_bundle(bundle_with_everything(), folder / "a.texbundle");
  fs::copy(folder / "a.texbundle", path);
}

void write_spoiled(const Fault& fault, const fs::path& path) {
  if (fault.bundle) {
    Bundle bundle = bundle_with_everything();
    fault.bundle(bundle);
    write_bundle(bundle, path);
  } else {
    copy_sound(path);
  }
  Json manifest = manifest_at(path);
  if (fault.manifest) fault.manifest(manifest);
  write_text(path / "bundle.json", print_json(manifest));
  if (fault.files) fault.files(path);
}

TEST(Verify, FindsNothingWrongWithASoundBundle) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(), folder / "a.texbundle");
  for (const Issue& issue : verify_bundle(folder / "a.texbundle")) ADD_FAILURE() << text(issue);
}

TEST(Verify, EveryFaultRaisesItsIssueWithItsPlaceAndItsFix) {
  for (const Fault& fault : all_faults()) {
    SCOPED_TRACE(issue_kind(fault.id).name);
    const TemporaryFolder folder;
    write_spoiled(fault, folder / "a.texbundle");
    const std::vector<Issue> issues = verify_bundle(folder / "a.texbundle");
    const auto found = std::ranges::find(issues, fault.id, &Issue::id);
    if (found == issues.end()) {
      ADD_FAILURE() << "not raised";
      for (const Issue& issue : issues) std::printf("    instead: %s\n", text(issue).c_str());
      continue;
    }
    EXPECT_THAT(text(*found), testing::HasSubstr("expected"));
    EXPECT_TRUE(!found->where.pointer.empty() || !found->where.file.empty());
    EXPECT_GE(found->count, 1u);
  }
}

TEST(Verify, EveryNumberHasAFault) {
  std::set<IssueId> raised;
  for (const Fault& fault : all_faults()) raised.insert(fault.id);
  raised.insert({manifest_unreadable, file_unreadable});  // below: they take another user
  for (const IssueKind& kind : issue_kinds()) EXPECT_TRUE(raised.contains(kind.id)) << kind.name;
}

/// What is found in a bundle of which `forbid` has forbidden a part to all but root.
std::vector<Issue> issues_without_permission(const std::function<void(const fs::path&)>& forbid) {
  const TemporaryFolder folder;
  const fs::path path = folder / "a.texbundle";
  write_bundle(bundle_with_everything(), path);
  forbid(path);
  const bool is_root = ::geteuid() == 0;
  constexpr uid_t kNobody = 65534;
  if (is_root && ::seteuid(kNobody) != 0) ADD_FAILURE() << "this user cannot become another";
  std::vector<Issue> issues = verify_bundle(path);
  if (is_root && ::seteuid(0) != 0) ADD_FAILURE() << "this user cannot come back";
  fs::permissions(path, fs::perms::owner_all);
  return issues;
}

TEST(Verify, WhatMayNotBeReadIsAnIoErrorAndNoInvalidBundle) {
  const auto forbid = [](const fs::path& path) { fs::permissions(path, fs::perms::none); };
  const std::pair<IssueId, std::function<void(const fs::path&)>> cases[] = {
      {manifest_unreadable, [&](const fs::path& path) { forbid(path / "bundle.json"); }},
      {manifest_unreadable, forbid},
      {file_unreadable, [&](const fs::path& path) { forbid(payload_of(path)); }},
      {file_unreadable, [&](const fs::path& path) { forbid(payload_of(path, "noise-")); }}};
  for (const auto& [id, spoil] : cases) {
    SCOPED_TRACE(issue_kind(id).name);
    const std::vector<Issue> issues = issues_without_permission(spoil);
    ASSERT_FALSE(issues.empty());
    EXPECT_EQ(issues[0].id, id);
    EXPECT_EQ(issues[0].kind().error, ErrorKind::io);
    EXPECT_THAT(issues[0].detail, testing::HasSubstr("Permission denied"));
  }
}

TEST(Verify, ReadingThrowsTheFirstErrorOfWhatItChecks) {
  // What costs a pass over neighbors or sums is verify's alone.
  const std::set<IssueId> only_verify = {
      palette_unit,    palette_sign,   mean_mismatch,  shape_empty,      shape_not_connected, shape_owner,
      shape_too_large, fragment_split, fragment_color, content_identity, content_translation, content_matrix,
      mask_sum,        spectrum_form,  noise_axes,     state_mismatch};
  for (const Fault& fault : all_faults()) {
    const IssueKind& kind = issue_kind(fault.id);
    SCOPED_TRACE(kind.name);
    const TemporaryFolder folder;
    write_spoiled(fault, folder / "a.texbundle");
    if (kind.severity == Severity::warning || only_verify.contains(fault.id)) continue;
    try {
      read_bundle(folder / "a.texbundle");
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind.error) << error.what();
      EXPECT_THAT(error.what(), testing::HasSubstr("found"));
    }
  }
}

TEST(Verify, CountsTexelsAndNamesTheFirst) {
  const TemporaryFolder folder;
  Bundle bundle = bundle_with_everything();
  for (int x = 20; x < 30; ++x) bundle.scales[0].height->operator()(x, 40) = 2;
  write_bundle(bundle, folder / "a.texbundle");
  const std::vector<Issue> issues = verify_bundle(folder / "a.texbundle");
  const auto found = std::ranges::find(issues, height_range, &Issue::id);
  ASSERT_NE(found, issues.end());
  EXPECT_EQ(found->count, 10u);
  EXPECT_EQ(found->where.part, "height");
  EXPECT_EQ(found->where.texel, V2i(20, 40));
}

TEST(Verify, PointsAtTheMemberThatTheSchemaForbids) {
  const TemporaryFolder folder;
  write_spoiled(
      {.id = schema_violation, .manifest = [](Json& json) { scale_of(json)["contents"][7][2]["rotationEighths"] = 8; }},
      folder / "a.texbundle");
  const std::vector<Issue> issues = verify_bundle(folder / "a.texbundle");
  ASSERT_FALSE(issues.empty());
  EXPECT_EQ(issues[0].id, schema_violation);
  EXPECT_EQ(issues[0].where.pointer, "/scales/0/contents/7/2/rotationEighths");
  EXPECT_THAT(issues[0].detail, testing::HasSubstr("found 8"));
}

TEST(Verify, OpenExrSeesNoOtherCompressionThanZip) {
  const TemporaryFolder folder;
  copy_sound(folder / "a.texbundle");
  for (int number = 0; number < Imf::NUM_COMPRESSION_METHODS; ++number) {
    const auto compression = static_cast<Imf::Compression>(number);
    write_compressed(payload_of(folder / "a.texbundle"), compression);
    std::set<IssueId> of_the_scale;
    for (const Issue& issue : verify_bundle(folder / "a.texbundle"))
      if (issue.where.file.starts_with("fine-")) of_the_scale.insert(issue.id);
    EXPECT_EQ(of_the_scale.contains(part_compression), compression != Imf::ZIP_COMPRESSION) << number;
    EXPECT_EQ(of_the_scale.contains(part_missing), compression == Imf::ZIP_COMPRESSION) << number << ": was opened";
  }
}

TEST(Verify, APayloadCutAtAnyPlaceIsAnIssueAndNeverACrash) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(), folder / "a.texbundle");
  const fs::path payload = payload_of(folder / "a.texbundle");
  const std::string whole = file_text(payload);
  for (size_t bytes = 0; bytes < whole.size(); bytes += bytes < 3000 ? 61 : 4001) {
    write_text(payload, whole.substr(0, bytes));
    EXPECT_TRUE(has_errors(verify_bundle(folder / "a.texbundle"))) << bytes;
  }
}

TEST(Verify, AFlippedByteInThePayloadIsFoundOrHarmlessAndNeverACrash) {
  const TemporaryFolder folder;
  const Bundle bundle = bundle_with_everything();
  write_bundle(bundle, folder / "a.texbundle");
  const fs::path payload = payload_of(folder / "a.texbundle");
  const std::string whole = file_text(payload);
  Random random(3);
  for (int round = 0; round < 80; ++round) {
    const size_t at = random.below(round % 2 ? 3000 : static_cast<uint32_t>(whole.size()));
    std::string spoiled = whole;
    spoiled[at] = static_cast<char>(spoiled[at] ^ (1 << random.below(8)));
    write_text(payload, spoiled);
    if (!has_errors(verify_bundle(folder / "a.texbundle"))) expect_equal(read_bundle(folder / "a.texbundle"), bundle);
  }
}

TEST(Verify, AnEditedManifestIsNeverACrash) {
  const TemporaryFolder folder;
  write_bundle(bundle_with_everything(), folder / "a.texbundle");
  const std::string whole = file_text(folder / "a.texbundle/bundle.json");
  Random random(4);
  for (int round = 0; round < 150; ++round) {
    std::string spoiled = whole;
    for (uint32_t i = 0; i <= random.below(3); ++i)
      spoiled[random.below(static_cast<uint32_t>(whole.size()))] = "0123456789-{}[],:\"ae."[random.below(20)];
    write_text(folder / "a.texbundle/bundle.json", spoiled);
    verify_bundle(folder / "a.texbundle");
  }
}

}  // namespace
}  // namespace texbake
