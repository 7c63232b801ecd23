#include "libbake/planes/prepare.h"

#include <gtest/gtest.h>

#include "libbake/base/error.h"
#include "tests/libbake/draw/small_tile.h"

namespace texbake {
namespace {

TEST(Prepare, TablesHoldWhatTheSemanticsSay) {
  SmallTile tile = random_tile({32, 24}, 2, Contents::moved, 31);
  tile.contents.contents[1] = turned_content({-3, -5}, 2, 0.5f);
  const EvaluatorPlanes planes = tile.planes();
  EXPECT_EQ(planes.contents(1, 0).x, 29 | 19 << 16) << "the translation is wrapped";
  EXPECT_EQ(planes.contents(1, 0).y, 32768);
  EXPECT_EQ(planes.contents(1, 0).z, 0);
  EXPECT_EQ(planes.contents(1, 0).w, -131072);
  EXPECT_EQ(planes.centers(3, 0).x, tile.patches.partition.centers[3].x);
  const OwnerOffset owner = tile.patches.partition.owner(31, 23);
  EXPECT_EQ(planes.patch_plane(31, 23).owner, (owner.x + 1) + 4 * (owner.y + 1));
}

TEST(Prepare, ATableThatDoesNotFitIsBadData) {
  const auto refuses = [](auto&& spoil) {
    SmallTile tile = random_tile({32, 24}, 3, Contents::moved, 32);
    spoil(tile);
    try {
      tile.planes();
      return false;
    } catch (const Error& error) {
      return error.kind() == ErrorKind::bad_data;
    }
  };
  EXPECT_FALSE(refuses([](SmallTile&) {}));
  EXPECT_TRUE(refuses([](SmallTile& t) { t.contents.contents.pop_back(); }));
  EXPECT_TRUE(refuses([](SmallTile& t) { t.contents.contents[1].a = 1 << 18; }));
  EXPECT_TRUE(refuses([](SmallTile& t) { t.contents.contents[1].scale = 0; }));
  EXPECT_TRUE(refuses([](SmallTile& t) { t.patches.partition.idx(3, 3) = 1000; }));
  EXPECT_TRUE(refuses([](SmallTile& t) { t.patches.partition.owner(3, 3).x = 2; }));
  EXPECT_TRUE(refuses([](SmallTile& t) { t.base = random_base({24, 32}, 1); }));
  EXPECT_TRUE(refuses([](SmallTile& t) { t.base = Image<V3f>(); }));
}

TEST(Prepare, MapsKeepTheirChannelsAndNormalsNeedThree) {
  const Image<V3f> base = random_base({8, 8}, 1);
  const Image<float> gray(8, 8, 0.25f), wrong(8, 4);
  EvaluatorInput input;
  input.base = base;
  input.maps.push_back({"roughness", MapKind::plain, {gray}});
  const EvaluatorPlanes planes = prepare(input);
  ASSERT_NE(planes.map("roughness"), nullptr);
  EXPECT_EQ(planes.map("roughness")->texels(7, 7), glsl::vec4(0.25f, 0, 0, 0));
  EXPECT_EQ(planes.map("normal"), nullptr);
  input.maps.push_back({"normal", MapKind::normal_opengl, {gray}});
  EXPECT_THROW(prepare(input), Error);
  input.maps.back() = {"height", MapKind::height, {wrong}};
  EXPECT_THROW(prepare(input), Error);
}

}  // namespace
}  // namespace texbake
