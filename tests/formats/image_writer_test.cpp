#include "formats/image_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "libbake/base/error.h"
#include "libbake/base/half.h"
#include "tests/formats/picture_fixtures.h"

namespace texbake {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

// Colors over the whole range, 0 and 1 among them.
Image<V3f> ramp(int width, int height) {
  Image<V3f> image(width, height);
  for (size_t i = 0; i < image.size(); ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(image.size() - 1);
    image.data()[i] = {t, t * t, 1 - t};
  }
  return image;
}

Image<V3f> read_back(const std::string& path, PictureRole role = PictureRole::color) {
  return interleave(read_picture({.path = path, .role = role}).planes);
}

float largest_difference(const Image<V3f>& a, const Image<V3f>& b) {
  float largest = 0;
  for (size_t i = 0; i < a.size(); ++i)
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a.data()[i][c] - b.data()[i][c]));
  return largest;
}

class ImageWriter : public ::testing::Test {
 protected:
  PictureFolder folder_;
};

TEST_F(ImageWriter, APictureGivenUpBeforeItsFirstRowLeavesNothingAndSaysNothing) {
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg"}) {
    testing::internal::CaptureStderr();
    { const PictureWriter writer(folder_ / name, {.width = 4, .height = 4}); }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << name;
    EXPECT_EQ(folder_.file_count(), 0u) << name;
  }
}

TEST_F(ImageWriter, ColorComesBackWithinHalfACode) {
  const Image<V3f> image = ramp(64, 100);
  write_picture(folder_ / "8.png", image, PictureRole::color);
  write_picture(folder_ / "16.png", image, PictureRole::color, SampleType::uint16);
  write_picture(folder_ / "16.tif", image, PictureRole::color, SampleType::uint16);
  // the curve's steepest slope to linear light is 2.4 / 1.055 = 2.275, at white
  EXPECT_LE(largest_difference(read_back(folder_ / "8.png"), image), 2.275f * 0.5f / 255);
  EXPECT_LE(largest_difference(read_back(folder_ / "16.png"), image), 2.275f * 0.51f / 65535);
  EXPECT_LE(largest_difference(read_back(folder_ / "16.tif"), image), 2.275f * 0.51f / 65535);
}

TEST_F(ImageWriter, FloatsComeBackExactlyAndHalvesRounded) {
  const Image<V3f> image = ramp(33, 20);
  write_picture(folder_ / "f.exr", image, PictureRole::color, SampleType::float32);
  write_picture(folder_ / "f.tif", image, PictureRole::color, SampleType::float32);
  write_picture(folder_ / "h.exr", image, PictureRole::color);
  EXPECT_EQ(read_back(folder_ / "f.exr"), image);
  EXPECT_EQ(read_back(folder_ / "f.tif"), image);
  const Image<V3f> halves = read_back(folder_ / "h.exr");
  for (size_t i = 0; i < image.size(); ++i) ASSERT_EQ(halves.data()[i], half_exact(image.data()[i]));
}

TEST_F(ImageWriter, JpegIsCloseToTheColor) {
  const Image<V3f> image(32, 32, V3f(0.25f, 0.5f, 0.125f));
  write_picture(folder_ / "a.jpg", image, PictureRole::color);
  EXPECT_LE(largest_difference(read_back(folder_ / "a.jpg"), image), 0.02f);  // two codes of chroma rounding
}

TEST_F(ImageWriter, DataHasNoCurve) {
  Image<float> image(3, 1);
  image(1, 0) = 0.2f;
  image(2, 0) = 1;
  write_picture(folder_ / "a.png", image, PictureRole::data);
  const Picture eight = read_picture({.path = folder_ / "a.png", .role = PictureRole::data});
  EXPECT_EQ(eight.planes[0], image);
  EXPECT_EQ(eight.channels, 1);
  write_picture(folder_ / "a.exr", image, PictureRole::data, SampleType::float32);
  EXPECT_EQ(read_picture({.path = folder_ / "a.exr", .role = PictureRole::data}).planes[0], image);
}

TEST_F(ImageWriter, NormalsComeBackAndUpIsExact) {
  Image<V3f> image(2, 1);
  image(0, 0) = {0, 0, 1};
  image(1, 0) = {-0.6f, 0.8f, 0};
  for (const char* name : {"n.png", "n.exr"}) {
    write_picture(folder_ / name, image, PictureRole::normal);
    const Image<V3f> back = read_back(folder_ / name, PictureRole::normal);
    EXPECT_EQ(back(0, 0), V3f(0, 0, 1));
    EXPECT_LE(largest_difference(back, image), 0.5f / 127);
  }
}

TEST_F(ImageWriter, RowsMayComeInAnyPortions) {
  const Image<V3f> image = ramp(40, 150);
  for (const char* name : {"p.png", "p.exr", "p.tif", "p.jpg"}) {
    write_picture(folder_ / name, image, PictureRole::color);
    const std::string whole = read_bytes(folder_ / name);
    PictureWriter writer(folder_ / name, {.width = 40, .height = 150});
    for (int y = 0; y < 150;) {
      const int rows = std::min(1 + y % 7 * 20, 150 - y);
      writer.write_rows(ImageView<const V3f>(image.row(y), 40, rows));
      y += rows;
    }
    writer.close();
    EXPECT_EQ(read_bytes(folder_ / name), whole) << name;
  }
}

TEST_F(ImageWriter, FilesHoldNothingButThePicture) {
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg"}) {
    write_picture(folder_ / name, ramp(16, 16), PictureRole::color);
    EXPECT_THAT(read_bytes(folder_ / name), AllOf(Not(HasSubstr("OpenImageIO")), Not(HasSubstr("Software")),
                                                  Not(ContainsRegex("[0-9][0-9]:[0-9][0-9]:[0-9][0-9]")),
                                                  Not(HasSubstr("tIME")), Not(HasSubstr(folder_ / name))))
        << name;
  }
}

TEST_F(ImageWriter, NameAppearsInCloseAndNothingElseStays) {
  const Image<V3f> image = ramp(16, 16);
  write_bytes(folder_ / "a.png", "old");
  PictureWriter writer(folder_ / "a.png", {.width = 16, .height = 16});
  writer.write_rows(image);
  EXPECT_EQ(read_bytes(folder_ / "a.png"), "old");
  writer.close();
  EXPECT_EQ(read_back(folder_ / "a.png").width(), 16);
  EXPECT_EQ(folder_.file_count(), 1u);
}

TEST_F(ImageWriter, AbandonedWriterLeavesTheOldFileAlone) {
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg"}) {
    write_bytes(folder_ / name, "old");
    {
      PictureWriter writer(folder_ / name, {.width = 16, .height = 16});
      writer.write_rows(ramp(16, 5));
    }
    EXPECT_EQ(read_bytes(folder_ / name), "old") << name;
  }
  EXPECT_EQ(folder_.file_count(), 4u);
}

// A limit on the size of files stands for a full disk: the same calls fail.
TEST_F(ImageWriter, FullDiskIsAnIoErrorAndLeavesNothing) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  Image<V3f> noise(512, 512);
  uint32_t state = 1;
  for (V3f& texel : noise)
    for (int c = 0; c < 3; ++c) texel[c] = static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) * 0x1p-24f;
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg"}) {
    const rlimit small{20000, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const Refusal found = refusal([&] { write_picture(folder_ / name, noise, PictureRole::color); });
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_EQ(found.kind, ErrorKind::io) << name;
    EXPECT_THAT(found.words, AllOf(HasSubstr(folder_ / name), HasSubstr("File too large")));
    EXPECT_EQ(folder_.file_count(), 0u) << name;
  }
}

TEST_F(ImageWriter, UnwritablePlacesAreIoErrors) {
  std::filesystem::create_directory(folder_ / "d.png");
  for (const std::string& path : {folder_ / "missing/a.png", folder_ / "d.png", std::string("/dev/null/a.png")}) {
    const Refusal found = refusal([&] { write_picture(path, ramp(4, 4), PictureRole::color); });
    EXPECT_EQ(found.kind, ErrorKind::io) << path;
    EXPECT_THAT(found.words, HasSubstr(path));
  }
}

TEST_F(ImageWriter, LinkIsWrittenThrough) {
  write_bytes(folder_ / "target.png", "old");
  std::filesystem::create_symlink(folder_ / "target.png", folder_ / "link.png");
  write_picture(folder_ / "link.png", ramp(4, 4), PictureRole::color);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.png"));
  EXPECT_EQ(read_back(folder_ / "target.png").width(), 4);
}

TEST_F(ImageWriter, UnknownNamesAndDepthsAreUsageErrors) {
  for (const char* name : {"a", "a.gif", "a.png.zip"}) {
    const Refusal found = refusal([&] { check_picture_name(folder_ / name); });
    EXPECT_EQ(found.kind, ErrorKind::usage) << name;
    EXPECT_THAT(found.words, HasSubstr(".png, .exr, .tif or .jpg"));
  }
  const Refusal found = refusal([&] { check_picture_name("a.png", SampleType::half); });
  EXPECT_EQ(found.kind, ErrorKind::usage);
  EXPECT_THAT(found.words, HasSubstr("expected 8 or 16 bits for .png, found half"));
  EXPECT_EQ(refusal([&] { check_picture_name("a.PNG", SampleType::uint16); }).kind, std::nullopt);
}

}  // namespace
}  // namespace texbake
