#include "libbake/segment/fragment_graph.h"

#include <gtest/gtest.h>

#include "libbake/color/luv.h"
#include "tests/libbake/segment/ascii.h"

namespace texbake {
namespace {

FragmentMap map_of(const std::string& text) {
  FragmentMap map;
  map.partition = unwrap(ascii_ids(text));
  for (int f = 0; f < map.partition.count(); ++f)
    map.fragments.push_back({0, linear_from_luv(V3f(10 + 10 * static_cast<float>(f), 0, 0))});
  return map;
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
  const auto graph = fragment_graph(map);
  std::vector<std::pair<uint32_t, uint32_t>> links;
  for (const auto& link : graph.links_of(0)) links.emplace_back(link.other, link.length_px);
  const std::vector<std::pair<uint32_t, uint32_t>> expected{{1, 2}, {3, 2}, {4, 2}, {12, 2}};
  EXPECT_EQ(links, expected);
}

TEST(FragmentGraph, LinksAreTheSameSeenFromBothSides) {
  const auto graph = fragment_graph(map_of("0011223 0011223 4455667 4455667 8899aab 8899aab ccddeef"));
  for (uint32_t f = 0; f < graph.count(); ++f)
    for (const auto& link : graph.links_of(f)) {
      bool found = false;
      for (const auto& back : graph.links_of(link.other))
        found = found || (back.other == f && back.length_px == link.length_px && back.delta_e == link.delta_e);
      EXPECT_TRUE(found) << f << " to " << link.other;
    }
}

TEST(FragmentGraph, TheColourDifferenceIsThatOfTheMeanColours) {
  const auto graph = fragment_graph(map_of("0011223 0011223 4455667 4455667 8899aab 8899aab ccddeef"));
  for (const auto& link : graph.links_of(0))
    EXPECT_NEAR(link.delta_e, 10 * static_cast<float>(link.other), 0.01);  // round trip through linear floats
}

TEST(FragmentGraph, BoxesReachAcrossTheBorder) {
  const auto map = map_of("3001122 7445566 7445566 b889aab bccddee bccddee 3001122");
  const auto graph = fragment_graph(map);
  EXPECT_EQ(graph.boxes[0], (TorusBox{V2i(1, 6), V2i(2, 2)}));
  EXPECT_EQ(graph.boxes[3], (TorusBox{V2i(0, 6), V2i(1, 2)}));
  EXPECT_EQ(graph.boxes[11], (TorusBox{V2i(6, 3), V2i(2, 3)}));
}

}  // namespace
}  // namespace texbake
