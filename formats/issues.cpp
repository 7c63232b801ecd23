#include "formats/issues.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace texbake {
namespace {

using enum IssueId;
constexpr Severity kError = Severity::error;
constexpr Severity kWarning = Severity::warning;
constexpr ErrorKind kData = ErrorKind::bad_data;
constexpr ErrorKind kUnsupported = ErrorKind::unsupported;

constexpr const char* kBakeAgain = "bake the bundle again from its sources";
constexpr const char* kRestore = "restore the file from a copy, or bake the bundle again";
constexpr const char* kNewer = "use a newer texbake, or bake the bundle again with this one";

constexpr IssueKind kKinds[] = {
    {not_found, "not-found", kError, ErrorKind::io, "no file or folder has this path", "check the path"},
    {not_a_bundle, "not-a-bundle", kError, kData, "the path is not a folder with a bundle.json",
     "name a .texbundle folder; texbake convert makes one from a picture"},
    {manifest_unreadable, "manifest-unreadable", kError, ErrorKind::io, "bundle.json cannot be read",
     "check the permissions and the disk"},
    {manifest_too_large, "manifest-too-large", kError, kData, "bundle.json is larger than 64 MiB", kRestore},
    {json_syntax, "json-syntax", kError, kData, "bundle.json is not JSON in UTF-8", kRestore},
    {json_too_deep, "json-too-deep", kError, kData,
     "bundle.json nests deeper than 64 levels, an object has more than 4096 members, or there are more than 1048576 "
     "values",
     kRestore},
    {json_duplicate_key, "json-duplicate-key", kError, kData, "an object has the same key twice", kRestore},
    {stray_file, "stray-file", kWarning, kData, "the folder holds a file that the manifest does not name",
     "remove it; files left by killed writers are removed the next time texbake writes this bundle"},

    {asset_kind, "asset-kind", kError, kData, "asset.kind is not texbake.bundle, or asset is malformed", kRestore},
    {version_too_new, "version-too-new", kError, kUnsupported,
     "asset.version has a newer major number, or asset.minVersion is above what this program reads", kNewer},
    {extension_unknown, "extension-unknown", kError, kUnsupported, "a required extension is not known", kNewer},
    {semantics_unknown, "semantics-unknown", kError, kUnsupported,
     "asset.semantics is not known: the same bytes would mean another picture", kNewer},
    {tiling_unknown, "tiling-unknown", kError, kUnsupported, "tiling is not 1, one periodic tile", kNewer},
    {schema_violation, "schema-violation", kError, kData, "bundle.json does not follow bundle.schema.json", kRestore},
    {name_taken, "name-taken", kError, kData, "two scales, or two maps of a scale, have the same name", kRestore},
    {file_name_unsafe, "file-name-unsafe", kError, kData, "a payload file is not a plain file name in the folder",
     "do not use this bundle: a name that points outside its folder is not there by accident"},
    {plane_missing, "plane-missing", kError, kData, "a plane or table that another one needs is missing", kBakeAgain},
    {count_mismatch, "count-mismatch", kError, kData, "counts that must agree differ", kBakeAgain},
    {member_unknown, "member-unknown", kWarning, kData,
     "a member that version 1.0 does not define; it is ignored, and kept or dropped as section 2 of the specification "
     "says",
     "put your own data under extras or extensions"},
    {scale_order, "scale-order", kError, kData, "scales are not ordered coarse to fine", kBakeAgain},

    {file_missing, "file-missing", kError, kData, "a payload file is missing", kRestore},
    {exr_unreadable, "exr-unreadable", kError, kData, "a payload file is not readable OpenEXR, or is truncated",
     kRestore},
    {part_missing, "part-missing", kError, kData, "a payload file lacks a part that a plane names", kRestore},
    {part_kind, "part-kind", kError, kData, "a part is tiled or deep, not scan lines", kRestore},
    {part_window, "part-window", kError, kData, "the data window of a part is not the size of its plane", kRestore},
    {part_channels, "part-channels", kError, kData, "a part lacks a channel, or the channel has another type",
     kRestore},
    {file_too_small, "file-too-small", kError, kData, "a payload file is too small for the pixels it promises",
     kRestore},
    {hash_mismatch, "hash-mismatch", kError, kData,
     "the pixels of a plane are not those that the manifest was written for", kRestore},
    {file_name_hash, "file-name-hash", kError, kData,
     "the digits in the name of a payload file are not the hash of its planes", kRestore},
    {part_unlisted, "part-unlisted", kWarning, kData, "a payload file has a part that no plane names", kBakeAgain},
    {preview_not_first, "preview-not-first", kWarning, kData, "the first part of a payload file is not the preview",
     kBakeAgain},
    {part_compression, "part-compression", kError, kData, "a part is compressed by another method than ZIP", kRestore},
    {file_unreadable, "file-unreadable", kError, ErrorKind::io, "a payload file is there but may not be read",
     "check the permissions and the disk"},

    {not_finite, "not-finite", kError, kData, "texels are NaN or infinite", kBakeAgain},
    {color_range, "color-range", kError, kData, "colors are negative", kBakeAgain},
    {index_range, "index-range", kError, kData, "texels have a class that the palette lacks", kBakeAgain},
    {label_range, "label-range", kError, kData, "texels have a fragment or patch that does not exist", kBakeAgain},
    {owner_range, "owner-range", kError, kData, "owner offsets are not 0 to 8", kBakeAgain},
    {fragment_class_range, "fragment-class-range", kError, kData, "fragments have a class that the palette lacks",
     kBakeAgain},
    {height_range, "height-range", kError, kData, "heights are outside 0 to 1", kBakeAgain},
    {map_range, "map-range", kError, kData,
     "values of a map from an integer source are outside 0 to 1 (normals: -1 to 1)", kBakeAgain},
    {mask_range, "mask-range", kError, kData, "weights of a mask are outside 0 to 1", kBakeAgain},
    {spectrum_range, "spectrum-range", kError, kData, "magnitudes of a spectrum are negative", kBakeAgain},

    {palette_unit, "palette-unit", kError, kData, "a direction of variation is not a unit vector", kBakeAgain},
    {palette_sign, "palette-sign", kError, kData, "the largest component of a direction of variation is not positive",
     kBakeAgain},
    {palette_order, "palette-order", kWarning, kData, "classes are not ordered dark to light", kBakeAgain},
    {class_unused, "class-unused", kWarning, kData, "no texel has this class", "bake again with fewer classes"},
    {mean_mismatch, "mean-mismatch", kError, kData, "mean is not the mean of the base", kBakeAgain},
    {shape_empty, "shape-empty", kError, kData, "a fragment or patch has no texel", kBakeAgain},
    {shape_not_connected, "shape-not-connected", kError, kData, "a fragment or patch is not 4-connected on the torus",
     kBakeAgain},
    {shape_owner, "shape-owner", kError, kData,
     "owner offsets of neighboring texels of a fragment or patch contradict each other", kBakeAgain},
    {shape_too_large, "shape-too-large", kError, kData,
     "the unwrapped bounding box of a fragment or patch is not less than half the tile", kBakeAgain},
    {shape_center, "shape-center", kError, kData,
     "the center of a fragment or patch is not its centroid, or lies outside the tile", kBakeAgain},
    {shape_area, "shape-area", kError, kData, "areaPx of a patch is not the number of its texels", kBakeAgain},
    {fragment_split, "fragment-split", kError, kData, "a fragment lies in more than one patch", kBakeAgain},
    {fragment_color, "fragment-color", kError, kData, "a fragment's mean color is not the mean of the base over it",
     kBakeAgain},
    {content_identity, "content-identity", kError, kData, "content 0 of a patch is not the identity with impact 0",
     kBakeAgain},
    {content_translation, "content-translation", kError, kData,
     "a translation is not the shortest on the torus (-n/2 to (n-1)/2)", kBakeAgain},
    {content_matrix, "content-matrix", kError, kData, "matrix does not follow from rotationEighths and scale",
     kBakeAgain},
    {content_repeated, "content-repeated", kWarning, kData, "a patch has the same content twice",
     "run select-contents again"},
    {soft_border_width, "soft-border-width", kError, kData,
     "softBorder is wider than an eighth of the tile, or there are no patches", "run select-contents again"},
    {mask_sum, "mask-sum", kError, kData, "masks are not multiples of 1/2048 whose sum is 1", kBakeAgain},
    {spectrum_form, "spectrum-form", kError, kData, "a spectrum is not even, or is not 0 at frequency 0", kBakeAgain},
    {noise_axes, "noise-axes", kError, kData, "the color axes of a noise are not orthonormal", kBakeAgain},
    {noise_tile, "noise-tile", kWarning, kData, "the variance of a noise tile is far from that of its spectrum",
     "run estimate-psd again"},
    {noise_strength, "noise-strength", kWarning, kData,
     "the variance of a spectrum is far from that of the noise layer inside its mask", "run estimate-psd again"},

    {transfer_missing, "transfer-missing", kError, kData,
     "a scale does not say how it takes its colors from the coarser one, or the coarsest scale does",
     "stack the scales again"},
    {transfer_list, "transfer-list", kError, kData, "a list of a transfer does not have one number for each class",
     "stack the scales again"},
    {transfer_fragments, "transfer-fragments", kError, kData,
     "a scale that takes the colors of a coarser one lacks fragments", "stack the scales again"},
    {state_mismatch, "state-mismatch", kError, kData,
     "the output hash of a stage does not match the results in the bundle", kBakeAgain},
    {chain_broken, "chain-broken", kWarning, kData, "the input of a stage has been replaced since it ran",
     "run the chain again if the history matters"},
    {stage_missing, "stage-missing", kWarning, kData, "no stage records where a plane or table comes from",
     "run the chain again if the history matters"},
    {figure_implausible, "figure-implausible", kWarning, kData,
     "a recorded figure is null, or differs from what the bundle holds", "run the stage again"},
};

std::string place_text(const Place& place) {
  std::string text = place.pointer.empty() ? place.file : fmt::format("bundle.json {}", place.pointer);
  if (!place.part.empty()) text += fmt::format(", part {}", place.part);
  if (place.texel) text += fmt::format(", texel ({}, {})", place.texel->x, place.texel->y);
  return text;
}

}  // namespace

std::span<const IssueKind> issue_kinds() { return kKinds; }

const IssueKind& issue_kind(IssueId id) {
  const auto found = std::ranges::find(kKinds, id, &IssueKind::id);
  assert(found != std::end(kKinds));
  return *found;
}

std::string text(const Issue& issue) {
  const std::string place = place_text(issue.where);
  const std::string count = issue.count > 1 ? fmt::format(" ({} times)", issue.count) : "";
  return fmt::format("{} {} {}{}{}: {}{}; {}", issue.kind().severity == kError ? "error" : "warning", issue.number(),
                     issue.kind().name, place.empty() ? "" : " at ", place, issue.detail, count, issue.kind().fix);
}

Json to_json(const Issue& issue) {
  Json json = {{"number", issue.number()},
               {"name", issue.kind().name},
               {"severity", issue.kind().severity == kError ? "error" : "warning"}};
  if (!issue.where.pointer.empty()) json["pointer"] = issue.where.pointer;
  if (!issue.where.file.empty()) json["file"] = issue.where.file;
  if (!issue.where.part.empty()) json["part"] = issue.where.part;
  if (issue.where.texel) json["texel"] = {issue.where.texel->x, issue.where.texel->y};
  json["count"] = issue.count;
  json["detail"] = issue.detail;
  json["fix"] = issue.kind().fix;
  return json;
}

bool has_errors(std::span<const Issue> issues) {
  return std::ranges::any_of(issues, [](const Issue& issue) { return issue.kind().severity == kError; });
}

void IssueLog::add(Issue issue) {
  const bool is_error = issue.kind().severity == kError;
  if (is_error && on_error_ == OnError::throw_first)
    throw Error(issue.kind().error, fmt::format("{}: {}", bundle_name_, text(issue)));
  if (!shows_more(issue.id)) return count_more(issue.id, issue.count);
  if (is_error) ++error_count_;
  kept_[issue.id].push_back(issues_.size());
  issues_.push_back(std::move(issue));
}

bool IssueLog::shows_more(IssueId id) const {
  const auto kept = kept_.find(id);
  return kept == kept_.end() || kept->second.size() < kMaxIssuesOfKind;
}

void IssueLog::count_more(IssueId id, uint64_t count) {
  Issue& last = issues_[kept_.at(id).back()];
  last.count += count;
  if (last.kind().severity == kError) dropped_errors_ = true;
}

bool IssueLog::error_below(const std::string& pointer) const {
  return dropped_errors_ || std::ranges::any_of(issues_, [&](const Issue& issue) {
           const std::string& at = issue.where.pointer;
           return issue.kind().severity == kError && at.starts_with(pointer) &&
                  (at.size() == pointer.size() || at[pointer.size()] == '/');
         });
}

}  // namespace texbake
