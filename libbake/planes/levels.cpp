#include "libbake/planes/levels.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/planes/level_shares.h"
#include "libbake/planes/level_weights.h"
#include "libbake/planes/local_mean.h"
#include "libbake/planes/program_of.h"

namespace texbake {
namespace {

using glsl::PatchTexel;
using glsl::vec4;

/// What texels show of a plane, as shares: of every patch that counts there.
class TexelValues {
 public:
  TexelValues(const TilePlanes& planes, const Plane& plane, const LevelLists& lists, ImageView<vec4> values)
      : planes_(planes), plane_(plane), lists_(lists), values_(values), program_(program_of(planes, 0)) {
    if (planes.soft_border_px > 0) local_mean_ = local_mean(plane.texels, planes.soft_border_px);
  }

  /// Where borders are soft: those with several patches, which have entries.
  void fill_soft_texels() {
    if (planes_.soft_border_px == 0) return;
    const V2i size = texels().cover.size;
    parallel_for(0, size.y, [&](int y) {
      for (int x = 0; x < size.x; ++x) fill_soft_texel({x, y});
    });
  }

  vec4 operator()(V2i p, uint32_t k, int content) const {
    const uint32_t first = texels().first_at(p);
    return first > 0 ? value(first + k, content) : shown(plane_.texels, p, texels().cover.at(p.x, p.y)[k], content);
  }

 private:
  const LevelList& texels() const { return lists_.lists[0]; }

  vec4& value(uint32_t entry, int content) const {
    return values_.data()[size_t{entry} * static_cast<size_t>(planes_.content_count) + static_cast<size_t>(content)];
  }

  /// A texel of several patches, of weights w. A plain blend of independent contents would keep Σ w² of their variance,
  /// and all of it where they are the same, as when all are the identity: of N_t² pairs of draws, one. What differs
  /// from the local mean is enlarged so that the variance is kept on the average.
  void fill_soft_texel(V2i p) {
    const uint32_t first = texels().first_at(p);
    if (first == 0) return;
    const auto entries = texels().cover.at(p.x, p.y);
    const float* const weights = lists_.weights.data() + texels().cover.first_at(p.x, p.y);
    float squares = 0;
    for (size_t i = 0; i < entries.size(); ++i) squares += weights[i] * weights[i];
    const auto pairs = static_cast<float>(planes_.content_count) * static_cast<float>(planes_.content_count);
    const float gain = 1 / std::sqrt(squares + (1 - squares) / pairs);
    for (size_t i = 0; i < entries.size(); ++i)
      for (int content = 0; content < planes_.content_count; ++content) {
        const vec4 mean = shown(local_mean_, p, entries[i], content);
        const vec4 all = shown(plane_.texels, p, entries[i], content);
        vec4& share = value(first + static_cast<uint32_t>(i), content);
        share = (mean + (all - mean) * gain) * weights[i];
        // Beside colors stands what they take of a coarser scale, which has no detail.
        if (is_plain_) share.w = all.w * weights[i];
      }
  }

  /// What a patch's content shows at a texel, of the plane or of what stands in its place.
  vec4 shown(const Image<vec4>& pixels, V2i p, const PatchTexel& owned, int content) const {
    const glsl::ivec4& moved = planes_.contents(content, owned.patch_idx);
    if (moved.z == 65536 && moved.w == 0 && is_plain_) {
      const glsl::ivec2 texel = program_.moved_source({p.x, p.y}, moved).texel;
      return pixels(texel.x, texel.y);
    }
    return shown_by_text(pixels, p, owned, content);
  }

  /// The same in any case.
  vec4 shown_by_text(const Image<vec4>& pixels, V2i p, const PatchTexel& owned, int content) const {
    const glsl::Source source = program_.source_of({{0, 0}, {p.x, p.y}}, decision_of(owned, content));
    return program_.kind_value(sampler_of(pixels), plane_kind(plane_.kind), source);
  }

  const TilePlanes& planes_;
  const Plane& plane_;
  const LevelLists& lists_;
  ImageView<vec4> values_;
  const bool is_plain_ = plane_.kind == MapKind::plain || plane_.kind == MapKind::structure;
  Image<vec4> local_mean_;
  mutable glsl::Program program_;  ///< what is called here of the text writes nothing
};

/// What texels show of the structure, as shares, with what noise adds on the average, which belongs to their own patch.
class StructureValues {
 public:
  StructureValues(const TilePlanes& planes, const TexelValues& texels) : planes_(planes), texels_(texels) {}

  vec4 operator()(V2i p, uint32_t k, int content) const {
    const vec4 share = texels_(p, k, content);
    if (k > 0) return share;
    const glsl::Source source =
        program_.source_of({{0, 0}, {p.x, p.y}}, decision_of(planes_.patch_plane(p.x, p.y), content));
    const vec4 structure = program_.source_value(program_.base, source);
    const Imath::V3d change =
        planes_.noise_mean.change({structure.x, structure.y, structure.z}, shares_of(program_.source_weights(source))) *
        double{planes_.noise_gain.empty() ? 1 : planes_.noise_gain(source.nearest.x, source.nearest.y)};
    return share + vec4(static_cast<float>(change.x), static_cast<float>(change.y), static_cast<float>(change.z), 0);
  }

 private:
  static Imath::V4f shares_of(const glsl::uvec4& weights) {
    return Imath::V4f(static_cast<float>(weights.x), static_cast<float>(weights.y), static_cast<float>(weights.z),
                      static_cast<float>(weights.w)) /
           2048.0f;
  }

  const TilePlanes& planes_;
  const TexelValues& texels_;
  mutable glsl::Program program_ = program_of(planes_, 0);  ///< what is called here of the text writes nothing
};

}  // namespace

int value_rows(const LevelLists& lists, const TilePlanes& planes) {
  return list_rows(lists.count * static_cast<uint64_t>(planes.content_count));
}

void fill_levels(const LevelLists& lists, const Plane& plane, const TilePlanes& planes, ImageView<vec4> values) {
  const uint64_t count = lists.count * static_cast<uint64_t>(planes.content_count);
  std::fill(values.begin() + count, values.end(), vec4{0, 0, 0, 0});
  TexelValues texels(planes, plane, lists, values);
  texels.fill_soft_texels();
  if (plane.kind == MapKind::structure)
    LevelShares(lists, planes.content_count, values, StructureValues(planes, texels)).fill();
  else
    LevelShares(lists, planes.content_count, values, texels).fill();
}

Image<vec4> level_values(const LevelLists& lists, const Plane& plane, const TilePlanes& planes) {
  auto values = Image<vec4>::unset(kListWidth, value_rows(lists, planes));
  fill_levels(lists, plane, planes, values);
  return values;
}

EvaluatorPlanes::EvaluatorPlanes(TilePlanes tile) : TilePlanes(std::move(tile)) {
  const LevelLists lists = level_lists(*this);
  static_cast<LevelTables&>(*this) = level_tables(lists, *this);
  base.level_values = texbake::level_values(lists, base, *this);
  for (Plane& plane : maps) plane.level_values = texbake::level_values(lists, plane, *this);
  level_weights = base.kind == MapKind::structure ? texbake::level_weights(*this, lists)
                                                  : Image<glsl::MaskTexel>(1, 1, glsl::MaskTexel{});
}

}  // namespace texbake
