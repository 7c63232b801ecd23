// What the shader texts bind, as members of C++. Each uniform is listed once: fields(self, visit) calls visit("name",
// member) for every uniform of a group, as fields() of the options does. The C++ program inherits the groups, prepared
// planes inherit those that they decide, and whoever binds a program on a GPU or exports one reads the lists. What
// textures and uniforms mean is in shaders/README.md.
#pragma once

#include <type_traits>

#include "libbake/reference/glsl.h"

namespace texbake::glsl {

/// Every texture, of one scale or several, with relief or without; for_each_texture of the planes tells what they read.
struct Samplers {
  usampler2D patch_plane;
  isampler2D contents;
  isampler2D centers;
  sampler2D base;
  Sampler<MaskTexel> masks;
  sampler2D noise_tiles;
  isampler2D level_table;
  Sampler<LevelBlock> level_blocks;
  usampler2D level_entries;
  Sampler<MaskTexel> level_weights;
  sampler2D base_levels;
  fragment_sampler2D fragment_plane;
  sampler2D local_mean;
  isampler2D scale_table;
  sampler2D color_table;
  isampler2D fragment_shares;
  sampler2D height_plane;
  sampler2D height_levels;
};

/// How noises are laid out, and what they are added to. In a stack: of the scale in use.
struct NoiseUniforms {
  int noise_step = 0;      ///< 0 without noise
  int noise_root = 0;      ///< 1 where noise is added to the square root of light
  ivec2 noise_log2{0, 0};  ///< log2 of the width and height of the noises

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("noise_step", self.noise_step);
    visit("noise_root", self.noise_root);
    visit("noise_log2", self.noise_log2);
  }
};

/// Which levels of detail there are. In a stack: of the scale in use.
struct LevelUniforms {
  int level_count = 0;  ///< levels beside level 0
  int first_level = 1;  ///< 0 where borders of patches are soft

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("level_count", self.level_count);
    visit("first_level", self.first_level);
  }
};

/// The tile, and which contents are drawn. In a stack: of the scale in use.
struct TileUniforms {
  ivec2 tile_size{1, 1};
  uint content_count = 1;
  uint seed = 0;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("tile_size", self.tile_size);
    visit("content_count", self.content_count);
    visit("seed", self.seed);
  }
};

/// How an artist deforms the structure of a window.
struct DeformUniforms {
  int deformed = 0;  ///< 1 where it is deformed
  ivec4 deform_matrix{65536, 0, 0, 65536};
  uvec2 deform_from_tile{0, 0};
  ivec2 deform_from{0, 0};
  uvec2 deform_to_tile{0, 0};
  ivec4 deform_to{0, 0, 0, 0};
  ivec2 deform_axis_256{0, 0};
  ivec2 deform_probes{0, 0};
  ivec2 turbulence{0, 6};

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("deformed", self.deformed);
    visit("deform_matrix", self.deform_matrix);
    visit("deform_from_tile", self.deform_from_tile);
    visit("deform_from", self.deform_from);
    visit("deform_to_tile", self.deform_to_tile);
    visit("deform_to", self.deform_to);
    visit("deform_axis_256", self.deform_axis_256);
    visit("deform_probes", self.deform_probes);
    visit("turbulence", self.turbulence);
  }
};

/// Several scales of one material.
struct StackUniforms {
  int finest_noise_step = 0;
  int scale_count = 1;
  uint stack_seed = 0;
  uvec4 nesting[8] = {};
  ivec2 nesting_offset[8] = {};

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("finest_noise_step", self.finest_noise_step);
    visit("scale_count", self.scale_count);
    visit("stack_seed", self.stack_seed);
    visit("nesting", self.nesting);
    visit("nesting_offset", self.nesting_offset);
  }
};

/// The relief of the coarsest scale.
struct ReliefUniforms {
  float relief_depth = 0;  ///< texels of the coarsest scale between height 0 and 1
  vec4 relief_range{0, 0, 0, 0};
  vec4 relief_light{0, 0, 1, 0};
  ivec2 relief_steps{1, 0};
  int relief_kind = kUnlit;  ///< of the normals: kPlaneReliefOpengl or kPlaneReliefDirectx

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("relief_depth", self.relief_depth);
    visit("relief_range", self.relief_range);
    visit("relief_light", self.relief_light);
    visit("relief_steps", self.relief_steps);
    visit("relief_kind", self.relief_kind);
  }
};

/// The camera of a perspective view.
struct CameraUniforms {
  vec3 view_corner{0, 0, 1};
  vec3 view_right{0, 0, 0};
  vec3 view_down{0, 0, 0};
  float view_height = 1;
  int view_filter = kFilterBilinear;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("view_corner", self.view_corner);
    visit("view_right", self.view_right);
    visit("view_down", self.view_down);
    visit("view_height", self.view_height);
    visit("view_filter", self.view_filter);
  }
};

/// What `main` of the .frag texts reads beside the groups above, for a host on a GPU: C++ passes these as arguments.
struct MainUniforms {
  uvec2 origin_tile{0, 0};
  ivec2 origin_offset{0, 0};
  ivec2 first_row{0, 1};
  uint step_256 = 256;
  int filter_kind = kFilterBilinear;
  int level_256 = 0;
  int plane_kind = kPlanePlain;
  int view_scale = 0;
  float fading = 0;
  float variation = 1;
  vec3 slant{0, 0, 1};
  vec4 sky{0, 0, 0, 0};

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("origin_tile", self.origin_tile);
    visit("origin_offset", self.origin_offset);
    visit("first_row", self.first_row);
    visit("step_256", self.step_256);
    visit("filter_kind", self.filter_kind);
    visit("level_256", self.level_256);
    visit("plane_kind", self.plane_kind);
    visit("view_scale", self.view_scale);
    visit("fading", self.fading);
    visit("variation", self.variation);
    visit("slant", self.slant);
    visit("sky", self.sky);
  }
};

/// Every uniform of `program`, a Program or a PerspectiveProgram.
template <class AnyProgram, class Visitor>
void for_each_uniform(AnyProgram& program, Visitor&& visit) {
  NoiseUniforms::fields(program, visit);
  LevelUniforms::fields(program, visit);
  TileUniforms::fields(program, visit);
  DeformUniforms::fields(program, visit);
  StackUniforms::fields(program, visit);
  ReliefUniforms::fields(program, visit);
  if constexpr (std::is_base_of_v<CameraUniforms, AnyProgram>) CameraUniforms::fields(program, visit);
}

}  // namespace texbake::glsl
