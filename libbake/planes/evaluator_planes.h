// The planes and tables that the evaluator reads, on the processor and on the GPU alike. The layout is specified in
// shaders/README.md.
#pragma once

#include <string>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/planes/noise_mean.h"
#include "libbake/reference/glsl.h"

namespace texbake {

/// How the values of a map change with the content that shows them.
enum class MapKind {
  plain,           ///< taken as they are
  normal_opengl,   ///< vectors that turn with the content; +y points up in the picture
  normal_directx,  ///< the same; +y points down
  height,          ///< relief, which shrinks with a content that is shown smaller
  structure,       ///< the base, where noise is added to it
  relief_opengl,   ///< a height, and a vector that turns with the content; +y points up in the picture
  relief_directx,  ///< the same; +y points down
};

/// One picture of the tile, four floats to a texel; channels that it lacks are 0.
struct Plane {
  std::string name;
  MapKind kind = MapKind::plain;
  int channels = 3;
  Image<glsl::vec4> texels;
  Image<glsl::vec4> level_values = {};  ///< see libbake/planes/levels.h; empty until add_levels
};

/// Everything that the evaluator binds. Arrays are ready for upload: patch_plane RG16UI, contents RGBA32I of width
/// N_t and height P, centers RGBA32I of width P, base and maps RGBA32F (or RGBA16F, where the source is half).
struct EvaluatorPlanes {
  V2i size{0, 0};
  int patch_count = 1;
  int content_count = 1;  ///< N_t
  Image<glsl::PatchTexel> patch_plane;
  Image<glsl::ivec4> contents;  ///< (t.x + 65536 t.y, 65536 λ, a, b), t in 0 … size−1
  Image<glsl::ivec4> centers;   ///< (c.x, c.y, 0, 0)
  Plane base;                   ///< of kind `structure` with noise
  std::vector<Plane> maps;
  V2i noise_log2{0, 0};           ///< log2 of the width and height of the noises
  int noise_step = 0;             ///< row_step; 0 without noise
  int noise_root = 0;             ///< 1 where noise is added to the square root of light
  NoiseMean noise_mean;           ///< of the noises
  Image<glsl::MaskTexel> masks;   ///< RGBA16UI, in 1/2048; one texel without noise
  Image<glsl::vec4> noise_tiles;  ///< one below the other, their levels of detail (noise_levels.h) to the right,
                                  ///< RGBA32F (or RGBA16F); one texel without noise

  int level_count = 0;     ///< levels of detail beside level 0; 0 until add_levels
  int first_level = 1;     ///< 0 where borders of patches are soft
  int soft_border_px = 0;  ///< as in EvaluatorInput
  Image<glsl::ivec4> level_table;
  Image<glsl::LevelBlock> level_blocks;
  Image<glsl::PatchTexel> level_entries;
  Image<glsl::MaskTexel> level_weights;  ///< of the base's levels; one texel without noise, and until they are added
  Image<float> noise_gain;               ///< what levels have the noise of each texel multiplied with; empty: 1

  Image<uint32_t> fragment_idx;  ///< empty without fragments
  Image<float> variation;        ///< empty without colours
  Image<V3f> dominant;           ///< dominant colour of each texel, linear Rec.709; empty without colours

  const Plane* map(const std::string& name) const;
};

/// The largest tile side for which every product of the evaluator fits 32 bits.
inline constexpr int kMaxTileSide = 16384;

}  // namespace texbake
