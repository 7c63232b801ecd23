// The shares of blocks of texels from those of texels: what level_values and level_weights have in common.
#pragma once

#include <algorithm>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/planes/level_lists.h"

namespace texbake {

/// A sum of values.
struct LevelSum {
  double x = 0, y = 0, z = 0, w = 0;

  void add(const glsl::vec4& v) {
    x += double{v.x};
    y += double{v.y};
    z += double{v.z};
    w += double{v.w};
  }
  glsl::vec4 over(double count) const {
    return {static_cast<float>(x / count), static_cast<float>(y / count), static_cast<float>(z / count),
            static_cast<float>(w / count)};
  }
};

/// Fills `values`: the share of entry e with content c is number e · content_count + c, in row order. A share is the
/// mean, in double and rounded once to float, of the same patch's shares in the finer blocks; of a texel,
/// `texel_share(p, k, content)`, k counting the texel's patches. Entry 0 is the mean of all that may be drawn.
template <class TexelShare>
class LevelShares {
 public:
  LevelShares(const LevelLists& lists, int content_count, ImageView<glsl::vec4> values, const TexelShare& texel_share)
      : lists_(lists), content_count_(content_count), values_(values), texel_share_(texel_share) {}

  void fill() {
    for (size_t i = 1; i < lists_.lists.size(); ++i)
      parallel_for(0, list(i).cover.size.y, [&](int y) { fill_row(i, y); });
    const glsl::vec4 mean = mean_share();
    for (int content = 0; content < content_count_; ++content) value(0, content) = mean;
  }

 private:
  /// Where a finer block has a patch: its k-th entry.
  struct Place {
    V2i block;
    uint32_t k;
  };

  const LevelList& list(size_t i) const { return lists_.lists[i]; }

  glsl::vec4& value(uint32_t entry, int content) const {
    return values_.data()[size_t{entry} * static_cast<size_t>(content_count_) + static_cast<size_t>(content)];
  }

  /// Content by content: what is read then lies side by side.
  void fill_row(size_t i, int y) {
    const LevelCover& blocks = list(i).cover;
    const LevelCover& finer = list(list(i).finer).cover;
    const V2i children(finer.size.x / blocks.size.x, finer.size.y / blocks.size.y);
    const double count = double{1} * children.x * children.y;
    std::vector<Place> under;
    std::vector<size_t> ends;  // in `under`, of each entry
    for (int x = 0; x < blocks.size.x; ++x)
      for (const glsl::PatchTexel& owned : blocks.at(x, y)) {
        add_places(finer, {x * children.x, y * children.y}, children, owned, under);
        ends.push_back(under.size());
      }
    const uint32_t first = list(i).first_at({0, y});
    for (int content = 0; content < content_count_; ++content)
      for (size_t k = 0, at = 0; k < ends.size(); ++k) {
        LevelSum sum;
        for (; at < ends[k]; ++at) sum.add(share_at(list(i).finer, under[at].block, under[at].k, content));
        value(first + static_cast<uint32_t>(k), content) = sum.over(count);
      }
  }

  /// Those of one patch among `children` blocks from `corner` on.
  static void add_places(const LevelCover& finer, V2i corner, V2i children, const glsl::PatchTexel& owned,
                         std::vector<Place>& places) {
    for (int y = corner.y; y < corner.y + children.y; ++y)
      for (int x = corner.x; x < corner.x + children.x; ++x) {
        const auto entries = finer.at(x, y);
        const auto found = std::find(entries.begin(), entries.end(), owned);
        if (found != entries.end()) places.push_back({{x, y}, static_cast<uint32_t>(found - entries.begin())});
      }
  }

  glsl::vec4 share_at(size_t i, V2i block, uint32_t k, int content) const {
    return i > 0 ? value(list(i).first_at(block) + k, content) : texel_share_(block, k, content);
  }

  /// Over all blocks of the last list, and over all contents, which are equally likely.
  glsl::vec4 mean_share() const {
    const size_t last = lists_.lists.size() - 1;
    const LevelCover& cover = list(last).cover;
    LevelSum sum;
    for (int y = 0; y < cover.size.y; ++y)
      for (int x = 0; x < cover.size.x; ++x)
        for (uint32_t k = 0; k < cover.at(x, y).size(); ++k)
          for (int content = 0; content < content_count_; ++content) sum.add(share_at(last, {x, y}, k, content));
    return sum.over(double{1} * cover.size.x * cover.size.y * content_count_);
  }

  const LevelLists& lists_;
  int content_count_;
  ImageView<glsl::vec4> values_;
  const TexelShare& texel_share_;
};

}  // namespace texbake
