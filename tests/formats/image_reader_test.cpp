#include "formats/image_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <limits>

#include "libbake/base/error.h"
#include "libbake/color/luv.h"
#include "tests/formats/picture_fixtures.h"

namespace texbake {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

Refusal reading_refusal(const std::string& path, PictureRole role = PictureRole::color) {
  return refusal([&] { read_picture({.path = path, .role = role}); });
}

std::vector<float> row_values(const Image<float>& plane, int y) { return {plane.row(y), plane.row(y) + plane.width()}; }

Picture read_color(const std::string& path, InputSpace space = InputSpace::automatic) {
  return read_picture({.path = path, .space = space, .role = PictureRole::color});
}

OIIO::ImageSpec spec_of(int width, int height, int channels, OIIO::TypeDesc type) {
  return {width, height, channels, type};
}

class ImageReader : public ::testing::Test {
 protected:
  PictureFolder folder_;
};

TEST_F(ImageReader, EightBitColorIsDecodedByTheExactSrgbCurve) {
  const std::string path = folder_ / "a.png";
  std::vector<uint8_t> samples;
  for (int code = 0; code < 256; ++code) samples.insert(samples.end(), {static_cast<uint8_t>(code), 7, 200});
  save_picture(path, spec_of(256, 1, 3, OIIO::TypeDesc::UINT8), samples);
  const Picture picture = read_color(path);
  ASSERT_EQ(picture.channels, 3);
  for (int code = 0; code < 256; ++code) {
    EXPECT_EQ(picture.planes[0](code, 0), linear_from_srgb(static_cast<float>(code) / 255.0f));
    EXPECT_EQ(picture.planes[1](code, 0), linear_from_srgb(7 / 255.0f));
    EXPECT_EQ(picture.planes[2](code, 0), linear_from_srgb(200 / 255.0f));
  }
  EXPECT_EQ(picture.source_bits, 8);
  EXPECT_FALSE(picture.is_float);
  EXPECT_EQ(picture.space, "srgb");
  EXPECT_EQ(picture.name, "a.png");
  EXPECT_EQ(picture.size_bytes, std::filesystem::file_size(path));
  EXPECT_EQ(picture.sha256.size(), 64u);
  EXPECT_THAT(picture.notes, IsEmpty());
}

TEST_F(ImageReader, SixteenBitColorKeepsItsPrecision) {
  save_picture(folder_ / "a.png", spec_of(3, 1, 3, OIIO::TypeDesc::UINT16),
               std::vector<uint16_t>{0, 1, 256, 257, 32768, 32769, 65279, 65534, 65535});
  const Picture picture = read_color(folder_ / "a.png");
  EXPECT_EQ(picture.source_bits, 16);
  EXPECT_EQ(picture.planes[1](0, 0), linear_from_srgb(1 / 65535.0f));
  EXPECT_EQ(picture.planes[0](1, 0), linear_from_srgb(257 / 65535.0f));
  EXPECT_EQ(picture.planes[2](1, 0), linear_from_srgb(32769 / 65535.0f));
  EXPECT_EQ(picture.planes[2](2, 0), 1.0f);
}

TEST_F(ImageReader, ThirtyTwoBitIntegersAreSrgb) {
  save_picture(folder_ / "a.tif", spec_of(1, 1, 3, OIIO::TypeDesc::UINT32),
               std::vector<uint32_t>{0, 1u << 31, 0xFFFFFFFFu});
  const Picture picture = read_color(folder_ / "a.tif");
  EXPECT_EQ(picture.source_bits, 32);
  EXPECT_FALSE(picture.is_float);
  EXPECT_NEAR(picture.planes[1](0, 0), linear_from_srgb(0.5f), 1e-6f);  // a few float steps
  EXPECT_EQ(picture.planes[2](0, 0), 1.0f);
}

TEST_F(ImageReader, FloatsAreLinearUnlessToldOtherwise) {
  const std::vector<float> samples = {0.25f, 0.5f, 8.0f};
  save_picture(folder_ / "a.exr", spec_of(1, 1, 3, OIIO::TypeDesc::HALF), samples);
  save_picture(folder_ / "a.tif", spec_of(1, 1, 3, OIIO::TypeDesc::FLOAT), samples);
  for (const char* name : {"a.exr", "a.tif"}) {
    const Picture picture = read_color(folder_ / name);
    EXPECT_TRUE(picture.is_float);
    EXPECT_EQ(picture.space, "linear");
    EXPECT_EQ(picture.planes[0](0, 0), 0.25f);
    EXPECT_EQ(picture.planes[2](0, 0), 8.0f);
    EXPECT_EQ(read_color(folder_ / name, InputSpace::srgb).planes[1](0, 0), linear_from_srgb(0.5f));
  }
  EXPECT_EQ(read_color(folder_ / "a.exr").source_bits, 16);
  EXPECT_EQ(read_color(folder_ / "a.tif").source_bits, 32);
}

TEST_F(ImageReader, InputSpaceLinearLeavesIntegersUncurved) {
  save_picture(folder_ / "a.png", spec_of(1, 1, 3, OIIO::TypeDesc::UINT8), std::vector<uint8_t>{51, 102, 255});
  const Picture picture = read_color(folder_ / "a.png", InputSpace::linear);
  EXPECT_EQ(picture.planes[0](0, 0), 51 / 255.0f);
  EXPECT_EQ(picture.space, "linear");
}

TEST_F(ImageReader, GammaOfThePngIsFollowed) {
  const auto with_gamma = [&](uint32_t gamma) {
    PngParts parts{.width = 1, .height = 1, .bit_depth = 8, .color_type = 0};
    parts.extra_chunks = png_chunk("gAMA", big_endian(gamma));
    parts.rows = {"\x80"};
    write_bytes(folder_ / "g.png", png_bytes(parts));
    return read_color(folder_ / "g.png");
  };
  EXPECT_EQ(with_gamma(100000).planes[0](0, 0), 128 / 255.0f);
  EXPECT_EQ(with_gamma(45455).planes[0](0, 0), linear_from_srgb(128 / 255.0f));
  // OpenImageIO keeps the exponent as a float: 1 / 0.55556
  EXPECT_NEAR(with_gamma(55556).planes[0](0, 0), std::pow(128 / 255.0, 1.8), 1e-5);
}

TEST_F(ImageReader, GrayIsPromotedForColorAndKeptForData) {
  save_picture(folder_ / "a.png", spec_of(2, 1, 1, OIIO::TypeDesc::UINT8), std::vector<uint8_t>{51, 255});
  const Picture color = read_color(folder_ / "a.png");
  ASSERT_EQ(color.channels, 3);
  for (const Image<float>& plane : color.planes) EXPECT_EQ(plane(0, 0), linear_from_srgb(0.2f));
  const Picture data = read_picture({.path = folder_ / "a.png", .space = InputSpace::srgb, .role = PictureRole::data});
  ASSERT_EQ(data.channels, 1);
  EXPECT_EQ(data.planes[0](0, 0), 0.2f);
  EXPECT_EQ(data.space, "linear");
}

TEST_F(ImageReader, DataOfThreeEqualChannelsIsOneChannel) {
  save_picture(folder_ / "a.png", spec_of(2, 1, 3, OIIO::TypeDesc::UINT8), std::vector<uint8_t>{9, 9, 9, 51, 51, 51});
  save_picture(folder_ / "b.png", spec_of(2, 1, 3, OIIO::TypeDesc::UINT8), std::vector<uint8_t>{9, 9, 9, 51, 51, 52});
  const Picture one = read_picture({.path = folder_ / "a.png", .role = PictureRole::data});
  EXPECT_EQ(one.channels, 1);
  EXPECT_EQ(one.planes[0](1, 0), 0.2f);
  EXPECT_THAT(one.notes, ElementsAre(HasSubstr("three channels are equal")));
  EXPECT_EQ(read_picture({.path = folder_ / "b.png", .role = PictureRole::data}).channels, 3);
}

TEST_F(ImageReader, FlatIntegerNormalIsExactlyUp) {
  save_picture(folder_ / "a.png", spec_of(2, 1, 3, OIIO::TypeDesc::UINT8),
               std::vector<uint8_t>{128, 128, 255, 0, 1, 2});
  save_picture(folder_ / "b.png", spec_of(1, 1, 3, OIIO::TypeDesc::UINT16), std::vector<uint16_t>{32768, 0, 65535});
  const Picture eight = read_picture({.path = folder_ / "a.png", .role = PictureRole::normal});
  EXPECT_EQ(eight.planes[0](0, 0), 0.0f);
  EXPECT_EQ(eight.planes[1](0, 0), 0.0f);
  EXPECT_EQ(eight.planes[2](0, 0), 1.0f);
  EXPECT_EQ(eight.planes[0](1, 0), -1.0f);
  EXPECT_EQ(eight.planes[1](1, 0), -1.0f);
  EXPECT_EQ(eight.planes[2](1, 0), -126 / 127.0f);
  const Picture sixteen = read_picture({.path = folder_ / "b.png", .role = PictureRole::normal});
  EXPECT_EQ(sixteen.planes[0](0, 0), 0.0f);
  EXPECT_EQ(sixteen.planes[1](0, 0), -1.0f);
  EXPECT_EQ(sixteen.planes[2](0, 0), 1.0f);
}

TEST_F(ImageReader, FloatNormalsAreVectorsWhereOneIsNegativeElseUnit) {
  save_picture(folder_ / "v.exr", spec_of(1, 1, 3, OIIO::TypeDesc::FLOAT), std::vector<float>{-0.5f, 0.25f, 1.0f});
  save_picture(folder_ / "u.exr", spec_of(1, 1, 3, OIIO::TypeDesc::FLOAT), std::vector<float>{0.5f, 0.25f, 1.0f});
  const Picture vectors = read_picture({.path = folder_ / "v.exr", .role = PictureRole::normal});
  EXPECT_EQ(vectors.planes[0](0, 0), -0.5f);
  EXPECT_EQ(vectors.planes[1](0, 0), 0.25f);
  const Picture units = read_picture({.path = folder_ / "u.exr", .role = PictureRole::normal});
  EXPECT_EQ(units.planes[0](0, 0), 0.0f);
  EXPECT_EQ(units.planes[1](0, 0), -0.5f);
  EXPECT_THAT(units.notes, ElementsAre(HasSubstr("0 to 1"), HasSubstr("not of unit length")));
}

TEST_F(ImageReader, AlphaIsDroppedAndUnassociatedColorKept) {
  save_picture(folder_ / "opaque.png", spec_of(1, 1, 4, OIIO::TypeDesc::UINT8), std::vector<uint8_t>{10, 20, 30, 255});
  PngParts parts{.width = 2, .height = 1, .bit_depth = 8, .color_type = 6};
  parts.rows = {std::string("\x0a\x14\x1e\x80\xc8\x64\x32\x00", 8)};
  write_bytes(folder_ / "clear.png", png_bytes(parts));
  const Picture opaque = read_color(folder_ / "opaque.png");
  EXPECT_TRUE(opaque.alpha_dropped);
  EXPECT_THAT(opaque.notes, IsEmpty());
  const Picture clear = read_color(folder_ / "clear.png");
  EXPECT_EQ(clear.channels, 3);
  EXPECT_EQ(clear.planes[0](0, 0), linear_from_srgb(10 / 255.0f));
  EXPECT_EQ(clear.planes[0](1, 0), linear_from_srgb(200 / 255.0f));
  EXPECT_THAT(clear.notes, ElementsAre(AllOf(HasSubstr("alpha was dropped"), HasSubstr("2 of 2 texels"))));
}

TEST_F(ImageReader, PremultipliedColorIsDividedByItsAlpha) {
  save_picture(folder_ / "a.exr", spec_of(2, 1, 4, OIIO::TypeDesc::FLOAT),
               std::vector<float>{0.25f, 0.5f, 0.125f, 0.5f, 3.0f, 2.0f, 1.0f, 0.0f});
  const Picture picture = read_color(folder_ / "a.exr");
  EXPECT_EQ(picture.planes[0](0, 0), 0.5f);
  EXPECT_EQ(picture.planes[1](0, 0), 1.0f);
  EXPECT_EQ(picture.planes[0](1, 0), 3.0f);  // nothing to divide by: light without opacity
}

TEST_F(ImageReader, GrayWithAlphaIsGray) {
  PngParts parts{.width = 2, .height = 1, .bit_depth = 8, .color_type = 4};
  parts.rows = {"\x33\xff\xff\xff"};
  write_bytes(folder_ / "a.png", png_bytes(parts));
  const Picture picture = read_picture({.path = folder_ / "a.png", .role = PictureRole::data});
  EXPECT_EQ(picture.channels, 1);
  EXPECT_THAT(row_values(picture.planes[0], 0), ElementsAre(0.2f, 1.0f));
}

TEST_F(ImageReader, PalettesAreExpanded) {
  for (const int depth : {1, 2, 4, 8}) {
    PngParts parts{.width = 2, .height = 1, .bit_depth = static_cast<uint8_t>(depth), .color_type = 3};
    parts.extra_chunks = png_chunk("PLTE", std::string("\x0a\x14\x1e\xff\x80\x00", 6));
    // texels 1, 0, packed from the high bit
    parts.rows = {depth == 8 ? std::string("\x01\x00", 2) : std::string(1, static_cast<char>(1 << (8 - depth)))};
    write_bytes(folder_ / "p.png", png_bytes(parts));
    const Picture picture = read_color(folder_ / "p.png");
    ASSERT_EQ(picture.channels, 3);
    EXPECT_EQ(picture.planes[0](0, 0), 1.0f) << depth;
    EXPECT_EQ(picture.planes[1](0, 0), linear_from_srgb(128 / 255.0f)) << depth;
    EXPECT_EQ(picture.planes[2](1, 0), linear_from_srgb(30 / 255.0f)) << depth;
  }
}

TEST_F(ImageReader, FewBitsOfGraySpanZeroToOne) {
  for (const int depth : {1, 2, 4}) {
    PngParts parts{.width = 2, .height = 1, .bit_depth = static_cast<uint8_t>(depth), .color_type = 0};
    parts.rows = {std::string(1, static_cast<char>(((1 << depth) - 1) << (8 - depth)))};  // highest, lowest
    write_bytes(folder_ / "g.png", png_bytes(parts));
    const Picture picture = read_picture({.path = folder_ / "g.png", .role = PictureRole::data});
    EXPECT_THAT(row_values(picture.planes[0], 0), ElementsAre(1.0f, 0.0f)) << depth;
  }
  write_bytes(folder_ / "b.pbm", "P1\n2 1\n1 0\n");  // 1 is black
  EXPECT_THAT(row_values(read_picture({.path = folder_ / "b.pbm", .role = PictureRole::data}).planes[0], 0),
              ElementsAre(0.0f, 1.0f));
}

// EXIF 2.3: where row 0 and column 0 of the file are in the upright picture. The file is
//   1 2 3
//   4 5 6
TEST_F(ImageReader, EveryExifOrientationBecomesUpright) {
  using Rows = std::vector<std::vector<int>>;
  const Rows upright[9] = {{},
                           {{1, 2, 3}, {4, 5, 6}},
                           {{3, 2, 1}, {6, 5, 4}},
                           {{6, 5, 4}, {3, 2, 1}},
                           {{4, 5, 6}, {1, 2, 3}},
                           {{1, 4}, {2, 5}, {3, 6}},
                           {{4, 1}, {5, 2}, {6, 3}},
                           {{6, 3}, {5, 2}, {4, 1}},
                           {{3, 6}, {2, 5}, {1, 4}}};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    OIIO::ImageSpec spec = spec_of(3, 2, 1, OIIO::TypeDesc::UINT8);
    spec.attribute("Orientation", orientation);
    save_picture(folder_ / "o.tif", spec, std::vector<uint8_t>{10, 20, 30, 40, 50, 60});
    const Picture picture = read_picture({.path = folder_ / "o.tif", .role = PictureRole::data});
    ASSERT_EQ(picture.height(), static_cast<int>(upright[orientation].size()));
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
        EXPECT_EQ(picture.planes[0](x, y) * 255, static_cast<float>(10 * upright[orientation][y][x]))
            << "orientation " << orientation << " at " << x << ", " << y;
    EXPECT_EQ(picture.notes.size(), orientation == 1 ? 0u : 1u);
  }
}

TEST_F(ImageReader, OrientationOfJpegIsApplied) {
  OIIO::ImageSpec spec = spec_of(32, 16, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("Orientation", 6);
  save_picture(folder_ / "o.jpg", spec, std::vector<uint8_t>(32 * 16 * 3, 90));
  const Picture picture = read_color(folder_ / "o.jpg");
  EXPECT_EQ(picture.width(), 16);
  EXPECT_EQ(picture.height(), 32);
}

TEST_F(ImageReader, TurnedNormalMapIsRefused) {
  OIIO::ImageSpec spec = spec_of(2, 2, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("Orientation", 6);
  save_picture(folder_ / "n.tif", spec, std::vector<uint8_t>(12, 128));
  EXPECT_EQ(reading_refusal(folder_ / "n.tif", PictureRole::normal).kind, ErrorKind::unsupported);
}

TEST_F(ImageReader, TiledFilesEqualUntiledOnes) {
  std::vector<float> samples(70 * 40 * 3);
  for (size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<float>(i % 97);
  OIIO::ImageSpec spec = spec_of(70, 40, 3, OIIO::TypeDesc::FLOAT);
  save_picture(folder_ / "rows.exr", spec, samples);
  spec.tile_width = spec.tile_height = 16;
  save_picture(folder_ / "tiles.exr", spec, samples);
  const Picture rows = read_color(folder_ / "rows.exr");
  const Picture tiles = read_color(folder_ / "tiles.exr");
  for (int c = 0; c < 3; ++c) EXPECT_EQ(rows.planes[c], tiles.planes[c]);
  EXPECT_EQ(rows.planes[1](69, 39), samples[(39 * 70 + 69) * 3 + 1]);
}

TEST_F(ImageReader, FirstOfSeveralPicturesIsReadAndSaid) {
  const std::vector<OIIO::ImageSpec> specs(2, spec_of(1, 1, 3, OIIO::TypeDesc::HALF));
  auto output = OIIO::ImageOutput::create("openexr");
  ASSERT_TRUE(output->open(folder_ / "m.exr", 2, specs.data()));
  const float first[] = {1, 2, 3}, second[] = {4, 5, 6};
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, first));
  ASSERT_TRUE(output->open(folder_ / "m.exr", specs[1], OIIO::ImageOutput::AppendSubimage));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, second));
  ASSERT_TRUE(output->close());
  const Picture picture = read_color(folder_ / "m.exr");
  EXPECT_EQ(picture.planes[2](0, 0), 3.0f);
  EXPECT_THAT(picture.notes, ElementsAre(HasSubstr("several pictures")));
}

TEST_F(ImageReader, NegativeColorsBecomeZeroAndAreCounted) {
  save_picture(folder_ / "a.exr", spec_of(2, 1, 3, OIIO::TypeDesc::FLOAT),
               std::vector<float>{-1, 0.5f, -0.0f, -1e-9f, 0, 1});
  const Picture picture = read_color(folder_ / "a.exr");
  EXPECT_EQ(picture.planes[0](0, 0), 0.0f);
  EXPECT_FALSE(std::signbit(picture.planes[2](0, 0)));
  EXPECT_THAT(picture.notes, ElementsAre(HasSubstr("2 negative color values")));
}

TEST_F(ImageReader, NanAndInfinityAreRefusedWithCountAndFirstTexel) {
  std::vector<float> samples(4 * 3 * 3, 0.5f);
  samples[(1 * 4 + 2) * 3 + 1] = kNotANumber;
  samples[(1 * 4 + 2) * 3 + 2] = kNotANumber;  // the same texel again
  samples[(2 * 4 + 0) * 3 + 0] = -std::numeric_limits<float>::infinity();
  save_picture(folder_ / "a.exr", spec_of(4, 3, 3, OIIO::TypeDesc::FLOAT), samples);
  for (const PictureRole role : {PictureRole::color, PictureRole::data, PictureRole::normal}) {
    const Refusal found = reading_refusal(folder_ / "a.exr", role);
    EXPECT_EQ(found.kind, ErrorKind::bad_data);
    EXPECT_THAT(found.words, AllOf(HasSubstr("a.exr"), HasSubstr("2 of 12 texels"), HasSubstr("(2, 1)")));
  }
}

TEST_F(ImageReader, ColorAboveTheLargestHalfIsRefused) {
  save_picture(folder_ / "a.exr", spec_of(2, 1, 3, OIIO::TypeDesc::FLOAT), std::vector<float>{1, 1, 1, 1, 70000, 1});
  const Refusal found = reading_refusal(folder_ / "a.exr");
  EXPECT_EQ(found.kind, ErrorKind::bad_data);
  EXPECT_THAT(found.words, AllOf(HasSubstr("65504"), HasSubstr("(1, 0)"), HasSubstr("70000")));
  EXPECT_EQ(reading_refusal(folder_ / "a.exr", PictureRole::data).kind, std::nullopt);
}

TEST_F(ImageReader, WhatCannotBeOpenedIsAnIoError) {
  std::filesystem::create_directory(folder_ / "d.png");
  std::filesystem::create_directory(folder_ / "rock.texbundle");
  ASSERT_EQ(::mkfifo((folder_ / "pipe.png").c_str(), 0600), 0);
  write_bytes(folder_ / "locked.png", "x");
  std::filesystem::permissions(folder_ / "locked.png", std::filesystem::perms::none);
  const auto words_of = [&](const char* name) {
    const Refusal found = reading_refusal(folder_ / name);
    EXPECT_EQ(found.kind, ErrorKind::io) << name;
    EXPECT_THAT(found.words, HasSubstr(folder_ / name));
    return found.words;
  };
  EXPECT_THAT(words_of("missing.png"), HasSubstr("no such file"));
  EXPECT_THAT(words_of("missing/a.png"), HasSubstr("no such file"));
  EXPECT_THAT(words_of("d.png"), HasSubstr("found a directory"));
  EXPECT_THAT(words_of("rock.texbundle"), HasSubstr("a bundle is the input of other verbs"));
  EXPECT_THAT(words_of("pipe.png"), HasSubstr("pipe"));
  if (::geteuid() != 0) {
    EXPECT_THAT(words_of("locked.png"), HasSubstr("Permission denied"));
  }
}

TEST_F(ImageReader, AnEmptyFileIsBadData) {
  write_bytes(folder_ / "empty.png", "");
  EXPECT_EQ(reading_refusal(folder_ / "empty.png").kind, ErrorKind::bad_data);
}

TEST_F(ImageReader, WhatIsNotAPictureIsUnsupported) {
  write_bytes(folder_ / "text.png", "hello\n");
  write_bytes(folder_ / "text.txt", "hello\n");
  write_bytes(folder_ / "bare", "hello\n");
  for (const char* name : {"text.png", "text.txt", "bare"}) {
    const Refusal found = reading_refusal(folder_ / name);
    EXPECT_EQ(found.kind, ErrorKind::unsupported) << name;
    EXPECT_THAT(found.words, AllOf(HasSubstr(folder_ / name), HasSubstr("expected an image")));
  }
}

TEST_F(ImageReader, WrongExtensionIsReadByContent) {
  save_picture(folder_ / "a.png", spec_of(1, 1, 3, OIIO::TypeDesc::UINT8), std::vector<uint8_t>{51, 102, 255});
  std::filesystem::rename(folder_ / "a.png", folder_ / "a.jpg");
  EXPECT_EQ(read_color(folder_ / "a.jpg").planes[2](0, 0), 1.0f);
}

// Every format that a decoder may pad in silence: cut at 20, 50 and 90 % none may be read as whole.
TEST_F(ImageReader, CutOffFilesAreBadData) {
  std::vector<uint8_t> samples(96 * 64 * 3);
  uint32_t state = 1;
  for (uint8_t& sample : samples) sample = static_cast<uint8_t>((state = state * 1664525u + 1013904223u) >> 24);
  for (const char* extension : {"png", "jpg", "tif", "exr", "tga", "bmp", "hdr", "ppm", "gif"}) {
    const std::string whole = folder_ / (std::string("whole.") + extension);
    save_picture(whole, spec_of(96, 64, 3, OIIO::TypeDesc::UINT8), samples);
    ASSERT_EQ(reading_refusal(whole).words, "") << extension;
    const std::string bytes = read_bytes(whole);
    for (const double share : {0.2, 0.5, 0.9}) {
      const std::string cut = folder_ / (std::string("cut.") + extension);
      write_bytes(cut, bytes.substr(0, static_cast<size_t>(static_cast<double>(bytes.size()) * share)));
      EXPECT_EQ(reading_refusal(cut).kind, ErrorKind::bad_data) << extension << " cut at " << share;
    }
  }
}

TEST_F(ImageReader, DamagedTexelsAreBadData) {
  std::vector<uint8_t> samples(64 * 64 * 3);
  uint32_t state = 1;
  for (uint8_t& sample : samples) sample = static_cast<uint8_t>((state = state * 1664525u + 1013904223u) >> 24);
  for (const char* name : {"a.png", "a.jpg"}) {
    save_picture(folder_ / name, spec_of(64, 64, 3, OIIO::TypeDesc::UINT8), samples);
    std::string bytes = read_bytes(folder_ / name);
    bytes.replace(bytes.size() / 2, 6, std::string("\xff\xd0\x12\xff\xd5\x00", 6));
    write_bytes(folder_ / name, bytes);
    const Refusal found = reading_refusal(folder_ / name);
    EXPECT_EQ(found.kind, ErrorKind::bad_data) << name;
    EXPECT_THAT(found.words, HasSubstr("truncated or damaged"));
  }
}

TEST_F(ImageReader, LyingHeaderIsRefusedBeforeMemoryIsTaken) {
  PngParts parts{.width = 16000, .height = 16000, .bit_depth = 8, .color_type = 2};
  parts.rows = {"abc"};
  write_bytes(folder_ / "lie.png", png_bytes(parts));  // 3 GB of floats, were they taken
  const Refusal found = reading_refusal(folder_ / "lie.png");
  EXPECT_EQ(found.kind, ErrorKind::bad_data);
  EXPECT_THAT(found.words, HasSubstr("truncated or damaged"));
}

TEST_F(ImageReader, TooWideIsRefusedWithTheLimit) {
  PngParts parts{.width = 100000, .height = 1, .bit_depth = 8, .color_type = 0};
  parts.rows = {std::string(10, 'a')};
  write_bytes(folder_ / "wide.png", png_bytes(parts));
  const Refusal found = reading_refusal(folder_ / "wide.png");
  EXPECT_EQ(found.kind, ErrorKind::bad_data);
  EXPECT_THAT(found.words, AllOf(HasSubstr("at most 16384"), HasSubstr("100000 x 1")));
}

TEST_F(ImageReader, ZeroSizeIsRefused) {
  write_bytes(folder_ / "zero.png", png_bytes({.width = 0, .height = 4, .bit_depth = 8, .color_type = 0}));
  write_bytes(folder_ / "zero.ppm", "P6\n0 0\n255\n");
  EXPECT_EQ(reading_refusal(folder_ / "zero.png").kind, ErrorKind::bad_data);
  EXPECT_EQ(reading_refusal(folder_ / "zero.ppm").kind, ErrorKind::bad_data);
}

TEST_F(ImageReader, ChannelsMustSuitTheRole) {
  save_picture(folder_ / "grey.png", spec_of(1, 1, 1, OIIO::TypeDesc::UINT8), std::vector<uint8_t>{128});
  OIIO::ImageSpec two = spec_of(1, 1, 2, OIIO::TypeDesc::FLOAT);
  two.channelnames = {"R", "G"};
  save_picture(folder_ / "two.exr", two, std::vector<float>{0.1f, 0.2f});
  EXPECT_THAT(reading_refusal(folder_ / "grey.png", PictureRole::normal).words, HasSubstr("expected 3 channels"));
  EXPECT_EQ(reading_refusal(folder_ / "two.exr").kind, ErrorKind::bad_data);
}

TEST_F(ImageReader, DepthAndLayersBesideColorAreLeftOut) {
  OIIO::ImageSpec spec = spec_of(1, 1, 5, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"R", "G", "B", "A", "Z"};
  spec.alpha_channel = 3;
  spec.z_channel = 4;
  save_picture(folder_ / "a.exr", spec, std::vector<float>{0.1f, 0.2f, 0.3f, 1, 99});
  const Picture picture = read_color(folder_ / "a.exr");
  EXPECT_EQ(picture.channels, 3);
  EXPECT_EQ(picture.planes[2](0, 0), 0.3f);
}

TEST_F(ImageReader, InterleavedPlanesAreColors) {
  save_picture(folder_ / "a.exr", spec_of(2, 1, 3, OIIO::TypeDesc::FLOAT), std::vector<float>{1, 2, 3, 4, 5, 6});
  const Image<V3f> image = interleave(read_color(folder_ / "a.exr").planes);
  EXPECT_EQ(image(1, 0), V3f(4, 5, 6));
}

}  // namespace
}  // namespace texbake
