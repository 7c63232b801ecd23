// The reference text with a memory of its last decision: texels of a row mostly share a patch, and a decision is the
// same for all texels of a patch in one repetition of the tile.
#pragma once

#include "libbake/reference/program.h"

namespace texbake {

/// Differs from Program in time alone: its own `decide` and `texel_source` remember, the functions that it inherits do
/// not see them. Hence it draws texels in which one patch shows, through texel_source; texels on soft borders, levels
/// of detail and deformed windows go through inherited functions, without a memory. Not to be shared between threads.
class RowProgram : public glsl::Program {
 public:
  explicit RowProgram(const glsl::Program& program) : Program(program) {}

  Decision decide(const Texel& at) {
    const glsl::PatchTexel owned = texel_at_index(patch_plane, at.p);
    if (!(owned == owned_) || at.tile.x != tile_.x || at.tile.y != tile_.y) {
      owned_ = owned;
      tile_ = at.tile;
      decision_ = Program::decide(at);
    }
    return decision_;
  }
  Source texel_source(const Texel& at) { return source_of(at, decide(at)); }

 private:
  glsl::PatchTexel owned_{0, 0xffff};  ///< no texel of a patch plane
  glsl::uvec2 tile_{0, 0};
  Decision decision_{};
};

}  // namespace texbake
