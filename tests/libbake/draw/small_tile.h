// Small random tiles with patches across their borders and corners, for the tests of the evaluator.
#pragma once

#include <cmath>
#include <vector>

#include "libbake/base/error.h"
#include "libbake/base/half.h"
#include "libbake/base/random.h"
#include "libbake/content/content.h"
#include "libbake/planes/prepare.h"
#include "libbake/segment/patch.h"

namespace texbake {

/// A tile with everything the evaluator needs.
struct SmallTile {
  Image<V3f> base;
  PatchMap patches;
  ContentTable contents;
  std::vector<Image<float>> masks = {};  ///< none: no noise
  std::vector<Image<V3f>> noises = {};
  int noise_step = 0;
  NoiseSpace noise_space = NoiseSpace::root;
  int soft_border_px = 0;

  V2i size() const { return {base.width(), base.height()}; }
  EvaluatorInput input() const {
    EvaluatorInput input;
    input.base = base;
    input.patches = &patches;
    input.contents = &contents;
    input.soft_border_px = soft_border_px;
    if (!masks.empty())
      input.noise = NoiseInput{{masks.begin(), masks.end()}, {noises.begin(), noises.end()}, noise_step, noise_space};
    return input;
  }
  EvaluatorPlanes planes() const { return prepare(input()); }
};

inline Image<V3f> random_base(V2i size, uint64_t seed) {
  Random random(seed, 1);
  Image<V3f> base(size.x, size.y);
  for (V3f& c : base) c = half_exact(V3f(random.uniform(), random.uniform(), random.uniform()) * 4.0f);
  return base;
}

/// Cells of 4 × 4 jittered points on the torus; point 0 is texel (0, 0), so that its patch lies on all four corners.
inline Image<uint32_t> random_cells(V2i size, uint64_t seed) {
  Random random(seed, 2);
  const auto side = [](int n) { return static_cast<uint32_t>(n); };
  std::vector<V2i> points;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const V2i jitter(static_cast<int>(random.below(side(size.x / 8 + 1))),
                       static_cast<int>(random.below(side(size.y / 8 + 1))));
      points.push_back(i + j == 0 ? V2i(0) : V2i(i * size.x / 4, j * size.y / 4) + jitter);
    }
  Image<uint32_t> idx(size.x, size.y);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const auto distance = [&](V2i point) { return shortest(V2i(x, y) - point, size).length2(); };
      for (uint32_t i = 1; i < points.size(); ++i)
        if (distance(points[i]) < distance(points[idx(x, y)])) idx(x, y) = i;
    }
  return idx;
}

/// The first of a hundred seeds whose cells are patches (connected, under half the tile).
inline PatchMap random_patches(V2i size, uint64_t seed) {
  for (uint64_t last = seed + 99; seed < last; ++seed) try {
      return {unwrap(random_cells(size, seed))};
    } catch (const Error&) {
    }
  return {unwrap(random_cells(size, seed))};
}

/// The content that is turned by `eighths` · π/4 and `scale` times its size (design §11).
inline Content turned_content(V2i translation, int eighths, float scale) {
  const double angle = eighths * 0.78539816339744831;
  Content content;
  content.translation = translation;
  content.rotation_eighths = eighths;
  content.scale = scale;
  content.a = static_cast<int32_t>(std::lround(65536 * std::cos(angle) / scale));
  content.b = static_cast<int32_t>(std::lround(-65536 * std::sin(angle) / scale));
  return content;
}

enum class Contents { moved, turned };

/// `count` contents for each patch: the identity, then random ones.
inline ContentTable random_contents(const PatchMap& patches, V2i size, int count, Contents kind, uint64_t seed) {
  Random random(seed, 3);
  ContentTable table{patches.partition.count(), count, {}};
  for (int patch = 0; patch < table.patch_count; ++patch)
    for (int i = 0; i < count; ++i) {
      const V2i t(static_cast<int>(random.below(static_cast<uint32_t>(size.x))) - size.x / 2,
                  static_cast<int>(random.below(static_cast<uint32_t>(size.y))) - size.y / 2);
      const int eighths = kind == Contents::turned ? static_cast<int>(random.below(8)) : 0;
      const float scale = kind == Contents::turned ? 0.5f + 0.125f * static_cast<float>(random.below(5)) : 1.0f;
      table.contents.push_back(i == 0 ? Content{} : turned_content(t, eighths, scale));
    }
  return table;
}

/// `count` masks: multiples of 1/2048 that sum to 1; at a third of the texels one of them is 1.
inline std::vector<Image<float>> random_masks(V2i size, int count, uint64_t seed) {
  Random random(seed, 4);
  std::vector<Image<float>> masks;
  for (int k = 0; k < count; ++k) masks.emplace_back(size.x, size.y);
  for (size_t i = 0; i < masks[0].size(); ++i) {
    uint32_t left = 2048;
    const bool is_binary = random.below(3) == 0;
    for (int k = 0; k < count; ++k) {
      const uint32_t drawn = is_binary ? random.below(2) * left : random.below(left + 1);
      const uint32_t steps = k + 1 == count ? left : drawn;
      masks[static_cast<size_t>(k)].data()[i] = static_cast<float>(steps) / 2048.0f;
      left -= steps;
    }
  }
  return masks;
}

/// Signed, half-exact.
inline std::vector<Image<V3f>> random_noises(int side, int count, uint64_t seed) {
  std::vector<Image<V3f>> noises;
  for (int k = 0; k < count; ++k) {
    noises.push_back(random_base({side, side}, seed + 100 + static_cast<uint64_t>(k)));
    for (V3f& color : noises.back()) color = half_exact(color * 0.25f - V3f(0.5f));
  }
  return noises;
}

inline void add_noise(SmallTile& tile, int count, int side, uint64_t seed, NoiseSpace space = NoiseSpace::root) {
  tile.noise_space = space;
  tile.masks = random_masks(tile.size(), count, seed);
  tile.noises = random_noises(side, count, seed);
  tile.noise_step = side * side * 5 / 8 + 1;
}

inline SmallTile random_tile(V2i size, int count, Contents kind, uint64_t seed) {
  SmallTile tile{random_base(size, seed), random_patches(size, seed), {}};
  tile.contents = random_contents(tile.patches, size, count, kind, seed);
  return tile;
}

}  // namespace texbake
