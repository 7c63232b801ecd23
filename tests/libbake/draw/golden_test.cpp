// The golden evaluation vectors on the processor.
#include "tests/golden/golden.h"

#include <gtest/gtest.h>

#include "libbake/draw/window_rows.h"
#include "libbake/reference/semantics.h"
#include "tests/golden/golden_stack.h"

namespace texbake {
namespace {

V3f color_at(const Frame& frame) {
  const glsl::vec4& value = frame.values(0, 0);
  return {value.x, value.y, value.z};
}

TEST(Golden, TheProcessorGivesEveryVector) {
  for (const char* name : kGoldenNames) {
    const Golden golden = read_golden(name);
    EXPECT_EQ(golden.semantics, kSemantics);
    EXPECT_EQ(golden.points.size(), 256u);
    for (const GoldenPoint& point : golden.points) {
      const Window nearest = point.window(Filter::nearest), bilinear = point.window(Filter::bilinear);
      const Frame frame = reference_frame(golden.planes, nearest, golden.planes.base);
      EXPECT_EQ(frame.decisions(0, 0), point.decision) << name;
      EXPECT_EQ(color_at(frame), point.nearest) << name;
      EXPECT_EQ(color_at(reference_frame(golden.planes, bilinear, golden.planes.base)), point.bilinear) << name;
      EXPECT_EQ(render_rows(golden.planes, bilinear, 0, 1)(0, 0), point.bilinear) << name;
      if (point.step_256 == 0) continue;
      const Window trilinear = point.trilinear_window(golden.planes.size);
      EXPECT_EQ(level_256_of(trilinear, golden.planes.level_count), point.level_256) << name;
      EXPECT_EQ(color_at(reference_frame(golden.planes, trilinear, golden.planes.base)), point.trilinear) << name;
    }
  }
}

TEST(Golden, TheProcessorGivesEveryVectorOfAStack) {
  for (const char* name : kGoldenStackNames) {
    const GoldenStack golden = read_golden_stack(name);
    const StackPlanes& planes = golden.planes;
    const int finest = planes.finest();
    EXPECT_EQ(golden.semantics, kSemantics);
    EXPECT_GT(golden.points.size(), 100u);
    for (const GoldenStackPoint& point : golden.points) {
      const Window nearest = point.near.window(Filter::nearest), bilinear = point.near.window(Filter::bilinear);
      const Frame frame = reference_stack_frame(planes, nearest, point.view(finest));
      EXPECT_EQ(frame.decisions(0, 0), point.near.decision) << name;
      EXPECT_EQ(color_at(frame), point.near.nearest) << name;
      EXPECT_EQ(color_at(reference_stack_frame(planes, bilinear, point.view(finest))), point.near.bilinear) << name;
      EXPECT_EQ(color_at(reference_stack_frame(planes, bilinear, point.faded_view(finest))), point.faded) << name;
      EXPECT_EQ(color_at(reference_stack_frame(planes, bilinear, point.leveled_view(finest))), point.near.trilinear)
          << name;
      if (!golden.relief) continue;
      const Frame lit = relief_frame(planes, *golden.relief, point.viewer, bilinear, point.view(finest));
      EXPECT_EQ(lit.decisions(0, 0), point.relief_decision(finest)) << name;
      EXPECT_EQ(color_at(lit), point.lit) << name;
    }
  }
}

}  // namespace
}  // namespace texbake
