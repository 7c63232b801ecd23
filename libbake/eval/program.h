// The reference shader as a C++ type: its uniforms are the members, its functions the member functions.
// Included only by sources of libbake/eval and by tests.
#pragma once

#include "libbake/eval/glsl.h"

namespace texbake::glsl {

/// Cheap to copy; borrows every plane. Each thread works on its own copy.
struct Program {
  usampler2D patch_plane;
  isampler2D contents;
  isampler2D centers;
  sampler2D base;
  Sampler<LevelBlock> level_blocks;
  usampler2D level_entries;
  int level_count = 0;
  int first_level = 1;
  ivec2 tile_size{1, 1};
  uint content_count = 1;
  uint seed = 0;

#define PRECISE
#include "shaders/hash.glsl"
//
#include "shaders/content.glsl"
//
#include "shaders/sample.glsl"
//
#include "shaders/levels.glsl"
#undef PRECISE
};

using Texel = Program::Texel;
using Decision = Program::Decision;
using Source = Program::Source;
using Position = Program::Position;
using Footprint = Program::Footprint;
using Probes = Program::Probes;

}  // namespace texbake::glsl
