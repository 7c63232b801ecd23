// Binds prepared planes to the reference text, as a GPU program binds textures.
#pragma once

#include "libbake/eval/prepare.h"
#include "libbake/eval/program.h"

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
  program.tile_size = {planes.size.x, planes.size.y};
  program.content_count = static_cast<uint32_t>(planes.content_count);
  program.seed = seed;
  return program;
}

}  // namespace texbake
