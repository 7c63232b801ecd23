// Small random scales with fragments and two color classes, for the tests of stacks.
#pragma once

#include <list>
#include <vector>

#include "libbake/base/half.h"
#include "libbake/planes/prepare_stack.h"
#include "tests/libbake/draw/small_tile.h"

namespace texbake {

/// A tile with what a stack reads of it.
struct ScaleTile {
  SmallTile tile;
  FragmentMap fragments;
  PrincipalVariation colors;

  EvaluatorInput input() const {
    EvaluatorInput input = tile.input();
    input.fragments = &fragments;
    input.colors = &colors;
    return input;
  }
};

/// Squares of `side` texels that lie across the borders of the tile.
inline FragmentMap square_fragments(V2i size, int side) {
  Image<uint32_t> idx(size.x, size.y);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      idx(x, y) = static_cast<uint32_t>(wrap(y + 2, size.y) / side * (size.x / side) + wrap(x + 1, size.x) / side);
  FragmentMap map{unwrap(std::move(idx)), {}};
  for (int i = 0; i < map.partition.count(); ++i) map.fragments.push_back({static_cast<uint32_t>(i % 2), V3f(0)});
  return map;
}

inline ScaleTile random_scale(V2i size, int contents, Contents kind, uint64_t seed) {
  ScaleTile scale{random_tile(size, contents, kind, seed), square_fragments(size, 4), {}};
  scale.colors.palette.classes = {{{20, 5, -3}, {0.6f, 0, 0.8f}}, {{70, 10, 12.5f}, {1, 0, 0}}};
  scale.colors.index = Image<uint8_t>(size.x, size.y);
  scale.colors.variation = Image<float>(size.x, size.y);
  Random random(seed, 9);
  for (uint8_t& k : scale.colors.index) k = static_cast<uint8_t>(random.below(2));
  return scale;
}

/// Owns scales and transfers, coarse to fine.
struct SmallStack {
  std::list<ScaleTile> tiles;
  std::list<ScaleTransfer> transfers;

  SmallStack& add(ScaleTile tile, const ScaleTransfer& transfer = {}) {
    tiles.push_back(std::move(tile));
    transfers.push_back(transfer);
    return *this;
  }
  std::vector<StackScale> scales() const {
    std::vector<StackScale> scales;
    auto transfer = transfers.begin();
    for (const ScaleTile& tile : tiles) {
      scales.push_back({tile.input(), scales.empty() ? nullptr : &*transfer});
      ++transfer;
    }
    return scales;
  }
  StackPlanes planes() const { return prepare_stack(scales()); }
};

inline SmallStack two_scales(const ScaleTransfer& transfer, Contents kind = Contents::moved, uint64_t seed = 1) {
  SmallStack stack;
  stack.add(random_scale({32, 16}, 3, kind, seed));
  stack.add(random_scale({16, 32}, 3, kind, seed + 50), transfer);
  return stack;
}

}  // namespace texbake
