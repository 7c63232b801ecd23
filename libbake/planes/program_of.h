// Binds prepared planes to the reference text, as a GPU program binds textures.
#pragma once

#include "libbake/planes/evaluator_planes.h"
#include "libbake/reference/program.h"

namespace texbake {

template <class T>
glsl::Sampler<T> sampler_of(const Image<T>& image) {
  return {image.data(), image.width()};
}

/// What for_each_texture calls to give `program` its samplers; these borrow the images.
inline auto sampler_binder(glsl::Program& program) {
  return [&program](const Texture&, const auto& image, auto sampler) { program.*sampler = sampler_of(image); };
}

/// Gives `program` a group of uniforms that planes have decided.
template <class Uniforms>
void bind_uniforms(const Uniforms& planes, glsl::Program& program) {
  static_cast<Uniforms&>(program) = planes;
}

/// Level 0; borrows `planes`; draws the base.
inline glsl::Program program_of(const TilePlanes& planes, uint32_t seed) {
  glsl::Program program;
  for_each_texture(planes, planes.base, sampler_binder(program));
  bind_uniforms<glsl::NoiseUniforms>(planes, program);
  program.tile_size = {planes.size.x, planes.size.y};
  program.content_count = static_cast<uint32_t>(planes.content_count);
  program.seed = seed;
  return program;
}

/// All levels; borrows `planes`; draws the base.
inline glsl::Program program_of(const EvaluatorPlanes& planes, uint32_t seed) {
  glsl::Program program = program_of(static_cast<const TilePlanes&>(planes), seed);
  for_each_texture(planes, planes.base, sampler_binder(program));
  bind_uniforms<glsl::LevelUniforms>(planes, program);
  return program;
}

/// What a texel of level_blocks or patch_plane decides where its patch shows `content`.
inline glsl::Decision decision_of(const glsl::PatchTexel& owned, int content) {
  return {owned.patch_idx, content, {(owned.owner & 3) - 1, (owned.owner >> 2) - 1}};
}

/// What the text calls `kind`.
inline int plane_kind(MapKind kind) {
  switch (kind) {
    case MapKind::normal_opengl:
      return glsl::kPlaneNormalOpengl;
    case MapKind::normal_directx:
      return glsl::kPlaneNormalDirectx;
    case MapKind::height:
      return glsl::kPlaneHeight;
    case MapKind::structure:
      return glsl::kPlaneStructure;
    case MapKind::relief_opengl:
      return glsl::kPlaneReliefOpengl;
    case MapKind::relief_directx:
      return glsl::kPlaneReliefDirectx;
    case MapKind::plain:
      break;
  }
  return glsl::kPlanePlain;
}

}  // namespace texbake
