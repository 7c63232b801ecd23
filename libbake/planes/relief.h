// How relief is asked for: its depth, what lights it, and how carefully rays are followed.
#pragma once

#include "libbake/base/options.h"

namespace texbake {

/// What tells the slope of the surface to the light.
enum class ShadeBy {
  none,    ///< colors as they are
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
    visit(
        self.depth_px,
        Field{
            .name = "relief",
            .unit = "texels",
            .min = 0,
            .max = 1024,
            .help =
                "depth of the relief: texels of the coarsest scale between height 0 and height 1; 0: flat and unlit"});
    visit(self.shade_by,
          Field{.name = "shade",
                .help = "source of the surface slope that is lit: the height map or the normal map; none: unlit"});
    visit(self.ambient, Field{.name = "ambient", .min = 0, .max = 1, .help = "share of ambient light"});
    visit(self.linear_steps, Field{.name = "relief-steps",
                                   .min = 1,
                                   .max = 1024,
                                   .help = "maximum number of steps of the linear search along a ray"});
    visit(self.binary_steps, Field{.name = "relief-refinements",
                                   .min = 0,
                                   .max = 16,
                                   .help = "number of steps of the binary search that follows"});
  }
};

/// A direction in the texture's frame: x right, y down, z out of the surface, towards the viewer or the light.
struct Direction {
  float x = 0, y = 0, z = 1;
};

/// Towards the light unless a caller says otherwise: from the upper left, as pictures of reliefs are lit by custom.
inline constexpr Direction kDefaultLight{-1, -1, 1.5f};

}  // namespace texbake
