// Binds prepared planes to the reference text, as a GPU program binds textures.
#pragma once

#include "libbake/planes/evaluator_planes.h"
#include "libbake/reference/program.h"

namespace texbake {

template <class T>
glsl::Sampler<T> sampler_of(const Image<T>& image) {
  return {image.data(), image.width()};
}

/// Borrows `planes`.
inline glsl::Program program_of(const EvaluatorPlanes& planes, uint32_t seed) {
  glsl::Program program;
  program.patch_plane = sampler_of(planes.patch_plane);
  program.contents = sampler_of(planes.contents);
  program.centers = sampler_of(planes.centers);
  program.base = sampler_of(planes.base.texels);
  program.masks = sampler_of(planes.masks);
  program.noise_tiles = sampler_of(planes.noise_tiles);
  program.noise_log2 = {planes.noise_log2.x, planes.noise_log2.y};
  program.noise_step = planes.noise_step;
  program.noise_root = planes.noise_root;
  program.level_table = sampler_of(planes.level_table);
  program.level_blocks = sampler_of(planes.level_blocks);
  program.level_entries = sampler_of(planes.level_entries);
  program.level_weights = sampler_of(planes.level_weights);
  program.level_count = planes.level_count;
  program.first_level = planes.first_level;
  program.tile_size = {planes.size.x, planes.size.y};
  program.content_count = static_cast<uint32_t>(planes.content_count);
  program.seed = seed;
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
