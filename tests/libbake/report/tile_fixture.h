// A small tile with patches and contents for reports: grain of two sizes, patches in squares.
#pragma once

#include "libbake/base/gaussian.h"
#include "libbake/base/random.h"
#include "libbake/planes/prepare.h"

namespace texbake {

struct TileFixture {
  Image<V3f> base;
  PatchMap patches;
  ContentTable contents;

  EvaluatorInput input() const {
    EvaluatorInput input;
    input.base = base;
    input.patches = &patches;
    input.contents = &contents;
    return input;
  }
};

/// Linear colors around middle gray, in grain a texel and shapes an eighth of the side wide.
inline Image<V3f> grain_tile(int side, uint32_t seed = 3) {
  Random random(seed);
  Image<V3f> white(side, side), wide(side, side);
  for (V3f& c : white) c = V3f(random.uniform(), random.uniform(), random.uniform()) - V3f(0.5f);
  for (V3f& c : wide) c = V3f(random.uniform()) - V3f(0.5f);
  Image<V3f> tile = gaussian_blur(white, 1.0, Wrap::repeat);
  const Image<V3f> shapes = gaussian_blur(wide, side / 16.0, Wrap::repeat);
  for (size_t i = 0; i < tile.size(); ++i)
    tile.data()[i] = V3f(0.3f) + tile.data()[i] * 0.3f + shapes.data()[i] * (0.05f * static_cast<float>(side));
  for (V3f& c : tile)
    for (int i = 0; i < 3; ++i) c[i] = std::max(c[i], 0.01f);
  return tile;
}

/// 4 × 4 square patches, each with the identity and `content_count` − 1 random translations.
inline TileFixture tile_fixture(int side, int content_count, uint32_t seed = 3) {
  TileFixture fixture;
  fixture.base = grain_tile(side, seed);
  Image<uint32_t> idx(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) idx(x, y) = static_cast<uint32_t>(y * 4 / side * 4 + x * 4 / side);
  fixture.patches.partition = unwrap(std::move(idx));
  Random random(seed, 9);
  fixture.contents.patch_count = 16;
  fixture.contents.content_count = content_count;
  for (int i = 0; i < 16 * content_count; ++i) {
    Content content;
    if (i % content_count > 0) {
      content.translation.x = static_cast<int>(random.below(static_cast<uint32_t>(side))) - side / 2;
      content.translation.y = static_cast<int>(random.below(static_cast<uint32_t>(side))) - side / 2;
    }
    fixture.contents.contents.push_back(content);
  }
  return fixture;
}

}  // namespace texbake
