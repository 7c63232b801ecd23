#include "libbake/height/nearest_clicks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libbake/base/random.h"
#include "libbake/height/descriptor.h"

namespace texbake {
namespace {

constexpr DescriptorSpace kSpace = {std::tuple_size_v<Descriptor>, descriptor_distance};

std::vector<float> random_descriptors(Random& random, size_t count) {
  std::vector<float> descriptors(count * kSpace.length);
  for (float& value : descriptors) value = random.uniform();
  return descriptors;
}

TEST(NearestClicks, EqualTheSlowSearchOverAllTurns) {
  constexpr size_t kClicks = 12;
  constexpr size_t kTurns = 3;
  Random random(5);
  const std::vector<float> descriptors = random_descriptors(random, kClicks * kTurns);
  const NearestClicks search(kSpace, descriptors, kTurns);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<float> query = random_descriptors(random, 1);
    std::vector<NearClick> expected;
    for (size_t click = 0; click < kClicks; ++click) {
      float least = INFINITY;
      for (size_t turn = 0; turn < kTurns; ++turn)
        least =
            std::min(least, descriptor_distance(query.data(), &descriptors[(click * kTurns + turn) * kSpace.length]));
      expected.push_back({static_cast<int>(click), least});
    }
    std::ranges::stable_sort(expected, {}, &NearClick::distance);
    for (const int count : {1, 3, 8, 20}) {
      const std::vector<NearClick> found = search.nearest(query.data(), count);
      ASSERT_EQ(found.size(), std::min(static_cast<size_t>(count), kClicks));
      for (size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].click, expected[i].click);
        EXPECT_EQ(found[i].distance, expected[i].distance);
      }
    }
  }
}

TEST(NearestClicks, FewerClicksThanAskedForGiveWhatThereIs) {
  Random random(6);
  const NearestClicks search(kSpace, random_descriptors(random, 2), 2);
  EXPECT_EQ(search.nearest(random_descriptors(random, 1).data(), 3).size(), 1u);
}

}  // namespace
}  // namespace texbake
