// The numbered issues: everything that can be wrong with a bundle, in one list. formats/README.md documents the same
// numbers; a test checks that both agree and that each number has a bundle that raises it.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libbake/base/error.h"
#include "libbake/base/torus.h"

namespace texbake {

using Json = nlohmann::ordered_json;

enum class IssueId : int {
  not_found = 101,
  not_a_bundle = 102,
  manifest_unreadable = 103,
  manifest_too_large = 104,
  json_syntax = 105,
  json_too_deep = 106,
  json_duplicate_key = 107,
  stray_file = 108,

  asset_kind = 201,
  version_too_new = 202,
  extension_unknown = 203,
  semantics_unknown = 204,
  tiling_unknown = 205,
  schema_violation = 206,
  name_taken = 207,
  file_name_unsafe = 208,
  plane_missing = 209,
  count_mismatch = 210,
  member_unknown = 211,
  scale_order = 212,

  file_missing = 301,
  exr_unreadable = 302,
  part_missing = 303,
  part_kind = 304,
  part_window = 305,
  part_channels = 306,
  file_too_small = 307,
  hash_mismatch = 308,
  file_name_hash = 309,
  part_unlisted = 310,
  preview_not_first = 311,
  part_compression = 312,
  file_unreadable = 313,

  not_finite = 401,
  color_range = 402,
  index_range = 403,
  label_range = 404,
  owner_range = 405,
  fragment_class_range = 406,
  height_range = 407,
  map_range = 408,
  mask_range = 409,
  spectrum_range = 410,

  palette_unit = 501,
  palette_sign = 502,
  palette_order = 503,
  class_unused = 504,
  mean_mismatch = 505,
  shape_empty = 511,
  shape_not_connected = 512,
  shape_owner = 513,
  shape_too_large = 514,
  shape_center = 515,
  shape_area = 516,
  fragment_split = 521,
  fragment_color = 522,
  content_identity = 531,
  content_translation = 532,
  content_matrix = 533,
  content_repeated = 534,
  soft_border_width = 535,
  mask_sum = 541,
  spectrum_form = 542,
  noise_axes = 543,
  noise_tile = 544,
  noise_strength = 545,

  transfer_missing = 551,
  transfer_list = 552,
  transfer_fragments = 553,

  state_mismatch = 601,
  chain_broken = 602,
  stage_missing = 603,
  figure_implausible = 604,
};

enum class Severity {
  warning,  ///< the bundle can be used
  error,    ///< the bundle must not be used
};

/// What one number means.
struct IssueKind {
  IssueId id;
  const char* name;
  Severity severity;
  ErrorKind error;  ///< of the exception that reading throws, for severity error
  const char* meaning;
  const char* fix;
};

/// All kinds, by rising number.
std::span<const IssueKind> issue_kinds();
const IssueKind& issue_kind(IssueId id);

/// Where an issue lies: in the manifest (a JSON pointer) or in a payload file.
struct Place {
  std::string pointer = {};
  std::string file = {};
  std::string part = {};
  std::optional<V2i> texel = {};  ///< the first one, in row order
};

struct Issue {
  IssueId id = IssueId::not_found;
  Place where;
  std::string detail;  ///< "expected ..., found ..."
  uint64_t count = 1;  ///< texels, or members, that share the issue

  const IssueKind& kind() const { return issue_kind(id); }
  int number() const { return static_cast<int>(id); }
};

/// One line for people: number, name, place, what was expected and found, how to mend it.
std::string text(const Issue& issue);
/// {number, name, severity, pointer | file, part, texel, count, detail, fix}
Json to_json(const Issue& issue);
bool has_errors(std::span<const Issue> issues);

inline constexpr size_t kMaxIssuesOfKind = 200;  ///< that a log keeps: whoever made the bundle may want millions

/// Where checks leave what they find: a list, or, when reading, an exception at the first error. Of each kind the first
/// kMaxIssuesOfKind are kept; the last of these counts the others.
class IssueLog {
 public:
  enum class OnError { collect, throw_first };
  IssueLog(std::string bundle_name, OnError on_error) : bundle_name_(std::move(bundle_name)), on_error_(on_error) {}

  /// Throws Error of the issue's kind when errors throw and this is one.
  void add(Issue issue);
  /// Would another issue of this kind be kept? Else `count_more` does what `add` would do, at no cost.
  bool shows_more(IssueId id) const;
  /// One more of a kind of which no more are kept.
  void count_more(IssueId id, uint64_t count = 1);
  const std::vector<Issue>& issues() const { return issues_; }
  /// Is there an error at `pointer` or below it? Once an error has not been kept, it may be anywhere: yes.
  bool error_below(const std::string& pointer) const;
  size_t error_count() const { return error_count_; }

 private:
  std::string bundle_name_;
  OnError on_error_;
  std::vector<Issue> issues_;
  std::map<IssueId, std::vector<size_t>> kept_;  ///< of each kind, where in issues_
  size_t error_count_ = 0;
  bool dropped_errors_ = false;
};

}  // namespace texbake
