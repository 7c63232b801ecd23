// The reference shader as a C++ type: its textures and uniforms are the members, its functions the member functions.
#pragma once

#include "libbake/reference/bindings.h"

namespace texbake::glsl {

/// Cheap to copy; borrows every plane. Each thread works on its own copy.
struct Program : Samplers, NoiseUniforms, LevelUniforms, TileUniforms, DeformUniforms, StackUniforms, ReliefUniforms {
  // Where the scale in use begins in planes and tables, and what else a stack says of it.
  int plane_row = 0;
  int first_patch = 0;
  int level_row = 0;
  int block_row = 0;
  int entry_row = 0;
  int value_row = 0;
  int dominant_row = 0;
  int share_row = 0;
  int ratio = 1;
  int first_class = 0;
  int transfer_bits = 0;
  // What coarser_color of a stack found last.
  int kept_scale = -1;
  uvec2 kept_tile{0, 0};
  ivec2 kept_p{0, 0};
  vec4 kept_color{0, 0, 0, 0};
  // The level at which heights are read.
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
#include "shaders/levels.glsl"
//
#include "shaders/deform.glsl"
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
