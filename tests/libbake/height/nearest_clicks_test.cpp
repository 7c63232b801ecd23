#include "libbake/height/nearest_clicks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "libbake/base/random.h"

namespace texbake {
namespace {

Descriptor random_descriptor(Random& random) {
  Descriptor descriptor;
  for (float& value : descriptor) value = random.uniform();
  return descriptor;
}

TEST(NearestClicks, EqualTheSlowSearchOverAllTurns) {
  Random random(5);
  std::vector<Descriptor> descriptors;
  std::vector<int> click_of;
  for (int click = 0; click < 12; ++click)
    for (int turn = 0; turn < 3; ++turn) {
      descriptors.push_back(random_descriptor(random));
      click_of.push_back(click);
    }
  const NearestClicks search(descriptors, click_of);
  for (int trial = 0; trial < 50; ++trial) {
    const Descriptor query = random_descriptor(random);
    std::vector<NearClick> expected;
    for (int click = 0; click < 12; ++click) {
      float least = INFINITY;
      for (size_t i = 0; i < descriptors.size(); ++i)
        if (click_of[i] == click) least = std::min(least, descriptor_distance(query.data(), descriptors[i].data()));
      expected.push_back({click, least});
    }
    std::stable_sort(expected.begin(), expected.end(),
                     [](const NearClick& a, const NearClick& b) { return a.distance < b.distance; });
    const std::vector<NearClick> found = search.nearest(query);
    ASSERT_EQ(found.size(), 3u);
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(found[i].click, expected[i].click);
      EXPECT_EQ(found[i].distance, expected[i].distance);
    }
  }
}

TEST(NearestClicks, FewerThanThreeClicksGiveWhatThereIs) {
  Random random(6);
  const NearestClicks search({random_descriptor(random), random_descriptor(random)}, {0, 0});
  EXPECT_EQ(search.nearest(random_descriptor(random)).size(), 1u);
}

}  // namespace
}  // namespace texbake
