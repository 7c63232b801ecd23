// The reference shader as a C++ type: its uniforms are the members, its functions the member functions.

#pragma once

#include "libbake/reference/glsl.h"

namespace texbake::glsl {

/// Cheap to copy; borrows every plane. Each thread works on its own copy.
struct Program {
  usampler2D patch_plane;
  isampler2D contents;
  isampler2D centers;
  sampler2D base;
  Sampler<MaskTexel> masks;
  sampler2D noise_tiles;
  ivec2 noise_log2{0, 0};
  int noise_step = 0;
  int noise_root = 0;
  isampler2D level_table;
  Sampler<LevelBlock> level_blocks;
  usampler2D level_entries;
  Sampler<MaskTexel> level_weights;
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
  int plane_row = 0;
  int first_patch = 0;
  int level_row = 0;
  int block_row = 0;
  int entry_row = 0;
  int value_row = 0;

  // A stack of scales.
  int finest_noise_step = 0;
  fragment_sampler2D fragment_plane;
  sampler2D local_mean;
  isampler2D scale_table;
  sampler2D color_table;
  sampler2D base_levels;
  isampler2D fragment_shares;
  int dominant_row = 0;
  int share_row = 0;
  int scale_count = 1;
  uint stack_seed = 0;
  uvec4 nesting[8] = {};
  ivec2 nesting_offset[8] = {};
  int ratio = 1;
  int first_class = 0;
  int transfer_bits = 0;
  int kept_scale = -1;
  uvec2 kept_tile{0, 0};
  ivec2 kept_p{0, 0};
  vec4 kept_color{0, 0, 0, 0};

  // Relief.
  sampler2D height_plane;
  vec4 relief_range{0, 0, 0, 0};
  ivec2 relief_steps{1, 0};
  sampler2D height_levels;
  float relief_depth = 0;
  vec4 relief_light{0, 0, 1, 0};
  int relief_kind = 0;
  int relief_level = 0;

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
//
#include "shaders/scales.glsl"
//
#include "shaders/stack_levels.glsl"
//
#include "shaders/relief.glsl"
//
#include "shaders/stack_relief.glsl"
//
#include "shaders/stack_probes.glsl"
#undef PRECISE
};

using Texel = Program::Texel;
using Decision = Program::Decision;
using Source = Program::Source;
using Position = Program::Position;
using Footprint = Program::Footprint;
using Probes = Program::Probes;
using Grid = Program::Grid;
using StackProbes = Program::StackProbes;
using StackSight = Program::StackSight;

}  // namespace texbake::glsl
