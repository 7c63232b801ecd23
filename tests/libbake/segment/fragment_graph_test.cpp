#include "libbake/segment/fragment_graph.h"

#include <gtest/gtest.h>

#include "tests/libbake/segment/ascii.h"

namespace texbake {
namespace {

FragmentMap map_of(const std::string& text) {
  FragmentMap map;
  map.partition = unwrap(ascii_ids(text));
  map.fragments.resize(static_cast<size_t>(map.partition.count()));
  return map;
}

/// Every texel ten times as light as the number of its fragment.
Image<V3f> steps_of_ten(const FragmentMap& map) {
  Image<V3f> luv(map.partition.size().x, map.partition.size().y);
  for (size_t at = 0; at < luv.size(); ++at)
    luv.data()[at] = V3f(10 * static_cast<float>(map.partition.idx.data()[at]), 0, 0);
  return luv;
}

TEST(FragmentGraph, LinksCarryTheLengthOfTheSharedBorderAcrossTheBorderOfTheTile) {
  const auto map = map_of(
      "0011223 "
      "0011223 "
      "4455667 "
      "4455667 "
      "8899aab "
      "8899aab "
      "ccddeef");
  const auto graph = fragment_graph(map, steps_of_ten(map));
  std::vector<std::pair<uint32_t, uint32_t>> links;
  for (const auto& link : graph.links_of(0)) links.emplace_back(link.other, link.length_px);
  const std::vector<std::pair<uint32_t, uint32_t>> expected{{1, 2}, {3, 2}, {4, 2}, {12, 2}};
  EXPECT_EQ(links, expected);
}

TEST(FragmentGraph, LinksAreTheSameSeenFromBothSides) {
  const auto map = map_of("0011223 0011223 4455667 4455667 8899aab 8899aab ccddeef");
  const auto graph = fragment_graph(map, steps_of_ten(map));
  for (uint32_t f = 0; f < graph.count(); ++f)
    for (const auto& link : graph.links_of(f)) {
      bool found = false;
      for (const auto& back : graph.links_of(link.other))
        found = found || (back.other == f && back.length_px == link.length_px && back.delta_e == link.delta_e);
      EXPECT_TRUE(found) << f << " to " << link.other;
    }
}

TEST(FragmentGraph, TheColorDifferenceIsTheMeanStepAcrossTheBorder) {
  const auto map = map_of("0011223 0011223 4455667 4455667 8899aab 8899aab ccddeef");
  Image<V3f> luv = steps_of_ten(map);
  luv(0, 0) = V3f(50, 0, 0);  // of 0: beside 1 there is (1, 0), above 4 there is (0, 1); beyond the tile 3 and c
  const auto graph = fragment_graph(map, luv);
  std::vector<std::pair<uint32_t, float>> found;
  for (const auto& link : graph.links_of(0)) found.emplace_back(link.other, link.delta_e);
  const std::vector<std::pair<uint32_t, float>> expected{
      {1, 10.0f}, {3, (20 + 30) / 2.0f}, {4, 40.0f}, {12, (70 + 120) / 2.0f}};
  EXPECT_EQ(found, expected);
}

TEST(FragmentGraph, BoxesReachAcrossTheBorder) {
  const auto map = map_of("3001122 7445566 7445566 b889aab bccddee bccddee 3001122");
  const auto graph = fragment_graph(map, steps_of_ten(map));
  EXPECT_EQ(graph.boxes[0], (TorusBox{V2i(1, 6), V2i(2, 2)}));
  EXPECT_EQ(graph.boxes[3], (TorusBox{V2i(0, 6), V2i(1, 2)}));
  EXPECT_EQ(graph.boxes[11], (TorusBox{V2i(6, 3), V2i(2, 3)}));
}

}  // namespace
}  // namespace texbake
