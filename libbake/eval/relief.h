// Relief mapping: the point of the texture that a slanted ray meets, and how it is lit.
// Based on: Policarpo, Oliveira and Comba 2005; Vanhoey et al. 2013, §7.
#pragma once

#include <optional>

#include "libbake/base/options.h"
#include "libbake/eval/prepare.h"
#include "libbake/eval/program.h"

namespace texbake {

/// What tells the slope of the surface to the light.
enum class ShadeBy {
  none,    ///< colours as they are
  height,  ///< the gradient of the height map
  normal,  ///< the material's normal map
};
template <>
struct EnumNames<ShadeBy> {
  static constexpr std::pair<ShadeBy, std::string_view> values[] = {
      {ShadeBy::none, "none"}, {ShadeBy::height, "height"}, {ShadeBy::normal, "normal"}};
};

struct ReliefOptions {
  float depth_px = 0;  ///< texels of the coarsest scale between height 0 and 1; 0: no relief
  ShadeBy shade_by = ShadeBy::height;
  float ambient = 0.25f;
  int linear_steps = 32;
  int binary_steps = 6;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.depth_px, Field{.name = "relief",
                               .unit = "texels",
                               .min = 0,
                               .max = 1024,
                               .help = "of the coarsest scale between height 0 and 1; 0: flat and unlit"});
    visit(self.shade_by, Field{.name = "shade", .help = "what tells the slope of the relief to the light"});
    visit(self.ambient,
          Field{.name = "ambient", .min = 0, .max = 1, .help = "share of the light that has no direction"});
    visit(self.linear_steps,
          Field{.name = "relief-steps", .min = 1, .max = 1024, .help = "of the linear search along a ray"});
    visit(self.binary_steps,
          Field{.name = "relief-refinements", .min = 0, .max = 16, .help = "of the binary search that follows"});
  }
};

/// A direction in the texture's frame: x right, y down, z out of the surface, towards the viewer or the light.
struct Direction {
  float x = 0, y = 0, z = 1;
};

/// The reference text with the relief of one scale bound to it.
class Relief {
 public:
  /// `planes` are those of the coarsest scale; its map "height" is the relief, its normal map tells slopes to the light
  /// for ShadeBy::normal. Borrows `planes`. Throws Error(usage) when a map that is needed is not there, and for a light
  /// that does not come from above.
  Relief(const EvaluatorPlanes& planes, const ReliefOptions& options, const Direction& light);

  /// Where a ray from the viewer through `at`, a point of the coarsest scale, meets the surface. `program` reads that
  /// scale: program_of its planes, or of a stack with scale 0 in use.
  glsl::Position met(glsl::Program& program, const glsl::Position& at, const Direction& viewer) const;
  /// What the colour at a point that was met is multiplied with; 1 where the surface is flat.
  float light_at(glsl::Program& program, const glsl::Position& at) const;
  /// Binds the height map and the search to `program`.
  void bind(glsl::Program& program) const;

  const ReliefOptions& options() const { return options_; }
  glsl::vec4 range() const { return range_; }
  glsl::vec4 light() const { return light_; }
  const Plane& height() const { return *height_; }
  const Plane* normal() const { return normal_; }

 private:
  ReliefOptions options_;
  const Plane* height_ = nullptr;
  const Plane* normal_ = nullptr;
  glsl::vec4 range_{0, 0, 0, 0};
  glsl::vec4 light_{0, 0, 1, 0};
};

/// A step of a point of the coarsest scale, taken by a point of a scale whose texels are `ratio` times smaller.
glsl::Position moved_alike(glsl::Program& program, const glsl::Position& from, const glsl::Position& to, V2i size,
                           const glsl::Position& at, int ratio);

}  // namespace texbake
