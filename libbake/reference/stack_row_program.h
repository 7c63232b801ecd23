// The reference text of a stack with a memory of what was seen last: probes and pixels side by side mostly read the
// same blocks, and blocks side by side the same coarser colors.
#pragma once

#include <algorithm>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/reference/program.h"

namespace texbake::glsl {

inline bool same(const Texel& a, const Texel& b) {
  return a.p.x == b.p.x && a.p.y == b.p.y && a.tile.x == b.tile.x && a.tile.y == b.tile.y;
}

/// Remembers coarser colors. Differs from Program in time alone. Not to be shared between threads.
class ColorProgram : public Program {
 public:
  explicit ColorProgram(const Program& program) : Program(program), colors_(kSlots) {}

  vec4 coarser_color(int scale, const Texel& center, float coarser_share) {
    Color& color = colors_[static_cast<uint32_t>(center.p.x + 67 * center.p.y) % kSlots];
    if (!color.is(scale, center)) color = {center, scale, Program::coarser_color(scale, center, coarser_share)};
    return color.value;
  }

// The text once more, as functions of this class: those that it inherits call Program::coarser_color, these the one
// above.
#define PRECISE
#include "shaders/stack_levels.glsl"
#undef PRECISE

 private:
  /// The center of a fragment, and the coarser color there.
  struct Color {
    Texel center{{0, 0}, {0, 0}};
    int scale = -1;
    vec4 value{0, 0, 0, 0};

    bool is(int of, const Texel& at) const { return same(center, at) && scale == of; }
  };

  static constexpr uint32_t kSlots = 1 << 10;  ///< 48 KiB: a view from near sees so many fragments
  std::vector<Color> colors_;
};

/// Remembers blocks too.
class StackRowProgram : public ColorProgram {
 public:
  explicit StackRowProgram(const Program& program) : ColorProgram(program), known_(kSlots) {}

  vec4 scale_block(int scale, const Texel& block, const Grid& grid, float variation) {
    Known& known = known_[slot_of(block, grid)];
    if (!known.is(scale, block, grid, variation))
      known = {block, grid.corner, scale, variation, ColorProgram::scale_block(scale, block, grid, variation)};
    return known.value;
  }

// Likewise, so that it calls the scale_block above.
#define PRECISE
#include "shaders/stack_probes.glsl"
#undef PRECISE

 private:
  /// A block and what it shows. Levels differ in the corner of their grids; those that share one are the same.
  struct Known {
    Texel block{{0, 0}, {0, 0}};
    ivec2 corner{0, 0};
    int scale = -1;
    float variation = 0;
    vec4 value{0, 0, 0, 0};

    bool is(int of, const Texel& at, const Grid& grid, float share) const {
      return same(block, at) && corner.x == grid.corner.x && corner.y == grid.corner.y && scale == of &&
             variation == share;
    }
  };

  static constexpr uint32_t kSlots = 1 << 12;  ///< 48 bytes each, 192 KiB: what a core keeps near

  /// Blocks side by side, and those above each other, have different slots.
  static uint32_t slot_of(const Texel& block, const Grid& grid) {
    const auto place = static_cast<uint32_t>(block.p.x + 67 * block.p.y + 1031 * (grid.corner.x + grid.corner.y));
    return place % kSlots;
  }

  std::vector<Known> known_;
};

/// Calls draw(program, j) for 0 ≤ j < rows, a few rows with one memory.
template <class Draw>
void for_each_row(const Program& bound, int rows, const Draw& draw) {
  constexpr int kRows = 8;
  parallel_for(0, (rows + kRows - 1) / kRows, [&](int strip) {
    StackRowProgram program(bound);
    for (int j = strip * kRows; j < std::min(rows, (strip + 1) * kRows); ++j) draw(program, j);
  });
}

}  // namespace texbake::glsl
