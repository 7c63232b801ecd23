// The words of GLSL that the shader text uses, spelled in C++, so that the same text runs on the processor.
// Arithmetic on vectors is componentwise and rounds each operation once: compile with -ffp-contract=off.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace texbake::glsl {

using uint = uint32_t;

#include "shaders/constants.glsl"

struct uvec2;

struct ivec2 {
  int x, y;
  ivec2() = default;
  ivec2(int x_, int y_) : x(x_), y(y_) {}
  explicit ivec2(const uvec2& v);
};

struct uvec2 {
  uint x, y;
  uvec2() = default;
  uvec2(uint x_, uint y_) : x(x_), y(y_) {}
  /// Keeps the bits: −1 is 2^32 − 1.
  explicit uvec2(const ivec2& v) : x(static_cast<uint>(v.x)), y(static_cast<uint>(v.y)) {}
};
inline ivec2::ivec2(const uvec2& v) : x(static_cast<int>(v.x)), y(static_cast<int>(v.y)) {}

inline uvec2 operator+(const uvec2& a, const uvec2& b) { return {a.x + b.x, a.y + b.y}; }

struct ivec4 {
  int x, y, z, w;
  ivec4() = default;
  constexpr ivec4(int x_, int y_, int z_, int w_) : x(x_), y(y_), z(z_), w(w_) {}
};
struct uvec4 {
  uint x, y, z, w;
  uvec4() = default;
  constexpr uvec4(uint x_, uint y_, uint z_, uint w_) : x(x_), y(y_), z(z_), w(w_) {}
};
inline uvec4 operator+(const uvec4& a, const uvec4& b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
inline uvec4 operator*(const uvec4& a, uint b) { return {a.x * b, a.y * b, a.z * b, a.w * b}; }
inline uvec4 operator>>(const uvec4& a, uint b) { return {a.x >> b, a.y >> b, a.z >> b, a.w >> b}; }
struct vec3 {
  float x, y, z;
};
struct alignas(16) vec4 {
  float x, y, z, w;
  vec4() = default;
  vec4(float x_, float y_, float z_, float w_) : x(x_), y(y_), z(z_), w(w_) {}
  bool operator==(const vec4&) const = default;
};
inline vec4 operator+(const vec4& a, const vec4& b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
inline vec4 operator-(const vec4& a, const vec4& b) { return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w}; }
inline vec4 operator*(const vec4& a, const vec4& b) { return {a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w}; }
inline vec4 operator*(const vec4& a, float b) { return {a.x * b, a.y * b, a.z * b, a.w * b}; }

/// Only for what comes before the exact path.
struct vec2 {
  float x, y;
  vec2() = default;
  constexpr vec2(float x_, float y_) : x(x_), y(y_) {}
};
inline float sqrt(float x) { return std::sqrt(x); }
inline float floor(float x) { return std::floor(x); }
inline float abs(float x) { return std::fabs(x); }
inline uint floatBitsToUint(float x) { return std::bit_cast<uint>(x); }
inline float uintBitsToFloat(uint x) { return std::bit_cast<float>(x); }

/// A texture whose texels have the type that texelFetch returns; borrows the pixels, rows from the top.
template <class T>
struct Sampler {
  const T* texels = nullptr;
  int width = 0;
};
using sampler2D = Sampler<vec4>;
using isampler2D = Sampler<ivec4>;

/// The patch plane: two 16-bit channels.
struct PatchTexel {
  uint16_t patch_idx = 0;
  uint16_t owner = 5;  ///< (owner.x + 1) | (owner.y + 1) << 2
  bool operator==(const PatchTexel&) const = default;
};
using usampler2D = Sampler<PatchTexel>;

/// The masks: four 16-bit channels.
struct MaskTexel {
  uint16_t weights[4] = {2048, 0, 0, 0};
  bool operator==(const MaskTexel&) const = default;
};
/// A block of texels in level_blocks: two 32-bit channels.
struct LevelBlock {
  uint32_t first = 0;  ///< entry in level_entries
  uint32_t owned =
      0;  ///< patch idx of that entry | owner << kBlockOwnerBit | number of those after it << kBlockFollowingBit
  bool operator==(const LevelBlock&) const = default;
};

/// The fragment plane of a stack: four 16-bit channels.
struct FragmentTexel {
  int16_t center_x = 0;  ///< way to the center of the texel's fragment, in texels
  int16_t center_y = 0;
  int16_t fragment_class = 0;
  int16_t class_idx = 0;  ///< of the texel
  bool operator==(const FragmentTexel&) const = default;
};
using fragment_sampler2D = Sampler<FragmentTexel>;

template <class T>
const T& texel_at_index(const Sampler<T>& sampler, const ivec2& p) {
  return sampler.texels[static_cast<size_t>(p.y) * static_cast<size_t>(sampler.width) + static_cast<size_t>(p.x)];
}
inline vec4 texelFetch(const sampler2D& sampler, const ivec2& p, int /*level*/) { return texel_at_index(sampler, p); }
inline ivec4 texelFetch(const isampler2D& sampler, const ivec2& p, int /*level*/) { return texel_at_index(sampler, p); }
inline ivec4 texelFetch(const fragment_sampler2D& sampler, const ivec2& p, int /*level*/) {
  const FragmentTexel& texel = texel_at_index(sampler, p);
  return {texel.center_x, texel.center_y, texel.fragment_class, texel.class_idx};
}
inline uvec4 texelFetch(const usampler2D& sampler, const ivec2& p, int /*level*/) {
  const PatchTexel& texel = texel_at_index(sampler, p);
  return {texel.patch_idx, texel.owner, 0, 1};
}
inline uvec4 texelFetch(const Sampler<MaskTexel>& sampler, const ivec2& p, int /*level*/) {
  const uint16_t* weights = texel_at_index(sampler, p).weights;
  return {weights[0], weights[1], weights[2], weights[3]};
}
inline uvec4 texelFetch(const Sampler<LevelBlock>& sampler, const ivec2& p, int /*level*/) {
  const LevelBlock& block = texel_at_index(sampler, p);
  return {block.first, block.owned, 0, 1};
}

}  // namespace texbake::glsl
