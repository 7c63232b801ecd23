#include "libbake/planes/fragment_shares.h"

#include <algorithm>
#include <bit>

#include "libbake/base/parallel.h"
#include "libbake/planes/program_of.h"
#include "libbake/planes/scale_detail.h"

namespace texbake {
namespace {

using glsl::PatchTexel;

/// A fragment under a block.
struct Part {
  int16_t x = 0, y = 0;  ///< its center, from the corner of the block's repetition
  uint32_t source = 0;   ///< texel of the tile that shows there: x + 65536 y
  double share = 0;      ///< of the block, times the share of the coarser color that it takes
};

/// Fragments of every value in a row of blocks: entries × contents.
struct PartRow {
  std::vector<uint32_t> first;  ///< of each value, and the number of parts at the end
  std::vector<Part> parts;

  size_t values() const { return first.size() - 1; }
  std::span<const Part> at(size_t value) const {
    return {parts.data() + first[value], parts.data() + first[value + 1]};
  }
};
using PartRows = std::vector<PartRow>;

void add(std::vector<Part>& parts, size_t begin, const Part& part) {
  for (size_t i = begin; i < parts.size(); ++i)
    if (parts[i].x == part.x && parts[i].y == part.y && parts[i].source == part.source) {
      parts[i].share += part.share;
      return;
    }
  parts.push_back(part);
}

class Builder {
 public:
  Builder(const StackScale& scale, const TilePlanes& planes, const LevelLists& lists)
      : planes_(planes), lists_(lists), labels_(fragment_plane(scale)), program_(program_of(planes, 0)) {
    program_.fragment_plane = sampler_of(labels_);
    for (size_t k = 0; k < classes_of(scale); ++k) taking_.push_back(entry(scale.transfer->weights, k));
  }

  /// Of the blocks of list `i`, of list 0 those texels that have entries; those of finer lists are in `found`.
  PartRows parts_of(size_t i, const std::vector<PartRows>& found) const {
    PartRows rows(static_cast<size_t>(lists_.lists[i].cover.size.y));
    parallel_for(0, static_cast<int>(rows.size()), [&](int y) { rows[static_cast<size_t>(y)] = row_of(i, y, found); });
    return rows;
  }

 private:
  PartRow row_of(size_t i, int y, const std::vector<PartRows>& found) const {
    const LevelCover& cover = lists_.lists[i].cover;
    glsl::Program program = program_;
    PartRow row;
    for (int x = 0; x < cover.size.x; ++x) {
      const auto entries = cover.at(x, y);
      if (i == 0 && entries.size() == 1) continue;
      for (size_t k = 0; k < entries.size(); ++k)
        for (int content = 0; content < planes_.content_count; ++content) {
          row.first.push_back(static_cast<uint32_t>(row.parts.size()));
          if (i == 0)
            row.parts.push_back(texel_part(program, {x, y}, k, content));
          else
            add_block(program, i, {x, y}, entries[k], content, found, row.parts);
        }
    }
    row.first.push_back(static_cast<uint32_t>(row.parts.size()));
    return row;
  }

  /// What the finer blocks hold of a patch.
  void add_block(glsl::Program& program, size_t i, V2i block, const PatchTexel& owned, int content,
                 const std::vector<PartRows>& found, std::vector<Part>& parts) const {
    const LevelList& list = lists_.lists[i];
    const LevelCover& finer = lists_.lists[list.finer].cover;
    const V2i children(finer.size.x / list.cover.size.x, finer.size.y / list.cover.size.y);
    const double part_of_block = 1 / (double{1} * children.x * children.y);
    const size_t begin = parts.size();
    for (int y = block.y * children.y; y < (block.y + 1) * children.y; ++y)
      for (int x = block.x * children.x; x < (block.x + 1) * children.x; ++x) {
        const auto entries = finer.at(x, y);
        const auto at = std::find(entries.begin(), entries.end(), owned);
        if (at == entries.end()) continue;
        if (list.finer == 0) {
          Part part = texel_part(program, {x, y}, static_cast<size_t>(at - entries.begin()), content);
          part.share *= part_of_block;
          add(parts, begin, part);
          continue;
        }
        const size_t entry = finer.first_at(x, y) - finer.first_at(0, y) + static_cast<size_t>(at - entries.begin());
        const size_t value = entry * static_cast<size_t>(planes_.content_count) + static_cast<size_t>(content);
        for (Part part : found[list.finer][static_cast<size_t>(y)].at(value)) {
          part.share *= part_of_block;
          add(parts, begin, part);
        }
      }
  }

  /// Of entry `k` of a texel.
  Part texel_part(glsl::Program& program, V2i p, size_t k, int content) const {
    const LevelCover& texels = lists_.lists[0].cover;
    const PatchTexel& owned = texels.at(p.x, p.y)[k];
    const double weight = lists_.weights.empty() ? 1.0 : double{lists_.weights[texels.first_at(p.x, p.y) + k]};
    const glsl::Texel at{{0, 0}, {p.x, p.y}};
    const glsl::Decision decision = decision_of(owned, content);
    const glsl::Source source = program.source_of(at, decision);
    const glsl::ivec4 labels = texelFetch(program.fragment_plane, source.nearest, 0);
    const glsl::ivec2 center = program.fragment_center(at, decision, source, labels);
    const int x = program.wrap_any(source.nearest.x + labels.x, planes_.size.x);
    const int y = program.wrap_any(source.nearest.y + labels.y, planes_.size.y);
    return {static_cast<int16_t>(center.x), static_cast<int16_t>(center.y),
            static_cast<uint32_t>(x) | static_cast<uint32_t>(y) << 16,
            weight * double{taking_[static_cast<size_t>(labels.z)]}};
  }

  const TilePlanes& planes_;
  const LevelLists& lists_;
  Image<glsl::FragmentTexel> labels_;
  glsl::Program program_;
  std::vector<float> taking_;
};

glsl::ivec4 texel_of(const Part& part, uint64_t next) {
  const uint32_t center = static_cast<uint16_t>(part.x) | static_cast<uint32_t>(static_cast<uint16_t>(part.y)) << 16;
  return {std::bit_cast<int32_t>(center), std::bit_cast<int32_t>(static_cast<float>(part.share)),
          std::bit_cast<int32_t>(part.source), static_cast<int32_t>(next)};
}

/// Writes a row: the first part of each value from `first` on, the others from `other` on, whose number is `next`.
void store(const PartRow& row, glsl::ivec4* first, glsl::ivec4* other, uint64_t next) {
  for (size_t value = 0; value < row.values(); ++value) {
    const std::span<const Part> under = row.at(value);
    *first++ = texel_of(under[0], under.size() > 1 ? next : 0);
    for (size_t k = 1; k < under.size(); ++k) *other++ = texel_of(under[k], k + 1 < under.size() ? ++next : 0);
    if (under.size() > 1) ++next;
  }
}

}  // namespace

Image<glsl::ivec4> fragment_shares(const StackScale& scale, const TilePlanes& planes, const LevelLists& lists,
                                   int last_level) {
  const Builder builder(scale, planes, lists);
  std::vector<PartRows> found;
  for (size_t i = 0; i <= lists.list_of_level[static_cast<size_t>(last_level)]; ++i)
    found.push_back(builder.parts_of(i, found));

  // Entries of a list follow one another, from 1 on, and so do their rows.
  const auto contents = static_cast<uint64_t>(planes.content_count);
  std::vector<const PartRow*> rows;
  std::vector<uint64_t> first = {contents};
  std::vector<uint64_t> other = {static_cast<uint64_t>(list_rows(lists.count * contents)) * kListWidth};
  for (const PartRows& list : found)
    for (const PartRow& row : list) {
      rows.push_back(&row);
      first.push_back(first.back() + row.values());
      other.push_back(other.back() + row.parts.size() - row.values());
    }
  auto image = Image<glsl::ivec4>::unset(kListWidth, list_rows(other.back()));
  const auto fill = [&](uint64_t begin, uint64_t end) {
    std::fill(image.begin() + begin, image.begin() + end, glsl::ivec4{0, 0, 0, 0});
  };
  fill(0, first.front());
  fill(first.back(), other.front());
  fill(other.back(), image.size());
  parallel_for(0, static_cast<int>(rows.size()), [&](int y) {
    const auto at = static_cast<size_t>(y);
    store(*rows[at], image.begin() + first[at], image.begin() + other[at], other[at]);
  });
  return image;
}

}  // namespace texbake
