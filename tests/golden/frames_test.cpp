// The program still draws the golden frames, to the bit.
#include <gtest/gtest.h>

#include <bit>
#include <filesystem>

#include "cli/camera.h"
#include "formats/bundle_io.h"
#include "formats/drawn_bundle.h"
#include "formats/frame.h"
#include "formats/verify.h"
#include "tests/golden/golden_bundles.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

const fs::path& golden_folder() {
  static const fs::path folder = fs::path(TEXBAKE_SOURCE) / "tests/golden/bundles";
  return folder;
}

std::vector<fs::path> files_with(const std::string& extension) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(golden_folder()))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

TEST(GoldenFrames, AreDrawnToTheBit) {
  const std::vector<fs::path> cameras = files_with(".json");
  EXPECT_GT(cameras.size(), 40u);
  for (const fs::path& path : cameras) {
    const std::string stem = path.stem().string();
    const Bundle bundle = read_bundle(golden_folder() / (stem.substr(0, stem.find('-')) + ".texbundle"));
    const Camera camera = read_camera(path.string());
    const PixelSize size = camera.frame_size.value();
    const Drawing drawing(drawn_material(bundle), draw_request_of(camera.picture, size, bundle.scales.back().size()));
    const CapturedFrame frame = read_frame((golden_folder() / (stem + ".exr")).string(),
                                           picture_role(bundle, drawing.request().map), drawing.channels());
    ASSERT_EQ(frame.values.width(), size.width) << stem;
    ASSERT_EQ(frame.values.height(), size.height) << stem;
    const Image<V3f> drawn = drawing.rows(0, size.height);
    int differing = 0;
    for (size_t i = 0; i < drawn.size(); ++i)
      for (int c = 0; c < drawing.channels(); ++c)
        if (std::bit_cast<uint32_t>(drawn.data()[i][c]) != std::bit_cast<uint32_t>(frame.values.data()[i][c]))
          ++differing;
    EXPECT_EQ(differing, 0) << stem;
  }
}

TEST(GoldenBundles, AreTinyAndWhole) {
  std::vector<fs::path> bundles = files_with(".texbundle");
  EXPECT_GE(bundles.size(), 12u);
  for (const fs::path& path : bundles) {
    uintmax_t bytes = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(path)) bytes += entry.file_size();
    EXPECT_LE(bytes, 60u << 10) << path;
    for (const Issue& issue : verify_bundle(path)) EXPECT_NE(issue.kind().severity, Severity::error) << text(issue);
  }
}

}  // namespace
}  // namespace texbake
