// The shares of blocks of texels from those of texels: what add_levels and level_weights have in common.
#pragma once

#include <algorithm>

#include "libbake/base/parallel.h"
#include "libbake/eval/level_lists.h"

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
  LevelShares(const LevelLists& lists, int content_count, Image<glsl::vec4>& values, const TexelShare& texel_share)
      : lists_(lists), content_count_(content_count), values_(values), texel_share_(texel_share) {}

  void fill() {
    for (size_t i = 1; i < lists_.lists.size(); ++i)
      parallel_for(0, list(i).cover.size.y, [&](int y) {
        for (int x = 0; x < list(i).cover.size.x; ++x) fill_block(i, {x, y});
      });
    const glsl::vec4 mean = mean_share();
    for (int content = 0; content < content_count_; ++content) value(0, content) = mean;
  }

 private:
  const LevelList& list(size_t i) const { return lists_.lists[i]; }

  glsl::vec4& value(uint32_t entry, int content) const {
    return values_.data()[size_t{entry} * static_cast<size_t>(content_count_) + static_cast<size_t>(content)];
  }

  void fill_block(size_t i, V2i block) {
    uint32_t entry = list(i).first_at(block);
    for (const glsl::PatchTexel& owned : list(i).cover.at(block.x, block.y)) {
      for (int content = 0; content < content_count_; ++content)
        value(entry, content) = mean_of_finer(i, block, owned, content);
      ++entry;
    }
  }

  glsl::vec4 mean_of_finer(size_t i, V2i block, const glsl::PatchTexel& owned, int content) const {
    const LevelCover& finer = list(list(i).finer).cover;
    const V2i children(finer.size.x / list(i).cover.size.x, finer.size.y / list(i).cover.size.y);
    LevelSum sum;
    for (int y = block.y * children.y; y < (block.y + 1) * children.y; ++y)
      for (int x = block.x * children.x; x < (block.x + 1) * children.x; ++x) {
        const auto entries = finer.at(x, y);
        const auto found = std::find(entries.begin(), entries.end(), owned);
        if (found == entries.end()) continue;
        sum.add(share_at(list(i).finer, {x, y}, static_cast<uint32_t>(found - entries.begin()), content));
      }
    return sum.over(double{1} * children.x * children.y);
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
  Image<glsl::vec4>& values_;
  const TexelShare& texel_share_;
};

}  // namespace texbake
