// Contents: what may fill a patch. One table, read by the search, the bundle and the evaluator alike.
// Based on: Vanhoey et al. 2013, §5.2 and §5.3; Guingo et al. 2017, §4 for rotation and scale.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libbake/base/torus.h"

namespace texbake {

/// Where a patch's texels come from. A texel at offset d from the patch's center c shows the base at
///   c + translation + (a·d.x − b·d.y, b·d.x + a·d.y) / 65536,   wrapped to the tile,
/// with a = 65536 cos θ / λ and b = −65536 sin θ / λ: the content appears turned by θ and λ times its size.
struct Content {
  V2i translation{0, 0};  ///< texels, shortest on the torus; the identity is (0, 0)
  int32_t a = 65536;      ///< 16.16 fixed point
  int32_t b = 0;
  int rotation_eighths = 0;  ///< θ in multiples of π/4, 0 … 7, from x towards y: clockwise as seen
  float scale = 1.0f;        ///< λ, 0.5 … 1
  float impact = 0.0f;       ///< I of eq. 2, in ΔE⁴ (ΔE² · ΔE²); 0 for the identity
  bool operator==(const Content&) const = default;
};

/// The content turned by `rotation_eighths` · π/4 and `scale` times its size, of impact 0.
Content make_content(V2i translation, int rotation_eighths, float scale);

/// Where a content takes the texel at offset `d` from the center of its patch from, for labels: the nearest texel,
/// relative to the center too, not wrapped. The same as turned_source in shaders/content.glsl.
inline V2i source_offset(const Content& content, V2i d) {
  const auto nearest = [](int64_t fixed) { return static_cast<int>((fixed + 32768) >> 16); };
  const auto a = int64_t{content.a}, b = int64_t{content.b};
  return content.translation + V2i(nearest(a * d.x - b * d.y), nearest(b * d.x + a * d.y));
}

/// P × N_t contents. Content 0 of every patch is the identity.
struct ContentTable {
  int patch_count = 0;
  int content_count = 0;          ///< N_t, the same for every patch
  std::vector<Content> contents;  ///< patch-major

  const Content& at(int patch, int content) const {
    return contents[static_cast<size_t>(patch) * static_cast<size_t>(content_count) + static_cast<size_t>(content)];
  }
  /// Those of one patch.
  std::span<const Content> of(int patch) const {
    return {contents.data() + static_cast<size_t>(patch) * static_cast<size_t>(content_count),
            static_cast<size_t>(content_count)};
  }
};

}  // namespace texbake
