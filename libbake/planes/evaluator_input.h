// What the stages found of one tile, as the evaluator's planes are made from it.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/color/noise_space.h"
#include "libbake/color/palette.h"
#include "libbake/content/content.h"
#include "libbake/planes/evaluator_planes.h"
#include "libbake/segment/fragment.h"
#include "libbake/segment/patch.h"

namespace texbake {

/// A map to prepare. Views are borrowed during `prepare` only.
struct MapInput {
  std::string name;
  MapKind kind = MapKind::plain;
  std::vector<ImageView<const float>> channels;  ///< 1 to 4, all of the tile's size
};

/// The noises to prepare, 1 to 4. Views are borrowed during `prepare` only.
struct NoiseInput {
  std::vector<ImageView<const float>> masks;  ///< of the tile's size, multiples of 1/2048 that sum to 1
  /// One for each mask, half-exact: the values of the noise in reading order; width and height are powers of two.
  std::vector<ImageView<const V3f>> tiles;
  int row_step = 0;  ///< odd: texel (x, y) shows value (x + row_step · y) mod width · height
  NoiseSpace space = NoiseSpace::root;
};

/// What `prepare` reads. Only the base is required: without patches the tile repeats unchanged, without contents every
/// patch has the identity alone, without fragments or colors their `Show` is refused.
struct EvaluatorInput {
  ImageView<const V3f> base;  ///< linear Rec.709
  const PatchMap* patches = nullptr;
  const ContentTable* contents = nullptr;
  const FragmentMap* fragments = nullptr;
  const PrincipalVariation* colors = nullptr;
  std::vector<MapInput> maps;
  std::optional<NoiseInput> noise = {};  ///< added to the base, which is then the structure
  int soft_border_px = 0;                ///< over how many texels on either side of their border patches blend; 0: hard
  bool grain_apart = false;  ///< for deformed windows: levels of detail of the base hold the structure alone, and those
                             ///< of the noises keep the noises' means
};

/// Whether one of its maps is a height map, so that it can be drawn with relief.
inline bool has_heights(const EvaluatorInput& input) {
  return std::ranges::any_of(input.maps, [](const MapInput& map) { return map.kind == MapKind::height; });
}

/// The widest soft border of a tile.
inline int max_soft_border_px(V2i tile_size) { return std::min({tile_size.x / 8, tile_size.y / 8, 32}); }

}  // namespace texbake
