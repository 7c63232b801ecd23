#include "libbake/planes/level_weights.h"

#include <cmath>

#include "libbake/planes/level_shares.h"
#include "libbake/planes/program_of.h"

namespace texbake {
namespace {

using glsl::vec4;

constexpr float kSteps = 2048;  ///< what the weights of a texel sum to

/// What a texel's own patch shows there with `content`.
/// `program` is bound to `planes`; what is called here of the text writes nothing.
vec4 texel_weights(const TilePlanes& planes, glsl::Program& program, V2i p, int content) {
  const glsl::Source source =
      program.source_of({{0, 0}, {p.x, p.y}}, decision_of(planes.patch_plane(p.x, p.y), content));
  const glsl::uvec4 weights = program.source_weights(source);
  const vec4 of(static_cast<float>(weights.x), static_cast<float>(weights.y), static_cast<float>(weights.z),
                static_cast<float>(weights.w));
  const float gain = planes.noise_gain.empty() ? 1 : planes.noise_gain(source.nearest.x, source.nearest.y);
  return of * (gain / kSteps);
}

/// Means of the masks.
Image<vec4> share_weights(const TilePlanes& planes, const LevelLists& lists) {
  glsl::Program program = program_of(planes, 0);
  const auto texel_share = [&](V2i p, uint32_t k, int content) {
    return k > 0 ? vec4{0, 0, 0, 0} : texel_weights(planes, program, p, content);
  };
  Image<vec4> weights(kListWidth, list_rows(lists.count * static_cast<uint64_t>(planes.content_count)), {0, 0, 0, 0});
  LevelShares(lists, planes.content_count, weights, texel_share).fill();
  return weights;
}

Image<glsl::MaskTexel> in_steps(const Image<vec4>& weights) {
  const auto steps = [](float weight) { return static_cast<uint16_t>(std::lround(weight * kSteps)); };
  Image<glsl::MaskTexel> rounded(weights.width(), weights.height());
  for (size_t i = 0; i < weights.size(); ++i) {
    const vec4& of = weights.data()[i];
    rounded.data()[i] = {{steps(of.x), steps(of.y), steps(of.z), steps(of.w)}};
  }
  return rounded;
}

/// Sets those of the texels that are several patches' where borders are soft. They are drawn as texels are.
void add_texel_weights(const TilePlanes& planes, const LevelLists& lists, Image<vec4>& weights) {
  glsl::Program program = program_of(planes, 0);
  const LevelList& texels = lists.lists[0];
  for (int y = 0; y < texels.cover.size.y; ++y)
    for (int x = 0; x < texels.cover.size.x; ++x) {
      const size_t first = size_t{texels.first_at({x, y})} * static_cast<size_t>(planes.content_count);
      if (first == 0) continue;
      for (int content = 0; content < planes.content_count; ++content)
        weights.data()[first + static_cast<size_t>(content)] = texel_weights(planes, program, {x, y}, content);
    }
}

}  // namespace

Image<glsl::MaskTexel> level_weights(const TilePlanes& planes, const LevelLists& lists) {
  Image<vec4> weights = share_weights(planes, lists);
  add_texel_weights(planes, lists, weights);
  return in_steps(weights);
}

}  // namespace texbake
