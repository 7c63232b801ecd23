// What a scale of a stack adds to the coarser color, and where its fragments are: of one tile.
// Based on: Vanhoey et al. 2013, §6 and §8.
#pragma once

#include "libbake/planes/stack_scale.h"

namespace texbake {

inline V2i size_of(const StackScale& scale) { return {scale.input.base.width(), scale.input.base.height()}; }

/// As of TilePlanes: 0 without patches.
inline int soft_border_of(const StackScale& scale) { return scale.input.patches ? scale.input.soft_border_px : 0; }

/// Color classes; 1 where there are none.
size_t classes_of(const StackScale& scale);

/// Of a list for each class, which may be empty: 1.
inline float entry(const std::vector<float>& list, size_t i) { return list.empty() ? 1.0f : list[i]; }

inline glsl::vec4 texel_of(const V3f& color) { return {color.x, color.y, color.z, 0}; }

/// Dominant colors of the classes, linear Rec.709, times the scale's strength; empty where there are none.
std::vector<V3f> dominant_colors(const StackScale& scale);

/// What the evaluator binds of the scale by itself, base and noise times its strength; with hard borders.
TilePlanes strong_planes(const StackScale& scale);

/// The base times the scale's strength, with the gains of its classes. Of a scale with noise, the structure.
Image<V3f> detail_of(const StackScale& scale);

/// The same with the mean of its noises: what the tile shows on the average over all places of the grain.
Image<V3f> mean_detail_of(const StackScale& scale);

/// The dominant color of each texel, which is what is left without variation; the base where there are no classes.
Image<V3f> dominant_of(const StackScale& scale);

/// Means over a tile, in double, of the dominant part and of the whole with the gains of its classes.
struct TileMeans {
  V3f dominant, whole;
};
TileMeans tile_means(const StackScale& scale, const Image<V3f>& detail);

/// Way to the center of the fragment, its class and the texel's, of each texel.
Image<glsl::FragmentTexel> fragment_plane(const StackScale& scale);

}  // namespace texbake
