#include "libbake/eval/fragment_shares.h"

#include <algorithm>
#include <bit>

#include "libbake/base/parallel.h"
#include "libbake/eval/program_of.h"
#include "libbake/eval/scale_detail.h"

namespace texbake {
namespace {

using glsl::PatchTexel;

/// A fragment under a block.
struct Part {
  int x = 0, y = 0;     ///< its centre, from the corner of the block's repetition
  uint32_t source = 0;  ///< texel of the tile that shows there: x + 65536 y
  double share = 0;     ///< of the block, times the share of the coarser colour that it takes
};

/// Fragments of every value of one list: entries × contents.
struct Parts {
  std::vector<uint32_t> first;  ///< and their number at the end
  std::vector<Part> parts;

  std::span<const Part> at(size_t value) const {
    return {parts.data() + first[value], parts.data() + first[value + 1]};
  }
};

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
  Builder(const StackScale& scale, const EvaluatorPlanes& planes, const LevelLists& lists)
      : planes_(planes), lists_(lists), labels_(fragment_plane(scale)), program_(program_of(planes, 0)) {
    program_.fragment_plane = sampler_of(labels_);
    for (size_t k = 0; k < classes_of(scale); ++k) taking_.push_back(entry(scale.transfer->weights, k));
  }

  /// Of the blocks of list `i`, of list 0 those texels that have entries; those of finer lists are in `found`.
  Parts parts_of(size_t i, const std::vector<Parts>& found) const {
    const LevelCover& cover = lists_.lists[i].cover;
    std::vector<Parts> rows(static_cast<size_t>(cover.size.y));
    parallel_for(0, cover.size.y, [&](int y) { rows[static_cast<size_t>(y)] = row_of(i, y, found); });
    Parts all;
    for (const Parts& row : rows) {
      const auto begin = static_cast<uint32_t>(all.parts.size());
      for (const uint32_t first : row.first) all.first.push_back(begin + first);
      all.parts.insert(all.parts.end(), row.parts.begin(), row.parts.end());
    }
    all.first.push_back(static_cast<uint32_t>(all.parts.size()));
    return all;
  }

 private:
  Parts row_of(size_t i, int y, const std::vector<Parts>& found) const {
    const LevelCover& cover = lists_.lists[i].cover;
    glsl::Program program = program_;
    Parts row;
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
    return row;
  }

  /// What the finer blocks hold of a patch.
  void add_block(glsl::Program& program, size_t i, V2i block, const PatchTexel& owned, int content,
                 const std::vector<Parts>& found, std::vector<Part>& parts) const {
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
        const size_t entry = finer.first_at(x, y) + static_cast<size_t>(at - entries.begin());
        const size_t value = entry * static_cast<size_t>(planes_.content_count) + static_cast<size_t>(content);
        for (Part part : found[list.finer].at(value)) {
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
    const glsl::Decision decision{owned.patch_idx, content, {(owned.owner & 3) - 1, (owned.owner >> 2) - 1}};
    const glsl::Source source = program.source_of(at, decision);
    const glsl::ivec4 labels = texelFetch(program.fragment_plane, source.nearest, 0);
    const glsl::ivec2 center = program.fragment_center(at, decision, source, labels);
    const int x = program.wrap_any(source.nearest.x + labels.x, planes_.size.x);
    const int y = program.wrap_any(source.nearest.y + labels.y, planes_.size.y);
    return {center.x, center.y, static_cast<uint32_t>(x) | static_cast<uint32_t>(y) << 16,
            weight * double{taking_[static_cast<size_t>(labels.z)]}};
  }

  const EvaluatorPlanes& planes_;
  const LevelLists& lists_;
  Image<glsl::FragmentTexel> labels_;
  glsl::Program program_;
  std::vector<float> taking_;
};

glsl::ivec4 texel_of(const Part& part, uint64_t next) {
  const uint32_t center = (static_cast<uint32_t>(part.x) & 0xffff) | static_cast<uint32_t>(part.y) << 16;
  return {std::bit_cast<int32_t>(center), std::bit_cast<int32_t>(static_cast<float>(part.share)),
          std::bit_cast<int32_t>(part.source), static_cast<int32_t>(next)};
}

}  // namespace

Image<glsl::ivec4> fragment_shares(const StackScale& scale, const EvaluatorPlanes& planes, const LevelLists& lists,
                                   int last_level) {
  const Builder builder(scale, planes, lists);
  const auto contents = static_cast<uint64_t>(planes.content_count);
  std::vector<glsl::ivec4> firsts(static_cast<size_t>(list_rows(lists.count * contents)) * kListWidth, {0, 0, 0, 0});
  std::vector<glsl::ivec4> others;
  std::vector<Parts> found;
  for (size_t i = 0; i <= lists.list_of_level[static_cast<size_t>(last_level)]; ++i) {
    found.push_back(builder.parts_of(i, found));
    const Parts& parts = found.back();
    // Entries of a list follow one another, from 1 on.
    glsl::ivec4* first = firsts.data() + (i == 0 ? 1 : lists.lists[i].first_at({0, 0})) * contents;
    for (size_t value = 0; value + 1 < parts.first.size(); ++value, ++first) {
      const std::span<const Part> under = parts.at(value);
      for (size_t k = 0; k < under.size(); ++k) {
        const bool is_last = k + 1 == under.size();
        const uint64_t next = is_last ? 0 : firsts.size() + others.size() + (k == 0 ? 0 : 1);
        if (k == 0)
          *first = texel_of(under[k], next);
        else
          others.push_back(texel_of(under[k], next));
      }
    }
  }
  Image<glsl::ivec4> image(kListWidth, list_rows(firsts.size() + others.size()), {0, 0, 0, 0});
  std::copy(others.begin(), others.end(), std::copy(firsts.begin(), firsts.end(), image.begin()));
  return image;
}

}  // namespace texbake
