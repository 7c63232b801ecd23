// The obvious way to compute what libbake/content computes fast: eq. 2 and 3 term by term. The oracle of the tests.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "libbake/base/random.h"
#include "libbake/content/content.h"
#include "libbake/content/content_search.h"
#include "libbake/segment/partition.h"

namespace texbake::twin {

/// Rows of digits, separated by blanks: "001 011" is 3 × 2 texels.
template <class T>
Image<T> digits(const std::string& text) {
  const size_t width = std::min(text.find(' '), text.size());
  Image<T> image(static_cast<int>(width), static_cast<int>((text.size() + 1) / (width + 1)));
  T* out = image.data();
  for (const char c : text)
    if (c != ' ') *out++ = static_cast<T>(c - '0');
  return image;
}

/// dil(∂P): texels at most two steps of a king from a texel of P that has a 4-neighbor outside P.
inline std::vector<V2i> dilated_border(ImageView<const uint32_t> patch_idx, uint32_t patch) {
  const V2i size(patch_idx.width(), patch_idx.height());
  const auto inside = [&](V2i p) { return patch_idx(wrap(p.x, size.x), wrap(p.y, size.y)) == patch; };
  std::vector<V2i> dilated;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      bool near = false;
      for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx) {
          const V2i q(x + dx, y + dy);
          near |= inside(q) &&
                  !(inside(q + V2i(1, 0)) && inside(q + V2i(-1, 0)) && inside(q + V2i(0, 1)) && inside(q + V2i(0, -1)));
        }
      if (near) dilated.emplace_back(x, y);
    }
  return dilated;
}

/// Σ E(p, p+t) over `texels`, eq. 3 with 49 terms for each.
inline uint64_t error_sum(ImageView<const uint8_t> classes, const ClassDistances& distances,
                          const std::vector<V2i>& texels, V2i t) {
  const V2i size(classes.width(), classes.height());
  const auto class_at = [&](V2i p) { return classes(wrap(p.x, size.x), wrap(p.y, size.y)); };
  const auto delta = [&](V2i p) -> uint64_t { return distances.at(class_at(p), class_at(p + t)); };
  uint64_t sum = 0;
  for (const V2i& p : texels) {
    uint64_t around = 0;
    for (int dy = -3; dy <= 3; ++dy)
      for (int dx = -3; dx <= 3; ++dx) around += delta(p + V2i(dx, dy));
    sum += around * delta(p);
  }
  return sum;
}

/// The same where texel p shows the class at `source_of(p)`.
template <class SourceOf>
uint64_t error_sum_of(ImageView<const uint8_t> classes, const ClassDistances& distances, const std::vector<V2i>& texels,
                      const SourceOf& source_of) {
  const V2i size(classes.width(), classes.height());
  const auto delta = [&](V2i p) -> uint64_t {
    const V2i own = wrap(p, size), source = wrap(source_of(own), size);
    return distances.at(classes(own.x, own.y), classes(source.x, source.y));
  };
  uint64_t sum = 0;
  for (const V2i& p : texels) {
    uint64_t around = 0;
    for (int dy = -3; dy <= 3; ++dy)
      for (int dx = -3; dx <= 3; ++dx) around += delta(p + V2i(dx, dy));
    sum += around * delta(p);
  }
  return sum;
}

/// All translations in order of (error, y, x), and from them, best first, those far enough from all before.
inline Candidates search(ImageView<const uint8_t> classes, const ClassDistances& distances,
                         const std::vector<V2i>& border, const SearchRequest& request) {
  const V2i size(classes.width(), classes.height());
  Candidates all;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) all.push_back({{x, y}, error_sum(classes, distances, border, {x, y})});
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.error_sum < b.error_sum; });

  const auto circular = [](int d, int n) { return std::min(wrap(d, n), wrap(-d, n)); };
  const auto is_far = [&](V2i a, V2i b) {
    return std::max(circular(a.x - b.x, size.x), circular(a.y - b.y, size.y)) >= request.separation_px;
  };
  Candidates taken;
  for (const Candidate& candidate : all) {
    bool allowed = is_far(candidate.translation, {0, 0}) && taken.size() < static_cast<size_t>(request.count);
    for (const Candidate& other : taken) allowed &= is_far(candidate.translation, other.translation);
    if (allowed) taken.push_back(candidate);
  }
  return taken;
}

/// A partition of which only idx is known; with translations alone the centers do not matter.
inline Partition partition(Image<uint32_t> idx, int count) {
  Partition patches;
  patches.idx = std::move(idx);
  patches.centers.assign(static_cast<size_t>(count), V2i(0, 0));
  return patches;
}

/// Contents that are only moved, as many for each patch.
inline ContentTable table(const std::vector<std::vector<V2i>>& translations) {
  ContentTable table{static_cast<int>(translations.size()), static_cast<int>(translations[0].size()), {}};
  for (const auto& of_patch : translations)
    for (const V2i& t : of_patch) table.contents.push_back(make_content(t, 0, 1.0f));
  return table;
}

/// The same ones for every patch.
inline ContentTable table(int patch_count, const std::vector<V2i>& translations) {
  return table(std::vector<std::vector<V2i>>(static_cast<size_t>(patch_count), translations));
}

/// A tile of `class_count` classes in blobs a few texels wide.
inline Image<uint8_t> random_classes(int width, int height, int class_count, uint64_t seed) {
  Random random(seed);
  Image<uint8_t> classes(width, height);
  for (uint8_t& c : classes) c = static_cast<uint8_t>(random.below(static_cast<uint32_t>(class_count)));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (random.below(3) != 0) classes(x, y) = classes(wrap(x - 1, width), wrap(y - (x & 1), height));
  return classes;
}

/// Mean colors of classes, far from each other and close.
inline std::vector<V3f> random_colors(int class_count, uint64_t seed) {
  Random random(seed, 1);
  std::vector<V3f> colors;
  for (int i = 0; i < class_count; ++i)
    colors.emplace_back(100 * random.uniform(), 100 * random.uniform() - 50, 60 * random.uniform() - 30);
  return colors;
}

/// Patches: texels of the nearest of `count` random seeds on the torus, with ragged borders.
inline Image<uint32_t> random_patches(int width, int height, int count, uint64_t seed) {
  Random random(seed, 2);
  std::vector<V2i> seeds;
  for (int i = 0; i < count; ++i)
    seeds.emplace_back(static_cast<int>(random.below(static_cast<uint32_t>(width))),
                       static_cast<int>(random.below(static_cast<uint32_t>(height))));
  Image<uint32_t> patches(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      int least = width * width + height * height;
      for (int i = 0; i < count; ++i) {
        const V2i d = shortest(seeds[static_cast<size_t>(i)] - V2i(x, y), {width, height});
        const int distance = d.x * d.x + d.y * d.y + static_cast<int>(random.below(4));
        if (distance >= least) continue;
        least = distance;
        patches(x, y) = static_cast<uint32_t>(i);
      }
    }
  return patches;
}

}  // namespace texbake::twin
