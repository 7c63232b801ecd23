// The planes and tables that the evaluator reads, on the processor and on the GPU alike. The layout is specified in
// shaders/README.md.
#pragma once

#include <string>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/planes/noise_mean.h"
#include "libbake/planes/texture.h"
#include "libbake/reference/bindings.h"

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
  Image<glsl::vec4> level_values = {};  ///< of EvaluatorPlanes alone: levels.h
};

/// What the evaluator binds of level 0. Arrays are ready for upload: contents are of width N_t and height P, centers of
/// width P.
struct TilePlanes : glsl::NoiseUniforms {
  V2i size{0, 0};
  int patch_count = 1;
  int content_count = 1;  ///< N_t
  Image<glsl::PatchTexel> patch_plane;
  Image<glsl::ivec4> contents;  ///< (t.x + 65536 t.y, 65536 λ, a, b), t in 0 … size−1
  Image<glsl::ivec4> centers;   ///< (c.x, c.y, 0, 0)
  Plane base;                   ///< of kind `structure` with noise
  std::vector<Plane> maps;
  NoiseMean noise_mean;           ///< of the noises; 0 where the grain is apart
  Image<glsl::MaskTexel> masks;   ///< RGBA16UI, in 1/2048; one texel without noise
  Image<glsl::vec4> noise_tiles;  ///< one below the other, their levels of detail (noise_levels.h) to the right,
                                  ///< RGBA32F (or RGBA16F); one texel without noise

  int soft_border_px = 0;    ///< as in EvaluatorInput
  bool grain_apart = false;  ///< as in EvaluatorInput
  Image<float> noise_gain;   ///< what levels have the noise of each texel multiplied with; empty: 1

  Image<uint32_t> fragment_idx;  ///< empty without fragments
  Image<float> variation;        ///< empty without colors
  Image<V3f> dominant;           ///< dominant color of each texel, linear Rec.709; empty without colors

  const Plane* map(const std::string& name) const;
};

/// Which patches lie under the blocks of each level of detail: level_lists.h.
struct LevelTables : glsl::LevelUniforms {
  Image<glsl::ivec4> level_table;
  Image<glsl::LevelBlock> level_blocks;
  Image<glsl::PatchTexel> level_entries;
};

/// Everything that the evaluator binds. The levels of detail of the base and of all maps are always there: with soft
/// borders level 0 is drawn from them, and every view but a flat window of small pixels reads them.
struct EvaluatorPlanes : TilePlanes, LevelTables {
  Image<glsl::MaskTexel> level_weights;  ///< of the base's levels; one texel without noise

  EvaluatorPlanes() = default;  ///< of no tile
  /// Makes the levels, as levels.h says. Throws Error(infeasible) when they have 2^32 values or more.
  explicit EvaluatorPlanes(TilePlanes tile);
};

/// The textures of level 0, with those of `drawn`: the base or a map of `planes`.
template <class Visitor>
void for_each_texture(const TilePlanes& planes, const Plane& drawn, Visitor&& visit) {
  using S = glsl::Samplers;
  visit(Texture{"patch_plane"}, planes.patch_plane, &S::patch_plane);
  visit(Texture{"contents"}, planes.contents, &S::contents);
  visit(Texture{"centers"}, planes.centers, &S::centers);
  visit(Texture{"base", Precision::exact_half}, drawn.texels, &S::base);
  visit(Texture{"masks"}, planes.masks, &S::masks);
  visit(Texture{"noise_tiles", Precision::exact_half}, planes.noise_tiles, &S::noise_tiles);
}

/// All textures.
template <class Visitor>
void for_each_texture(const EvaluatorPlanes& planes, const Plane& drawn, Visitor&& visit) {
  using S = glsl::Samplers;
  for_each_texture(static_cast<const TilePlanes&>(planes), drawn, visit);
  visit(Texture{"level_table"}, planes.level_table, &S::level_table);
  visit(Texture{"level_blocks"}, planes.level_blocks, &S::level_blocks);
  visit(Texture{"level_entries"}, planes.level_entries, &S::level_entries);
  visit(Texture{"level_weights"}, planes.level_weights, &S::level_weights);
  visit(Texture{"base_levels", Precision::half}, drawn.level_values, &S::base_levels);
}

/// The largest tile side for which every product of the evaluator fits 32 bits.
inline constexpr int kMaxTileSide = 16384;

}  // namespace texbake
