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
  Sampler<MaskTexel> masks;
  sampler2D noise_tiles;
  int noise_size = 0;
  Sampler<LevelBlock> level_blocks;
  usampler2D level_entries;
  int level_count = 0;
  int first_level = 1;
  ivec2 tile_size{1, 1};
  uint content_count = 1;
  uint seed = 0;
  ivec4 deform_matrix{65536, 0, 0, 65536};
  uvec2 deform_from_tile{0, 0};
  ivec2 deform_from{0, 0};
  uvec2 deform_to_tile{0, 0};
  ivec4 deform_to{0, 0, 0, 0};
  ivec2 turbulence{0, 6};

#define PRECISE
#include "shaders/hash.glsl"
//
#include "shaders/content.glsl"
//
#include "shaders/sample.glsl"
//
#include "shaders/noise.glsl"
//
#include "shaders/deform.glsl"
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
