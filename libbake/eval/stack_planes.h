// Puts the planes of several scales together, as shaders/scales.glsl reads them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libbake/eval/prepare.h"
#include "libbake/eval/program.h"
#include "libbake/eval/transfer.h"

namespace texbake {

/// One scale, coarse to fine.
struct StackScale {
  EvaluatorInput input;                     ///< noise: of the finest scale alone
  const ScaleTransfer* transfer = nullptr;  ///< nullptr for the coarsest alone
  V3f strength{1};                          ///< what its colours are multiplied with: set_strengths
};

/// Sets the strength of every scale, as its transfer asks for; a part of prepare_stack and of add_levels.
void set_strengths(std::vector<StackScale>& scales);

/// Everything that a stack binds: shaders/README.md, "Several scales".
struct StackPlanes {
  std::vector<V2i> sizes;                ///< of the tiles, coarse to fine
  std::vector<ScaleTransfer> transfers;  ///< of each scale; the coarsest's means nothing
  std::vector<int> content_counts, patch_counts;
  Image<glsl::PatchTexel> patch_plane;
  Image<glsl::ivec4> contents;
  Image<glsl::vec4> base;
  Image<glsl::FragmentTexel> fragment_plane;
  Image<glsl::vec4> local_mean;
  V2i noise_log2{0, 0};  ///< this and the next three: of the finest scale, as in EvaluatorPlanes
  int noise_step = 0;
  int noise_root = 0;
  Image<glsl::MaskTexel> masks;
  Image<glsl::vec4> noise_tiles;
  Image<glsl::ivec4> scale_table;  ///< with the centres of patches; add_levels appends the tables of levels
  Image<glsl::vec4> color_table;
  /// This and what follows: empty until add_levels (stack_levels.h), if borders are hard.
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

/// Throws Error(bad_data) where prepare does, for more than kMaxScales scales, noise in a scale that is not the finest,
/// a scale without fragments or colours beside others, a ratio out of range, lists of weights of another length than
/// the palette, or a tile that is larger than that of the coarser scale: the scales are then in the wrong order.
StackPlanes prepare_stack(const std::vector<StackScale>& scales);

/// What `scale` replaces from now on, of planes that were prepared with its local mean.
void set_detail_mean(StackPlanes& planes, int scale, DetailMean mean);

/// Throws Error(bad_data) unless `fine` can follow `coarse` with `transfer`; a part of prepare_stack that costs
/// nothing.
void check_transfer(const StackScale& coarse, const StackScale& fine);

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
