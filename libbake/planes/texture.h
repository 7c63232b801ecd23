// How a texture of the shader texts is told to those who bind or export it. Prepared planes list theirs:
// for_each_texture in evaluator_planes.h, stack_planes.h and relief_planes.h calls visit(texture, image, sampler) for
// each, `sampler` being the member of glsl::Samplers that reads it. What a texture holds is in shaders/README.md.
#pragma once

#include <cstdint>

#include "libbake/base/image.h"
#include "libbake/reference/bindings.h"

namespace texbake {

/// What an export may round values to.
enum class Precision {
  exact,       ///< nothing
  exact_half,  ///< halves, where every value is one
  half,        ///< halves
};

struct Texture {
  const char* name;  ///< of the sampler
  Precision precision = Precision::exact;
};

/// How a GPU stores texels of a type: the format as OpenGL spells it, and the sampler that reads it.
struct TexelFormat {
  const char* name;
  const char* sampler;
};
template <class T>
inline constexpr TexelFormat kTexelFormat{};
template <>
inline constexpr TexelFormat kTexelFormat<glsl::PatchTexel>{"RG16UI", "usampler2D"};
template <>
inline constexpr TexelFormat kTexelFormat<glsl::MaskTexel>{"RGBA16UI", "usampler2D"};
template <>
inline constexpr TexelFormat kTexelFormat<glsl::LevelBlock>{"RG32UI", "usampler2D"};
template <>
inline constexpr TexelFormat kTexelFormat<uint32_t>{"R32UI", "usampler2D"};
template <>
inline constexpr TexelFormat kTexelFormat<glsl::FragmentTexel>{"RGBA16I", "isampler2D"};
template <>
inline constexpr TexelFormat kTexelFormat<glsl::ivec4>{"RGBA32I", "isampler2D"};
template <>
inline constexpr TexelFormat kTexelFormat<glsl::vec4>{"RGBA32F", "sampler2D"};

}  // namespace texbake
