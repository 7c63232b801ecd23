#include "formats/frame.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "formats/image_writer.h"
#include "libbake/base/error.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class Frame : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string at(const char* name) const { return (folder_ / name).string(); }
  /// One row of pixels of `channels` floats each.
  std::string write_exr(const std::vector<float>& samples, int channels, OIIO::TypeDesc type) const {
    const std::string path = at("frame.exr");
    const OIIO::ImageSpec spec(static_cast<int>(samples.size()) / channels, 1, channels, type);
    const auto output = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(output->open(path, spec) && output->write_image(OIIO::TypeDesc::FLOAT, samples.data()));
    output->close();
    return path;
  }
  fs::path folder_ = fs::temp_directory_path() / ("texbake_frame_test_" + std::to_string(getpid()));
};

TEST_F(Frame, ValuesThatNoMaterialHasAreKept) {
  const std::string path = write_exr({kNan, -2, 1e6f, kInfinity, 0, 0}, 3, OIIO::TypeDesc::FLOAT);
  const CapturedFrame frame = read_frame(path, PictureRole::color, 3);
  EXPECT_TRUE(std::isnan(frame.values(0, 0).x));
  EXPECT_EQ(frame.values(0, 0).y, -2);
  EXPECT_EQ(frame.values(0, 0).z, 1e6f);
  EXPECT_EQ(frame.values(1, 0).x, kInfinity);
  EXPECT_EQ(frame.scale.code, SampleCode::float32);
}

TEST_F(Frame, AlphaDividesNothing) {
  const std::string path = write_exr({0.5f, 0.25f, 1, 0.5f}, 4, OIIO::TypeDesc::HALF);
  const CapturedFrame frame = read_frame(path, PictureRole::color, 3);
  EXPECT_EQ(frame.values(0, 0), V3f(0.5f, 0.25f, 1));
  EXPECT_EQ(frame.scale.code, SampleCode::half);
}

TEST_F(Frame, AMapOfOneChannelIsTheFirstOfThePicture) {
  const std::string path = write_exr({0.5f, 0.25f, 1}, 3, OIIO::TypeDesc::FLOAT);
  EXPECT_EQ(read_frame(path, PictureRole::data, 1).values(0, 0), V3f(0.5f, 0, 0));
}

TEST_F(Frame, OneChannelIsTheFirstOfWhatWasWritten) {
  PictureWriter writer(at("g.exr"), {.width = 2, .height = 1, .channels = 1, .role = PictureRole::data});
  Image<V3f> rows(2, 1, V3f(0.25f, 1, 1));
  rows(1, 0).x = 0.5f;
  writer.write_rows(rows);
  writer.close();
  const CapturedFrame frame = read_frame(at("g.exr"), PictureRole::data, 1);
  EXPECT_EQ(frame.values(0, 0), V3f(0.25f, 0, 0));
  EXPECT_EQ(frame.values(1, 0), V3f(0.5f, 0, 0));
}

TEST_F(Frame, IntegersSayTheirCodes) {
  write_picture(at("a.png"), Image<V3f>(2, 2, V3f(0.25f)), PictureRole::color, SampleType::uint16);
  const CapturedFrame color = read_frame(at("a.png"), PictureRole::color, 3);
  EXPECT_EQ(color.scale.code, SampleCode::srgb);
  EXPECT_EQ(color.scale.bits, 16);
  EXPECT_EQ(sample_name(color.scale), "16-bit sRGB");
  write_picture(at("n.png"), Image<V3f>(2, 2, V3f(0, 0, 1)), PictureRole::normal, SampleType::uint8);
  const CapturedFrame normal = read_frame(at("n.png"), PictureRole::normal, 3);
  EXPECT_EQ(normal.scale.code, SampleCode::vector);
  EXPECT_EQ(normal.values(1, 1), V3f(0, 0, 1));
}

}  // namespace
}  // namespace texbake
