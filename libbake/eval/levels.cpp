#include "libbake/eval/levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "libbake/base/error.h"
#include "libbake/base/parallel.h"
#include "libbake/eval/local_mean.h"
#include "libbake/eval/program_of.h"
#include "libbake/eval/soft_cover.h"

namespace texbake {
namespace {

using glsl::LevelBlock;
using glsl::PatchTexel;
using glsl::Program;
using glsl::vec4;

constexpr int kListWidth = 4096;                  ///< texels in a row of level_entries and of values
constexpr uint32_t kMaxEntriesInBlock = 1 << 12;  ///< what LevelBlock can count

constexpr V2i kChildren[] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};

/// The entries of all levels, one level after the other. Entry 0 of the whole is kept for the mean. Of level 0 only
/// texels of several patches have any.
struct Lists {
  SoftCover texels;                  ///< without weights where borders are hard
  std::vector<uint32_t> soft_first;  ///< number of a texel's first entry, where borders are soft
  std::vector<LevelCover> covers;    ///< of level 1, 2, …
  std::vector<uint32_t> first;       ///< number of each level's first entry
  uint64_t count = 1;                ///< entries in all
};

bool too_crowded(const LevelCover& cover) {
  for (size_t i = 0; i + 1 < cover.first.size(); ++i)
    if (cover.first[i + 1] - cover.first[i] > kMaxEntriesInBlock) return true;
  return false;
}

void count_soft_texels(Lists& lists) {
  const auto& first = lists.texels.cover.first;
  for (size_t i = 0; i + 1 < first.size(); ++i) {
    const uint32_t count = first[i + 1] - first[i];
    lists.soft_first.push_back(count > 1 ? static_cast<uint32_t>(lists.count) : 0);
    if (count > 1) lists.count += count;
  }
}

Lists lists_of(const EvaluatorPlanes& planes) {
  Lists lists;
  if (planes.soft_border_px > 0) {
    lists.texels = soft_cover(planes.patch_plane, planes.soft_border_px);
    count_soft_texels(lists);
  } else {
    lists.texels.cover = texel_cover(planes.patch_plane);
  }
  for (int level = 1; level <= level_count_of(planes.size); ++level) {
    LevelCover cover = halved(level == 1 ? lists.texels.cover : lists.covers.back());
    if (too_crowded(cover)) break;
    lists.first.push_back(static_cast<uint32_t>(lists.count));
    lists.count += cover.entries.size();
    lists.covers.push_back(std::move(cover));
  }
  const uint64_t values = lists.count * static_cast<uint64_t>(planes.content_count);
  if (values > std::numeric_limits<uint32_t>::max())
    throw Error(ErrorKind::infeasible,
                fmt::format("levels of detail: expected less than 2^32 values, found {}: {} shares of blocks with {} "
                            "contents each; use a smaller tile or fewer contents",
                            values, lists.count, planes.content_count));
  return lists;
}

V2i corner_of(int level, V2i size) {
  if (level == 1) return {0, 0};
  return {size.x >> 1, (size.y >> 1) - (size.y >> (level - 1))};
}

LevelBlock block_of(uint32_t first, std::span<const PatchTexel> entries) {
  const uint32_t owned = entries[0].patch_idx | static_cast<uint32_t>(entries[0].owner) << 16;
  return {first, owned | static_cast<uint32_t>(entries.size() - 1) << 20};
}

void store_blocks(const Lists& lists, EvaluatorPlanes& planes) {
  const V2i size = planes.size;
  const bool soft = planes.soft_border_px > 0;
  planes.level_count = static_cast<int>(lists.covers.size());
  planes.first_level = soft ? 0 : 1;
  const int rows = size.y / 2 + (soft ? size.y : 0);
  planes.level_blocks = Image<LevelBlock>(rows > 0 ? size.x : 1, std::max(rows, 1));
  for (int level = 1; level <= planes.level_count; ++level) {
    const LevelCover& cover = lists.covers[static_cast<size_t>(level - 1)];
    const uint32_t first = lists.first[static_cast<size_t>(level - 1)];
    const V2i corner = corner_of(level, size);
    for (int y = 0; y < cover.size.y; ++y)
      for (int x = 0; x < cover.size.x; ++x)
        planes.level_blocks(corner.x + x, corner.y + y) = block_of(first + cover.first_at(x, y), cover.at(x, y));
  }
  if (!soft) return;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      planes.level_blocks(x, size.y / 2 + y) =
          block_of(lists.soft_first[static_cast<size_t>(y) * static_cast<size_t>(size.x) + static_cast<size_t>(x)],
                   lists.texels.cover.at(x, y));
}

int list_rows(uint64_t count) { return static_cast<int>((count + kListWidth - 1) / kListWidth); }

void store_entries(const Lists& lists, EvaluatorPlanes& planes) {
  planes.level_entries = Image<PatchTexel>(kListWidth, list_rows(lists.count));
  const LevelCover& texels = lists.texels.cover;
  for (size_t i = 0; i < lists.soft_first.size(); ++i)
    if (lists.soft_first[i] > 0)
      std::copy(texels.entries.begin() + texels.first[i], texels.entries.begin() + texels.first[i + 1],
                planes.level_entries.begin() + lists.soft_first[i]);
  for (size_t i = 0; i < lists.covers.size(); ++i)
    std::copy(lists.covers[i].entries.begin(), lists.covers[i].entries.end(),
              planes.level_entries.begin() + lists.first[i]);
}

/// What one content shows, as entries of a level below are asked for it: texels are evaluated, blocks are looked up.
class Values {
 public:
  Values(const EvaluatorPlanes& planes, const Plane& plane, const Lists& lists, Image<vec4>& values)
      : planes_(planes), plane_(plane), lists_(lists), values_(values) {
    if (planes.soft_border_px > 0) local_mean_ = local_mean(plane.texels, planes.soft_border_px);
  }

  void fill() {
    if (planes_.soft_border_px > 0)
      parallel_for(0, planes_.size.y, [&](int y) {
        for (int x = 0; x < planes_.size.x; ++x) fill_texel({x, y});
      });
    for (int level = 1; level <= planes_.level_count; ++level)
      parallel_for(0, cover_of(level).size.y, [&](int y) {
        for (int x = 0; x < cover_of(level).size.x; ++x) fill_block(level, {x, y});
      });
    const vec4 mean = mean_value();
    for (int content = 0; content < planes_.content_count; ++content) value(0, content) = mean;
  }

 private:
  const LevelCover& cover_of(int level) const { return lists_.covers[static_cast<size_t>(level - 1)]; }
  uint32_t first_of(int level) const { return lists_.first[static_cast<size_t>(level - 1)]; }

  vec4& value(uint32_t entry, int content) const {
    return values_.data()[size_t{entry} * static_cast<size_t>(planes_.content_count) + static_cast<size_t>(content)];
  }

  uint32_t soft_first(V2i p) const {
    if (lists_.soft_first.empty()) return 0;
    return lists_.soft_first[static_cast<size_t>(p.y) * static_cast<size_t>(planes_.size.x) + static_cast<size_t>(p.x)];
  }

  /// A texel of several patches, of weights w. A plain blend of independent contents would keep Σ w² of their variance,
  /// and all of it where they are the same, as when all are the identity: of N_t² pairs of draws, one. What differs
  /// from the local mean is enlarged so that the variance is kept on the average.
  void fill_texel(V2i p) {
    const uint32_t first = soft_first(p);
    if (first == 0) return;
    const auto entries = lists_.texels.cover.at(p.x, p.y);
    const float* const weights = lists_.texels.weights.data() + lists_.texels.cover.first_at(p.x, p.y);
    float squares = 0;
    for (size_t i = 0; i < entries.size(); ++i) squares += weights[i] * weights[i];
    const auto pairs = static_cast<float>(planes_.content_count) * static_cast<float>(planes_.content_count);
    const float gain = 1 / std::sqrt(squares + (1 - squares) / pairs);
    for (size_t i = 0; i < entries.size(); ++i)
      for (int content = 0; content < planes_.content_count; ++content) {
        const vec4 mean = shown(local_mean_, p, entries[i], content);
        const vec4 detail = shown(plane_.texels, p, entries[i], content) - mean;
        value(first + static_cast<uint32_t>(i), content) = (mean + detail * gain) * weights[i];
      }
  }

  void fill_block(int level, V2i block) {
    const auto entries = cover_of(level).at(block.x, block.y);
    uint32_t entry = first_of(level) + cover_of(level).first_at(block.x, block.y);
    for (const PatchTexel& owned : entries) {
      for (int content = 0; content < planes_.content_count; ++content)
        value(entry, content) = share(level, block, owned, content);
      ++entry;
    }
  }

  /// A quarter of what the four blocks of the finer level hold of it.
  vec4 share(int level, V2i block, const PatchTexel& owned, int content) {
    vec4 sum(0, 0, 0, 0);
    for (const V2i& child : kChildren) {
      const V2i at = block * 2 + child;
      const auto finer = entries_at(level - 1, at);
      const auto found = std::find(finer.begin(), finer.end(), owned);
      if (found == finer.end()) continue;
      sum = sum + share_at(level - 1, at, static_cast<uint32_t>(found - finer.begin()), content);
    }
    return sum * 0.25f;
  }

  std::span<const PatchTexel> entries_at(int level, V2i block) const {
    return (level == 0 ? lists_.texels.cover : cover_of(level)).at(block.x, block.y);
  }

  /// Entry `i` of a block, or of a texel.
  vec4 share_at(int level, V2i block, uint32_t i, int content) const {
    if (level > 0) return value(first_of(level) + cover_of(level).first_at(block.x, block.y) + i, content);
    if (const uint32_t first = soft_first(block); first > 0) return value(first + i, content);
    return shown(plane_.texels, block, planes_.patch_plane(block.x, block.y), content);
  }

  /// What a patch's content shows at a texel, of the plane or of what stands in its place.
  vec4 shown(const Image<vec4>& texels, V2i p, const PatchTexel& owned, int content) const {
    Program program = program_of(planes_, 0);
    const glsl::Decision decision{owned.patch_idx, content, {(owned.owner & 3) - 1, (owned.owner >> 2) - 1}};
    const glsl::Source source = program.source_of({{0, 0}, {p.x, p.y}}, decision);
    return program.kind_value(sampler_of(texels), plane_kind(plane_.kind), source);
  }

  /// Of all that may be drawn: over all blocks of the last level, and over all contents, which are equally likely.
  vec4 mean_value() const {
    double sum[4] = {0, 0, 0, 0};
    const auto add = [&](const vec4& v) {
      sum[0] += double{v.x};
      sum[1] += double{v.y};
      sum[2] += double{v.z};
      sum[3] += double{v.w};
    };
    const int last = planes_.level_count;
    const V2i size(planes_.size.x >> last, planes_.size.y >> last);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        for (uint32_t i = 0; i < entries_at(last, {x, y}).size(); ++i)
          for (int content = 0; content < planes_.content_count; ++content) add(share_at(last, {x, y}, i, content));
    const double count = double{1} * size.x * size.y * planes_.content_count;
    return {static_cast<float>(sum[0] / count), static_cast<float>(sum[1] / count), static_cast<float>(sum[2] / count),
            static_cast<float>(sum[3] / count)};
  }

  const EvaluatorPlanes& planes_;
  const Plane& plane_;
  const Lists& lists_;
  Image<vec4>& values_;
  Image<vec4> local_mean_;
};

void add_values(const EvaluatorPlanes& planes, const Lists& lists, Plane& plane) {
  Image<vec4> values(kListWidth, list_rows(lists.count * static_cast<uint64_t>(planes.content_count)), {0, 0, 0, 0});
  Values(planes, plane, lists, values).fill();
  plane.level_values = std::move(values);
}

}  // namespace

int level_count_of(V2i tile_size) {
  int count = 0;
  while ((tile_size.x | tile_size.y) % (2 << count) == 0) ++count;
  return count;
}

void add_levels(EvaluatorPlanes& planes, const Plane& plane) {
  const Lists lists = lists_of(planes);
  store_blocks(lists, planes);
  store_entries(lists, planes);
  if (&plane == &planes.base) add_values(planes, lists, planes.base);
  for (Plane& map : planes.maps)
    if (&map == &plane) add_values(planes, lists, map);
}

void add_levels(EvaluatorPlanes& planes) {
  const Lists lists = lists_of(planes);
  store_blocks(lists, planes);
  store_entries(lists, planes);
  add_values(planes, lists, planes.base);
  for (Plane& map : planes.maps) add_values(planes, lists, map);
}

LevelMemory level_memory(const EvaluatorPlanes& planes) {
  return {planes.base.level_values.size() * sizeof(vec4),
          planes.level_blocks.size() * sizeof(LevelBlock) + planes.level_entries.size() * sizeof(PatchTexel)};
}

}  // namespace texbake
