// From where the infinite texture is seen: straight on, or as an endless plane in perspective.
#pragma once

#include "cli/window_options.h"
#include "libbake/draw/perspective.h"

namespace texbake {

enum class View {
  flat,   ///< a window
  plane,  ///< an endless plane in perspective
};
template <>
struct EnumNames<View> {
  static constexpr std::pair<View, std::string_view> values[] = {{View::flat, "flat"}, {View::plane, "plane"}};
};

struct ViewOptions {
  View view = View::flat;
  double camera_height_texels = Perspective().height_texels;
  double pitch_deg = Perspective().pitch_deg;
  double yaw_deg = Perspective().yaw_deg;
  double fov_deg = Perspective().fov_deg;
  int supersample = 1;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.view, Field{.name = "view",
                           .help = "flat: a window of the texture; plane: an endless plane in perspective, where "
                                   "--origin is the point below the camera"});
    visit(self.camera_height_texels, Field{.name = "camera-height",
                                           .unit = "texels",
                                           .min = 0.001,
                                           .max = 1e6,
                                           .help = "height of the camera above the plane"});
    visit(self.pitch_deg, Field{.name = "pitch",
                                .unit = "degrees",
                                .min = -90,
                                .max = 90,
                                .help = "angle of the view's center below the horizon; 90 is straight down"});
    visit(self.yaw_deg, Field{.name = "yaw",
                              .unit = "degrees",
                              .min = -360,
                              .max = 360,
                              .help = "direction in which the camera looks: 0 is up in the texture, 90 to its right"});
    visit(self.fov_deg, Field{.name = "fov",
                              .unit = "degrees",
                              .min = 0.01,
                              .max = 170,
                              .help = "vertical field of view, from the picture's top to its bottom"});
    visit(self.supersample, Field{.name = "supersample",
                                  .unit = "samples",
                                  .min = 1,
                                  .max = 256,
                                  .help = "samples per pixel along each axis, taken from level 0 instead of filtering: "
                                          "slow; the ground truth by which filters are measured"});
  }
};

/// Throws Error(usage) for an option of one view beside the other.
void check_view(const ViewOptions& options, const WindowOptions& window);

/// The plane that the options show; origin, seed and filter are the window's. Throws Error(usage) where there is none.
Perspective perspective_of(const ViewOptions& options, const WindowOptions& window, PixelSize size, V2i tile_size);

}  // namespace texbake
