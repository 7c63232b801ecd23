#include "libbake/eval/levels.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/eval/level_lists.h"
#include "libbake/eval/local_mean.h"
#include "libbake/eval/program_of.h"

namespace texbake {
namespace {

using glsl::PatchTexel;
using glsl::vec4;

/// A sum of values.
struct Sum {
  double x = 0, y = 0, z = 0, w = 0;

  void add(const vec4& v) {
    x += double{v.x};
    y += double{v.y};
    z += double{v.z};
    w += double{v.w};
  }
  vec4 over(double count) const {
    return {static_cast<float>(x / count), static_cast<float>(y / count), static_cast<float>(z / count),
            static_cast<float>(w / count)};
  }
};

constexpr float kWhole = 2048;  ///< what the weights of noises sum to

std::vector<vec4> means_of_noises(const EvaluatorPlanes& planes) {
  std::vector<vec4> means;
  const int size = planes.noise_size;
  for (int k = 0; size > 0 && k < planes.noise_tiles.height() / size; ++k) {
    Sum sum;
    for (int y = k * size; y < (k + 1) * size; ++y)
      for (int x = 0; x < size; ++x) sum.add(planes.noise_tiles(x, y));
    means.push_back(sum.over(double{1} * size * size));
  }
  return means;
}

/// Fills the values of all entries, finer lists first.
class Values {
 public:
  Values(const EvaluatorPlanes& planes, const Plane& plane, const LevelLists& lists, Image<vec4>& values)
      : planes_(planes), plane_(plane), lists_(lists), values_(values) {
    if (planes.soft_border_px > 0) local_mean_ = local_mean(plane.texels, planes.soft_border_px);
    if (plane.kind == MapKind::structure) noise_means_ = means_of_noises(planes);
  }

  void fill() {
    for (size_t i = planes_.soft_border_px > 0 ? 0 : 1; i < lists_.lists.size(); ++i)
      parallel_for(0, list(i).cover.size.y, [&](int y) {
        for (int x = 0; x < list(i).cover.size.x; ++x) i == 0 ? fill_texel({x, y}) : fill_block(i, {x, y});
      });
    const vec4 mean = mean_value();
    for (int content = 0; content < planes_.content_count; ++content) value(0, content) = mean;
  }

 private:
  const LevelList& list(size_t i) const { return lists_.lists[i]; }

  vec4& value(uint32_t entry, int content) const {
    return values_.data()[size_t{entry} * static_cast<size_t>(planes_.content_count) + static_cast<size_t>(content)];
  }

  /// A texel of several patches, of weights w. A plain blend of independent contents would keep Σ w² of their variance,
  /// and all of it where they are the same, as when all are the identity: of N_t² pairs of draws, one. What differs
  /// from the local mean is enlarged so that the variance is kept on the average.
  void fill_texel(V2i p) {
    const uint32_t first = list(0).first_at(p);
    if (first == 0) return;
    const auto entries = list(0).cover.at(p.x, p.y);
    const float* const weights = lists_.weights.data() + list(0).cover.first_at(p.x, p.y);
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

  void fill_block(size_t i, V2i block) {
    uint32_t entry = list(i).first_at(block);
    for (const PatchTexel& owned : list(i).cover.at(block.x, block.y)) {
      for (int content = 0; content < planes_.content_count; ++content)
        value(entry, content) = share(i, block, owned, content);
      ++entry;
    }
  }

  /// The mean of what the finer blocks hold of it.
  vec4 share(size_t i, V2i block, const PatchTexel& owned, int content) const {
    const LevelCover& finer = list(list(i).finer).cover;
    const V2i children(finer.size.x / list(i).cover.size.x, finer.size.y / list(i).cover.size.y);
    Sum sum;
    for (int y = block.y * children.y; y < (block.y + 1) * children.y; ++y)
      for (int x = block.x * children.x; x < (block.x + 1) * children.x; ++x) {
        const auto entries = finer.at(x, y);
        const auto found = std::find(entries.begin(), entries.end(), owned);
        if (found == entries.end()) continue;
        sum.add(share_at(list(i).finer, {x, y}, static_cast<uint32_t>(found - entries.begin()), content));
      }
    return sum.over(double{1} * children.x * children.y);
  }

  /// Entry `k` of a block; of a texel, with the mean of the noises there.
  vec4 share_at(size_t i, V2i block, uint32_t k, int content) const {
    const uint32_t first = list(i).first_at(block);
    if (i > 0) return value(first + k, content);
    const PatchTexel& owned = list(0).cover.at(block.x, block.y)[k];
    if (first == 0) return shown(plane_.texels, block, owned, content) + noise_mean(block, owned, content);
    const float weight = lists_.weights[list(0).cover.first_at(block.x, block.y) + k];
    return value(first + k, content) + noise_mean(block, owned, content) * weight;
  }

  vec4 noise_mean(V2i p, const PatchTexel& owned, int content) const {
    vec4 sum(0, 0, 0, 0);
    if (noise_means_.empty()) return sum;
    glsl::Program program = program_of(planes_, 0);
    const glsl::uvec4 weights = program.source_weights(source_at(program, p, owned, content));
    const uint32_t of[4] = {weights.x, weights.y, weights.z, weights.w};
    for (size_t k = 0; k < noise_means_.size(); ++k) sum = sum + noise_means_[k] * (static_cast<float>(of[k]) / kWhole);
    return sum;
  }

  static glsl::Source source_at(glsl::Program& program, V2i p, const PatchTexel& owned, int content) {
    const glsl::Decision decision{owned.patch_idx, content, {(owned.owner & 3) - 1, (owned.owner >> 2) - 1}};
    return program.source_of({{0, 0}, {p.x, p.y}}, decision);
  }

  /// What a patch's content shows at a texel, of the plane or of what stands in its place.
  vec4 shown(const Image<vec4>& texels, V2i p, const PatchTexel& owned, int content) const {
    glsl::Program program = program_of(planes_, 0);
    const glsl::Source source = source_at(program, p, owned, content);
    return program.kind_value(sampler_of(texels), plane_kind(plane_.kind), source);
  }

  /// Of all that may be drawn: over all blocks of the last list, and over all contents, which are equally likely.
  vec4 mean_value() const {
    const size_t last = lists_.lists.size() - 1;
    const LevelCover& cover = list(last).cover;
    Sum sum;
    for (int y = 0; y < cover.size.y; ++y)
      for (int x = 0; x < cover.size.x; ++x)
        for (uint32_t i = 0; i < cover.at(x, y).size(); ++i)
          for (int content = 0; content < planes_.content_count; ++content) sum.add(share_at(last, {x, y}, i, content));
    return sum.over(double{1} * cover.size.x * cover.size.y * planes_.content_count);
  }

  const EvaluatorPlanes& planes_;
  const Plane& plane_;
  const LevelLists& lists_;
  Image<vec4>& values_;
  Image<vec4> local_mean_;
  std::vector<vec4> noise_means_;  ///< of the structure's plane; else empty
};

void add_values(const EvaluatorPlanes& planes, const LevelLists& lists, Plane& plane) {
  Image<vec4> values(kListWidth, list_rows(lists.count * static_cast<uint64_t>(planes.content_count)), {0, 0, 0, 0});
  Values(planes, plane, lists, values).fill();
  plane.level_values = std::move(values);
}

}  // namespace

void add_levels(EvaluatorPlanes& planes, const Plane& plane) {
  const LevelLists lists = level_lists(planes);
  store_lists(lists, planes);
  if (&plane == &planes.base) add_values(planes, lists, planes.base);
  for (Plane& map : planes.maps)
    if (&map == &plane) add_values(planes, lists, map);
}

void add_levels(EvaluatorPlanes& planes) {
  const LevelLists lists = level_lists(planes);
  store_lists(lists, planes);
  add_values(planes, lists, planes.base);
  for (Plane& map : planes.maps) add_values(planes, lists, map);
}

LevelMemory level_memory(const EvaluatorPlanes& planes) {
  return {planes.base.level_values.size() * sizeof(vec4),
          planes.level_blocks.size() * sizeof(glsl::LevelBlock) + planes.level_entries.size() * sizeof(PatchTexel)};
}

}  // namespace texbake
