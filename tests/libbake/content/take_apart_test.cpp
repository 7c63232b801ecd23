#include "libbake/content/take_apart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libbake/base/random.h"

namespace texbake {
namespace {

struct Item {
  V2i translation;
  uint32_t error;
};

// Sorts everything, and compares with everything taken before.
std::vector<uint32_t> obvious(const std::vector<Item>& items, V2i size, int separation_px) {
  std::vector<uint32_t> order(items.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](uint32_t i) { return items[i].error; });
  std::vector<uint32_t> taken;
  for (const uint32_t i : order)
    if (std::ranges::all_of(taken, [&](uint32_t j) {
          return far_enough(items[i].translation, items[j].translation, size, separation_px);
        }))
      taken.push_back(i);
  return taken;
}

std::vector<uint32_t> taken_apart(const std::vector<Item>& items, V2i size, int separation_px) {
  const auto translation_of = [&](uint32_t i) { return items[i].translation; };
  const auto before = [&](uint32_t i, uint32_t j) {
    return items[i].error != items[j].error ? items[i].error < items[j].error : i < j;
  };
  TakeApart left(static_cast<uint32_t>(items.size()), size, separation_px, translation_of, before);
  std::vector<uint32_t> taken;
  for (uint32_t best = left.take(); best != left.kNone; best = left.take()) taken.push_back(best);
  return taken;
}

TEST(TakeApart, TakesWhatSortingAllOfThemTakes) {
  Random random(1);
  for (const V2i& size : {V2i(1, 1), V2i(7, 3), V2i(64, 64), V2i(200, 31), V2i(130, 257)})
    for (const int separation_px : {1, 2, 5, 16, 40, 300}) {
      std::vector<Item> items;
      for (int i = 0; i < 600; ++i)  // some of them at one place, and many with equal errors
        items.push_back({V2i(static_cast<int>(random.below(static_cast<uint32_t>(size.x))),
                             static_cast<int>(random.below(static_cast<uint32_t>(size.y)))),
                         random.below(50)});
      EXPECT_EQ(taken_apart(items, size, separation_px), obvious(items, size, separation_px))
          << size.x << " x " << size.y << ", " << separation_px;
    }
}

TEST(TakeApart, LeavesOutWhatIsNearAcrossTheBorders) {
  const std::vector<Item> items = {{{95, 63}, 1}, {{0, 8}, 2}, {{8, 0}, 3}, {{7, 7}, 4}, {{88, 0}, 5}};
  const auto translation_of = [&](uint32_t i) { return items[i].translation; };
  const auto before = [&](uint32_t i, uint32_t j) { return items[i].error < items[j].error; };
  TakeApart left(5, {96, 64}, 8, translation_of, before);
  left.leave_out({0, 0});
  EXPECT_EQ(left.take(), 1u);
  EXPECT_EQ(left.take(), 2u);
  EXPECT_EQ(left.take(), 4u);
  EXPECT_EQ(left.take(), left.kNone);
}

}  // namespace
}  // namespace texbake
