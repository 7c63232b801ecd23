#include "libbake/reference/stack_row_program.h"

#include <gtest/gtest.h>

#include "libbake/draw/stack_perspective.h"
#include "libbake/draw/stack_window.h"
#include "libbake/planes/stack_levels.h"
#include "tests/libbake/draw/small_stack.h"

namespace texbake {
namespace {

/// Three scales with soft borders, noise and turned contents, whose sides no power of two divides.
StackPlanes three_scales(TransferMode mode, DetailMean mean) {
  SmallStack stack;
  stack.add(random_scale({48, 32}, 3, Contents::turned, 1))
      .add(random_scale({32, 24}, 3, Contents::turned, 2), {.ratio = 4, .mode = mode, .detail_mean = mean})
      .add(random_scale({24, 32}, 3, Contents::turned, 3), {.ratio = 6, .mode = mode, .detail_mean = mean});
  for (ScaleTile& tile : stack.tiles) tile.tile.soft_border_px = 2;
  add_noise(stack.tiles.back().tile, 2, 16, 4);
  StackPlanes planes = stack.planes();
  return planes;
}

Image<V3f> colors_of(const Frame& frame) {
  Image<V3f> colors(frame.values.width(), frame.values.height());
  for (size_t i = 0; i < colors.size(); ++i) {
    const glsl::vec4& value = frame.values.data()[i];
    colors.data()[i] = {value.x, value.y, value.z};
  }
  return colors;
}

constexpr Filter kFilters[] = {Filter::nearest, Filter::bilinear, Filter::trilinear, Filter::anisotropic};

TEST(StackRowProgram, WhatIsRememberedInAViewIsWhatIsFoundAnew) {
  for (const TransferMode mode : {TransferMode::fragment, TransferMode::bilinear}) {
    const StackPlanes planes = three_scales(mode, DetailMean::local);
    for (const Filter filter : kFilters) {
      Perspective view;
      view.width = 60;
      view.height = 45;
      view.height_texels = 30;
      view.yaw_deg = 37;
      view.filter = filter;
      EXPECT_TRUE(render_stack_perspective_rows(planes, nullptr, view, 0, 45) ==
                  colors_of(stack_perspective_frame(planes, nullptr, view)))
          << enum_name(mode) << " " << enum_name(filter);
    }
  }
}

TEST(StackRowProgram, WhatIsRememberedInAWindowIsWhatIsFoundAnew) {
  const StackPlanes planes = three_scales(TransferMode::fragment, DetailMean::tile);
  for (const Filter filter : kFilters)
    for (const uint32_t step_256 : {100u, 256u, 700u, 1024u, 1700u, 9000u}) {
      Window window;
      window.origin_x = tile_offset(-7, 3, planes.sizes.back().x);
      window.width = window.height = 30;
      window.step_256 = step_256;
      window.filter = filter;
      const ScaleView view = scale_view(planes, window);
      EXPECT_TRUE(render_stack_rows(planes, window, 0, 30) == colors_of(reference_stack_frame(planes, window, view)))
          << enum_name(filter) << " " << step_256;
    }
}

}  // namespace
}  // namespace texbake
