#include "formats/verify_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "formats/json_text.h"
#include "libbake/base/portable_math.h"

namespace texbake {
namespace {

constexpr double kUnitTolerance = 1e-5;     // three squares of floats near 1
constexpr double kMeanTolerance = 0x1p-10;  // a mean may have been rounded to half, 11 bits, on its way
constexpr double kMeanFloor = 1e-6;         // below it colors are black whatever their ratio
constexpr double kMatrixTolerance = 1;      // of 65536: rounding, either way

bool is_close(const V3f& a, const V3f& b) {
  for (int c = 0; c < 3; ++c)
    if (std::abs(a[c] - b[c]) > kMeanFloor + kMeanTolerance * std::abs(b[c])) return false;
  return true;
}

IssueId issue_of(PartitionFault::Kind kind) {
  switch (kind) {
    case PartitionFault::Kind::idx_out_of_range:
      return IssueId::label_range;
    case PartitionFault::Kind::empty_shape:
      return IssueId::shape_empty;
    case PartitionFault::Kind::not_connected:
      return IssueId::shape_not_connected;
    case PartitionFault::Kind::inconsistent_owner:
      return IssueId::shape_owner;
    case PartitionFault::Kind::too_large:
      return IssueId::shape_too_large;
    case PartitionFault::Kind::wrong_center:
      return IssueId::shape_center;
    case PartitionFault::Kind::wrong_area:
      return IssueId::shape_area;
  }
  return IssueId::shape_owner;
}

/// One issue for each kind of fault, at the first shape that has it.
void check_partition_of(const ScaleUnderTest& test, const char* part, const Partition& partition, IssueLog& log) {
  std::map<IssueId, Issue> found;
  for (const PartitionFault& fault : check_partition(partition)) {
    const IssueId id = issue_of(fault.kind);
    const auto [at, is_first] = found.try_emplace(id);
    if (is_first)
      at->second = {
          id,
          {.file = test.file, .part = part, .texel = fault.texel},
          fmt::format("expected fragments and patches as the specification defines them, first violated by {} {}", part,
                      fault.shape),
          fault.count};
    else
      at->second.count += fault.count;
  }
  // A center, an area or a name without texels in the manifest's list of patches has been reported there.
  const std::string listed = test.pointer + "/patches";
  for (const auto& [id, issue] : found)
    if (part != std::string("patch") || !std::ranges::any_of(log.issues(), [&, same = id](const Issue& before) {
          return before.id == same && before.where.pointer.starts_with(listed);
        }))
      log.add(issue);
}

/// The mean of the base over each fragment, summed in row order.
std::vector<V3f> fragment_means(const Scale& scale) {
  const Partition& partition = scale.fragments->partition;
  std::vector<Imath::V3d> sums(scale.fragments->fragments.size(), Imath::V3d(0));
  for (size_t i = 0; i < partition.idx.size(); ++i) sums[partition.idx.data()[i]] += Imath::V3d(scale.base().data()[i]);
  std::vector<V3f> means;
  for (size_t i = 0; i < sums.size(); ++i) means.emplace_back(sums[i] / std::max<double>(1, partition.areas_px[i]));
  return means;
}

void check_fragment_colors(const ScaleUnderTest& test, IssueLog& log) {
  const std::vector<Fragment>& fragments = test.scale.fragments->fragments;
  const std::vector<V3f> means = fragment_means(test.scale);
  Issue issue{IssueId::fragment_color, {.file = test.file, .part = "fragmentColor"}, "", 0};
  for (size_t i = 0; i < fragments.size(); ++i) {
    if (is_close(fragments[i].mean_color, means[i]) || issue.count++ > 0) continue;
    issue.detail = fmt::format("expected {} for fragment {}, found {}", vector_text(means[i]), i,
                               vector_text(fragments[i].mean_color));
    const auto width = static_cast<size_t>(test.size.x);
    issue.where.texel = V2i(static_cast<int>(i % width), static_cast<int>(i / width));
  }
  if (issue.count > 0) log.add(issue);
}

void check_whole_fragments(const ScaleUnderTest& test, IssueLog& log) {
  const Image<uint32_t>& fragment = test.scale.fragments->partition.idx;
  const Image<uint32_t>& patch = test.scale.patches->partition.idx;
  constexpr uint32_t kUnseen = UINT32_MAX;
  std::vector<uint32_t> patch_of(test.scale.fragments->partition.centers.size(), kUnseen);
  Issue issue{IssueId::fragment_split, {.file = test.file, .part = "patch"}, "", 0};
  for (int y = 0; y < patch.height(); ++y)
    for (int x = 0; x < patch.width(); ++x) {
      uint32_t& expected = patch_of[fragment(x, y)];
      if (expected == kUnseen) expected = patch(x, y);
      if (expected == patch(x, y) || issue.count++ > 0) continue;
      issue.where.texel = V2i(x, y);
      issue.detail =
          fmt::format("expected patch {} for all of fragment {}, found {}", expected, fragment(x, y), patch(x, y));
    }
  if (issue.count > 0) log.add(issue);
}

/// 65536 cos θ / λ and −65536 sin θ / λ.
std::array<double, 2> matrix_of(const Content& content) {
  constexpr double kEighth = 0.78539816339744830962;  // π/4
  const double angle = content.rotation_eighths * kEighth;
  return {65536 * portable_cos(angle) / content.scale, -65536 * portable_sin(angle) / content.scale};
}

void check_content(const Content& content, V2i size, const std::string& pointer, IssueLog& log) {
  const V2i t = content.translation;
  if (shortest(wrap(t, size), size) != t)
    log.add({IssueId::content_translation,
             {.pointer = pointer + "/translation"},
             fmt::format("expected ({}, {}), found ({}, {})", shortest(wrap(t, size), size).x,
                         shortest(wrap(t, size), size).y, t.x, t.y)});
  const auto [a, b] = matrix_of(content);
  if (std::abs(content.a - a) > kMatrixTolerance || std::abs(content.b - b) > kMatrixTolerance)
    log.add({IssueId::content_matrix,
             {.pointer = pointer + "/matrix"},
             fmt::format("expected [{}, {}], found [{}, {}]", std::lround(a), std::lround(b), content.a, content.b)});
}

void check_repeated(const ContentTable& table, int patch, const std::string& pointer, IssueLog& log) {
  for (int c = 1; c < table.content_count; ++c)
    for (int before = 0; before < c; ++before) {
      const Content &one = table.at(patch, before), &other = table.at(patch, c);
      if (one.translation != other.translation || one.a != other.a || one.b != other.b) continue;
      log.add({IssueId::content_repeated,
               {.pointer = fmt::format("{}/contents/{}/{}", pointer, patch, c)},
               fmt::format("expected a different content, found that of content {}", before)});
      break;
    }
}

}  // namespace

void check_palette(const ScaleUnderTest& test, IssueLog& log) {
  const std::vector<ColorClass>& classes = test.scale.colors->palette.classes;
  std::vector<uint64_t> texels(classes.size(), 0);
  for (const uint8_t k : test.scale.colors->index) ++texels[k];
  for (size_t k = 0; k < classes.size(); ++k) {
    const std::string at = fmt::format("{}/palette/{}", test.pointer, k);
    const V3f& v = classes[k].variation;
    const double length = std::sqrt(double{v.x} * v.x + double{v.y} * v.y + double{v.z} * v.z);
    const float largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (std::abs(length - 1) > kUnitTolerance)
      log.add(
          {IssueId::palette_unit, {.pointer = at + "/variation"}, fmt::format("expected length 1, found {}", length)});
    if (largest != std::max({v.x, v.y, v.z}))
      log.add({IssueId::palette_sign,
               {.pointer = at + "/variation"},
               fmt::format("expected the component of largest magnitude to be positive, found {}", vector_text(v))});
    if (k > 0 && classes[k].dominant.x < classes[k - 1].dominant.x)
      log.add({IssueId::palette_order,
               {.pointer = at + "/dominant"},
               fmt::format("expected L of at least {}, found {}", classes[k - 1].dominant.x, classes[k].dominant.x)});
    if (texels[k] == 0) log.add({IssueId::class_unused, {.pointer = at}, "expected a texel of the class, found none"});
  }
}

void check_means(const ScaleUnderTest& test, const V3f& mean, IssueLog& log) {
  const V3f found = mean_color(test.scale.base());
  if (!is_close(mean, found))
    log.add({IssueId::mean_mismatch,
             {.pointer = test.pointer + "/mean"},
             fmt::format("expected {}, found {}", vector_text(found), vector_text(mean))});
  if (test.has("fragment") && test.has("fragmentColor")) check_fragment_colors(test, log);
}

void check_partitions(const ScaleUnderTest& test, IssueLog& log) {
  if (test.has("fragment")) check_partition_of(test, "fragment", test.scale.fragments->partition, log);
  if (test.has("patch")) check_partition_of(test, "patch", test.scale.patches->partition, log);
  if (test.has("fragment") && test.has("patch")) check_whole_fragments(test, log);
}

void check_contents(const ScaleUnderTest& test, IssueLog& log) {
  const ContentTable& table = *test.scale.contents;
  for (int p = 0; p < table.patch_count; ++p) {
    for (int c = 0; c < table.content_count; ++c) {
      const std::string pointer = fmt::format("{}/contents/{}/{}", test.pointer, p, c);
      if (c == 0 && table.at(p, c) != Content())
        log.add({IssueId::content_identity,
                 {.pointer = pointer},
                 "expected translation [0, 0], rotationEighths 0, scale 1, matrix [65536, 0] and impact 0"});
      check_content(table.at(p, c), test.size, pointer, log);
    }
    check_repeated(table, p, test.pointer, log);
  }
}

}  // namespace texbake
