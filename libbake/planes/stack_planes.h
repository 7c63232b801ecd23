// The planes of several scales together, as shaders/scales.glsl reads them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libbake/planes/evaluator_planes.h"
#include "libbake/planes/transfer.h"
#include "libbake/reference/program.h"

namespace texbake {

/// Everything that a stack binds: shaders/README.md, "Several scales". Noises are those of the finest scale.
struct StackPlanes : glsl::NoiseUniforms {
  std::vector<V2i> sizes;                ///< of the tiles, coarse to fine
  std::vector<ScaleTransfer> transfers;  ///< of each scale; the coarsest's means nothing
  std::vector<int> content_counts, patch_counts;
  Image<glsl::PatchTexel> patch_plane;
  Image<glsl::ivec4> contents;
  Image<glsl::vec4> base;
  Image<glsl::FragmentTexel> fragment_plane;
  Image<glsl::vec4> local_mean;
  Image<glsl::MaskTexel> masks;
  Image<glsl::vec4> noise_tiles;
  Image<glsl::ivec4> scale_table;  ///< with the centers of patches, then the tables of levels
  Image<glsl::vec4> color_table;
  /// This and what follows: stack_levels.h.
  Image<glsl::LevelBlock> level_blocks;
  Image<glsl::PatchTexel> level_entries;
  Image<glsl::vec4> base_levels;
  Image<glsl::MaskTexel> level_weights;  ///< of the finest scale; one texel without noise
  Image<glsl::ivec4> fragment_shares;

  int scale_count() const { return static_cast<int>(sizes.size()); }
  int finest() const { return scale_count() - 1; }
  /// Levels of detail of a scale beside level 0.
  int level_count(int scale) const { return scale_entry(2, scale).w; }
  /// As in shaders/scales.glsl.
  const glsl::ivec4& scale_entry(int column, int scale) const { return scale_table(column, scale + 1); }
  glsl::ivec4& scale_entry(int column, int scale) { return scale_table(column, scale + 1); }
  /// Texels of the finest scale along one texel of `scale`.
  int64_t texels_in(int scale) const;
};

template <class Visitor>
void for_each_texture(const StackPlanes& planes, Visitor&& visit) {
  using S = glsl::Samplers;
  visit(Texture{"patch_plane"}, planes.patch_plane, &S::patch_plane);
  visit(Texture{"contents"}, planes.contents, &S::contents);
  visit(Texture{"base", Precision::exact_half}, planes.base, &S::base);
  visit(Texture{"masks"}, planes.masks, &S::masks);
  visit(Texture{"noise_tiles", Precision::exact_half}, planes.noise_tiles, &S::noise_tiles);
  visit(Texture{"fragment_plane"}, planes.fragment_plane, &S::fragment_plane);
  visit(Texture{"local_mean"}, planes.local_mean, &S::local_mean);
  visit(Texture{"scale_table"}, planes.scale_table, &S::scale_table);
  visit(Texture{"color_table"}, planes.color_table, &S::color_table);
  visit(Texture{"level_blocks"}, planes.level_blocks, &S::level_blocks);
  visit(Texture{"level_entries"}, planes.level_entries, &S::level_entries);
  visit(Texture{"base_levels", Precision::half}, planes.base_levels, &S::base_levels);
  visit(Texture{"level_weights"}, planes.level_weights, &S::level_weights);
  visit(Texture{"fragment_shares"}, planes.fragment_shares, &S::fragment_shares);
}

/// What `scale` replaces from now on, of planes that were prepared with its local mean.
void set_detail_mean(StackPlanes& planes, int scale, DetailMean mean);

/// The reference text, bound; borrows `planes`. `reference` is a repetition of the finest tile near what is drawn: all
/// texels within 2^30 of it have their places in all scales, exactly.
glsl::Program program_of(const StackPlanes& planes, uint32_t seed, glsl::uvec2 reference);

/// The same place in each scale's terms: nesting and nesting_offset of stack_bindings.glsl.
struct Nesting {
  std::array<glsl::uvec4, kMaxScales> tiles{};
  std::array<glsl::ivec2, kMaxScales> offsets{};
};
Nesting nesting_at(const StackPlanes& planes, glsl::uvec2 reference);

}  // namespace texbake
