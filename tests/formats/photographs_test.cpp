// The real photographs, where they are at hand: TEXBAKE_TEXTURES names their folder, else ../shared/textures is tried.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "formats/image_reader.h"
#include "libbake/height/shading.h"
#include "libbake/tile/periodic.h"
#include "libbake/tile/resample.h"
#include "tests/libbake/height/known_height.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

fs::path texture_folder() {
  if (const char* named = std::getenv("TEXBAKE_TEXTURES")) return named;
  for (fs::path folder = fs::current_path(); folder != folder.root_path(); folder = folder.parent_path())
    if (fs::exists(folder / "shared/textures/README.md")) return folder / "shared/textures";
  return {};
}

class Photographs : public ::testing::Test {
 protected:
  void SetUp() override {
    if (folder_.empty()) GTEST_SKIP() << "no photographs: set TEXBAKE_TEXTURES to their folder";
  }
  Image<V3f> exemplar(const char* name) const {
    return interleave(read_picture({.path = (folder_ / name).string(), .role = PictureRole::color}).planes);
  }
  Image<float> height(const char* name) const {
    return std::move(read_picture({.path = (folder_ / name).string(), .role = PictureRole::data}).planes[0]);
  }
  fs::path folder_ = texture_folder();
};

TEST_F(Photographs, ThosePublishedAsSeamlessTile) {
  for (const char* name :
       {"brick_wall_1024.jpg", "mossy_cliff_1024.jpg", "autumn_leaves_1024.jpg", "wood_grain_1024.jpg",
        "gravel_1024.jpg", "grass_1024.jpg", "fabric_gingham_1024.jpg", "rusty_metal_1024.jpg", "sand_1024.jpg",
        "concrete_smooth_1024.jpg", "mossy_rock/albedo.jpg", "bark/albedo.png", "cracked_earth/albedo.jpg"}) {
    const SeamMeasure seam = measure_seam(exemplar(name));
    EXPECT_TRUE(seam.x.tiles()) << name << ": " << seam.x.ratio;
    EXPECT_TRUE(seam.y.tiles()) << name << ": " << seam.y.ratio;
  }
}

TEST_F(Photographs, APlainCropDoesNotTileUntilItIsClosed) {
  const Image<V3f> crop = exemplar("leaves_crop_512.png");
  const TilePlan plan = plan_tile(crop);
  EXPECT_FALSE(plan.before.x.tiles());
  EXPECT_FALSE(plan.before.y.tiles());
  EXPECT_TRUE(plan.after.tiles());
  EXPECT_EQ(plan.size(), V2i(448, 448));
  EXPECT_LT(plan.cut_ratio, 1.8);  // 3.4 and 2.6 across the straight wrap
}

TEST_F(Photographs, TenClicksRecoverTheHeightsOfCrackedEarth) {
  // A linear fit to half of all heights, by smoothed color, deviation and gradients, reaches 0.79. Twelve draws of ten
  // clicks reach 0.69 (tests/bench/height_bench.cpp), one draw between 0.6 and 0.75.
  const Image<float> truth = resample(height("cracked_earth/height.png"), 512, 512, Borders{});
  const Image<V3f> base = resample(exemplar("cracked_earth/albedo.jpg"), 512, 512, Borders{});
  double sum = 0;
  for (uint64_t seed = 1; seed <= 3; ++seed)
    sum += correlation(heightmap({}, base, twin::chosen_clicks(truth, 10, seed)).height_01, truth);
  EXPECT_GT(sum / 3, 0.6);
}

}  // namespace
}  // namespace texbake
