#include "libbake/content/turned_impact.h"

#include <gtest/gtest.h>

#include "libbake/content/turned_search.h"
#include "libbake/draw/frame.h"
#include "libbake/planes/prepare.h"
#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

constexpr int kWidth = 60, kHeight = 44;

struct TurnedFixture {
  Image<uint8_t> classes = twin::random_classes(kWidth, kHeight, 6, 3);
  ClassDistances distances = class_distances(twin::random_colors(6, 3));
  V2i center{55, 4};  // the patch, a disc, lies across the corner of the tile
  V2i size{kWidth, kHeight};

  bool inside(V2i p) const { return shortest(p - center, size).length2() < 81; }
  std::vector<V2i> border() const {
    Image<uint32_t> idx(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) idx(x, y) = inside({x, y}) ? 0 : 1;
    return twin::dilated_border(idx, 0);
  }
  uint64_t error_sum(const Content& content) const {
    std::vector<V2i> offsets;
    for (const V2i& p : border()) offsets.push_back(shortest(p - center, size));
    return TurnedImpact(classes, distances, offsets, center).error_sum(content);
  }
};

TEST(TurnedImpact, OfAMoveIsThatOfTheExactSearch) {
  const TurnedFixture f;
  for (const V2i& t : {V2i(0, 0), V2i(1, 0), V2i(-17, 9), V2i(30, -22)})
    EXPECT_EQ(f.error_sum(make_content(t, 0, 1.0f)), twin::error_sum(f.classes, f.distances, f.border(), t));
}

TEST(TurnedImpact, EqualsTheObviousSumForEveryTurn) {
  const TurnedFixture f;
  for (const Content& turn : make_turns(8, 3, 0.5f)) {
    Content content = turn;
    content.translation = {12, -7};
    const auto source_of = [&](V2i p) { return f.center + source_offset(content, shortest(p - f.center, f.size)); };
    EXPECT_EQ(f.error_sum(content), twin::error_sum_of(f.classes, f.distances, f.border(), source_of));
  }
}

TEST(TurnedImpact, OneObjectMeasuresOneTurnAfterTheOther) {
  const TurnedFixture f;
  std::vector<V2i> offsets;
  for (const V2i& p : f.border()) offsets.push_back(shortest(p - f.center, f.size));
  TurnedImpact impact(f.classes, f.distances, offsets, f.center);
  for (const Content& turn : make_turns(4, 2, 0.5f)) EXPECT_EQ(impact.error_sum(turn), f.error_sum(turn));
}

TEST(TurnedImpact, IsWhatTheEvaluatorDraws) {
  // The patch, claimed to reach over the whole tile, drawn by the reference text: the texel that shows at each place.
  const TurnedFixture f;
  PatchMap patches;
  patches.partition = twin::partition(Image<uint32_t>(kWidth, kHeight), 1);
  patches.partition.centers[0] = f.center;
  patches.partition.areas_px = {kWidth * kHeight};
  patches.partition.owner = Image<OwnerOffset>(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const V2i repetition = V2i(x, y) - f.center - shortest(V2i(x, y) - f.center, f.size);
      patches.partition.owner(x, y) = {static_cast<int8_t>(repetition.x / kWidth),
                                       static_cast<int8_t>(repetition.y / kHeight)};
    }
  const Image<V3f> base(kWidth, kHeight);
  for (const Content& turn : make_turns(8, 4, 0.5f)) {
    ContentTable table{1, 1, {turn}};
    table.contents[0].translation = {-21, 13};
    EvaluatorInput input;
    input.base = base;
    input.patches = &patches;
    input.contents = &table;
    const EvaluatorPlanes planes = prepare(input);
    Window window;
    window.width = kWidth;
    window.height = kHeight;
    window.filter = Filter::nearest;
    const Frame frame = reference_frame(planes, window, planes.base);
    const auto source_of = [&](V2i p) {
      const PixelDecision& decision = frame.decisions(p.x, p.y);
      return V2i(static_cast<int>(decision.source_x), static_cast<int>(decision.source_y));
    };
    EXPECT_EQ(f.error_sum(table.contents[0]), twin::error_sum_of(f.classes, f.distances, f.border(), source_of))
        << turn.rotation_eighths << "/8, " << turn.scale;
  }
}

}  // namespace
}  // namespace texbake
