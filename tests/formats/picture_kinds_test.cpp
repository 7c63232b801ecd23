// Files of many kinds, with known values: formats/image_reader.h reads those values, or says why not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "formats/image_reader.h"
#include "libbake/color/luv.h"
#include "tests/formats/picture_fixtures.h"
#include "tests/formats/profile_fixtures.h"

namespace texbake {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using Codes = std::vector<uint8_t>;

class PictureKinds : public ::testing::Test {
 protected:
  Picture read(const std::string& name, PictureRole role = PictureRole::color, const std::string& layer = "") {
    return read_picture({.path = folder_ / name, .role = role, .layer = layer});
  }
  Refusal reading(const std::string& name, PictureRole role = PictureRole::color) {
    return refusal([&] { read(name, role); });
  }
  PictureFolder folder_;
};

V3f texel_of(const Picture& picture, int x, int y = 0) {
  return {picture.planes[0](x, y), picture.planes[1](x, y), picture.planes[2](x, y)};
}
V3f light_of(int r, int g, int b) {
  const auto linear = [](int code) { return linear_from_srgb(static_cast<float>(code) / 255.0f); };
  return {linear(r), linear(g), linear(b)};
}
OIIO::ImageSpec kind_spec(int width, int height, int channels, OIIO::TypeDesc type) {
  return {width, height, channels, type};
}

std::string little(uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(i < 4 ? value >> (8 * i) : 0);
  return text;
}

// --- Alpha

TEST_F(PictureKinds, AnOpaqueGifHasItsColorsAndNoAlpha) {
  // GIF89a, 2 x 1, a table of two colors; codes 4 (clear), 0, 1, 5 (end) of 3 bits: 0x44, 0x0a
  write_bytes(folder_ / "a.gif", std::string("GIF89a\2\0\1\0\x80\0\0\x0a\x14\x1e\xff\x80\0"
                                             ",\0\0\0\0\2\0\1\0\0\2\2\x44\x0a\0;",
                                             35));
  const Picture picture = read("a.gif");
  EXPECT_EQ(texel_of(picture, 0), light_of(10, 20, 30));
  EXPECT_EQ(texel_of(picture, 1), light_of(255, 128, 0));
  EXPECT_THAT(picture.notes, IsEmpty());
}

TEST_F(PictureKinds, AlphaOfBmpIsStraight) {
  std::string bytes = "BM" + little(62, 4) + little(0, 4) + little(54, 4);
  bytes += little(40, 4) + little(2, 4) + little(1, 4) + little(1, 2) + little(32, 2) + little(0, 24);
  bytes += std::string("\x1e\x14\x0a\x80\x32\x64\xc8\x00", 8);  // B, G, R, A
  write_bytes(folder_ / "a.bmp", bytes);
  const Picture picture = read("a.bmp");
  EXPECT_EQ(texel_of(picture, 0), light_of(10, 20, 30));
  EXPECT_EQ(texel_of(picture, 1), light_of(200, 100, 50));
  EXPECT_THAT(picture.notes, ElementsAre(HasSubstr("2 of 2 texels are not opaque")));
}

std::string targa_of(uint8_t alpha_bits) {
  std::string bytes = std::string("\0\0\2\0\0\0\0\0\0\0\0\0", 12) + little(2, 2) + little(1, 2) + little(32, 1);
  bytes += static_cast<char>(alpha_bits | 0x20);  // rows from the top
  return bytes + std::string("\x1e\x14\x0a\x80\x32\x64\xc8\x40", 8);
}

TEST_F(PictureKinds, AlphaOfTgaIsStraightWhetherItsBitsAreCountedOrNot) {
  for (const uint8_t alpha_bits : {uint8_t{8}, uint8_t{0}}) {
    write_bytes(folder_ / "a.tga", targa_of(alpha_bits));
    const Picture picture = read("a.tga");
    EXPECT_EQ(texel_of(picture, 0), light_of(10, 20, 30)) << int{alpha_bits};
    EXPECT_EQ(texel_of(picture, 1), light_of(200, 100, 50)) << int{alpha_bits};
  }
}

std::string dds_of(const std::string& four_cc, const std::string& texels) {
  std::string bytes = "DDS " + little(124, 4) + little(0x1007, 4) + little(4, 4) + little(4, 4);
  bytes += std::string(56, '\0') + little(32, 4) + little(4, 4) + four_cc + std::string(20, '\0');
  return bytes + little(0x1000, 4) + std::string(16, '\0') + texels;
}

TEST_F(PictureKinds, AlphaOfDdsIsStraightUnlessItsNameSaysPremultiplied) {
  // DXT3 block: alpha 8 of 15 everywhere, then one color, 5:6:5 white
  const std::string block = std::string(8, '\x88') + "\xff\xff\xff\xff" + std::string(4, '\0');
  write_bytes(folder_ / "a.dds", dds_of("DXT3", block));
  EXPECT_EQ(texel_of(read("a.dds"), 3, 3), V3f(1, 1, 1));
  EXPECT_THAT(read("a.dds").notes, ElementsAre(AllOf(HasSubstr("16 of 16"), Not(HasSubstr("divided")))));
}

TEST_F(PictureKinds, AlphaOfJpeg2000IsStraight) {
  OIIO::ImageSpec spec = kind_spec(64, 64, 4, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  Codes codes;
  for (int i = 0; i < 64 * 64; ++i) codes.insert(codes.end(), {100, 50, 200, 128});
  save_picture(folder_ / "a.jp2", spec, codes);
  const Picture picture = read("a.jp2");
  const V3f texel = texel_of(picture, 8, 8), stored = light_of(100, 50, 200);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(texel[c], stored[c], 0.02f);  // a code or two: the format is lossy
}

// --- Strips, tiles, widths of samples

TEST_F(PictureKinds, StripsAreReadWholeWhateverTheirHeight) {
  constexpr int kWidth = 5, kHeight = 150;
  std::vector<double> samples;
  for (int i = 0; i < kWidth * kHeight; ++i) samples.push_back(i / 1024.0);
  for (const int strip : {1, 5, 64, 70, 149, 150, 200}) {
    OIIO::ImageSpec spec = kind_spec(kWidth, kHeight, 1, OIIO::TypeDesc::DOUBLE);
    spec.attribute("tiff:RowsPerStrip", strip);
    spec.attribute("compression", "none");
    save_picture(folder_ / "a.tif", spec, samples);
    const Picture picture = read("a.tif", PictureRole::data);
    for (int y = 0; y < kHeight; ++y)
      ASSERT_EQ(picture.planes[0](kWidth - 1, y), static_cast<float>(samples[y * kWidth + kWidth - 1]))
          << "strips of " << strip << ", row " << y;
  }
}

TEST_F(PictureKinds, PlanarStripsOfAnyHeightAreRead) {
  constexpr int kWidth = 4, kHeight = 150;
  Codes codes;
  for (int i = 0; i < kWidth * kHeight * 3; ++i) codes.push_back(static_cast<uint8_t>(i * 7));
  for (const char* compression : {"lzw", "zip", "none"})
    for (const int strip : {32, 100, 200}) {
      OIIO::ImageSpec spec = kind_spec(kWidth, kHeight, 3, OIIO::TypeDesc::UINT8);
      spec.attribute("planarconfig", "separate");
      spec.attribute("compression", compression);
      spec.attribute("tiff:RowsPerStrip", strip);
      save_picture(folder_ / "a.tif", spec, codes);
      const Picture picture = read("a.tif");
      for (int y = 0; y < kHeight; ++y) {
        const uint8_t* const stored = &codes[static_cast<size_t>(y * kWidth + 2) * 3];
        ASSERT_EQ(texel_of(picture, 2, y), light_of(stored[0], stored[1], stored[2])) << compression << ", row " << y;
      }
    }
}

TEST_F(PictureKinds, DoublesInTilesAreUnsupported) {
  OIIO::ImageSpec spec = kind_spec(32, 32, 1, OIIO::TypeDesc::DOUBLE);
  spec.tile_width = spec.tile_height = 16;
  save_picture(folder_ / "a.tif", spec, std::vector<double>(32 * 32, 0.5));
  EXPECT_EQ(reading("a.tif", PictureRole::data).kind, ErrorKind::unsupported);
}

// --- What the numbers of TIFF mean

// A TIFF file of one strip: entries of directory 0 beyond the size, in order of their tags.
std::string tiff_of(int bits, int photometric, int channels, int width, const std::string& texels) {
  const auto entry = [](int tag, int type, uint32_t count, uint32_t value) {
    return little(static_cast<uint32_t>(tag), 2) + little(static_cast<uint32_t>(type), 2) + little(count, 4) +
           little(value, 4);
  };
  const uint32_t bits_at = 8 + 2 + 9 * 12 + 4, texels_at = bits_at + 2 * static_cast<uint32_t>(channels);
  const auto count = static_cast<uint32_t>(channels);
  std::string bytes = std::string("II*\0", 4) + little(8, 4) + little(9, 2);
  bytes += entry(256, 3, 1, static_cast<uint32_t>(width)) + entry(257, 3, 1, 1);
  bytes += entry(258, 3, count, channels > 2 ? bits_at : static_cast<uint32_t>(bits));
  bytes += entry(259, 3, 1, 1) + entry(262, 3, 1, static_cast<uint32_t>(photometric)) + entry(273, 4, 1, texels_at);
  bytes += entry(277, 3, 1, count) + entry(278, 3, 1, 1) + entry(279, 4, 1, static_cast<uint32_t>(texels.size()));
  bytes += little(0, 4);
  for (int c = 0; c < channels; ++c) bytes += little(static_cast<uint32_t>(bits), 2);
  return bytes + texels;
}

TEST_F(PictureKinds, WhereZeroIsWhiteEveryDepthIsPositive) {
  write_bytes(folder_ / "8.tif", tiff_of(8, 0, 1, 2, std::string("\0\xcc", 2)));
  write_bytes(folder_ / "16.tif", tiff_of(16, 0, 1, 2, std::string("\0\0\xcc\xcc", 4)));
  write_bytes(folder_ / "32.tif", tiff_of(32, 0, 1, 2, std::string("\0\0\0\0\xcc\xcc\xcc\xcc", 8)));
  for (const char* name : {"8.tif", "16.tif", "32.tif"}) {
    const Picture picture = read(name, PictureRole::data);
    EXPECT_FLOAT_EQ(picture.planes[0](0, 0), 1) << name;
    EXPECT_FLOAT_EQ(picture.planes[0](1, 0), 0.2f) << name;
  }
}

TEST_F(PictureKinds, ColorsThatAreNotRgbAreUnsupported) {
  for (const int photometric : {8, 9, 32845, 32803}) {
    write_bytes(folder_ / "a.tif", tiff_of(8, photometric, 3, 2, std::string(6, '\x40')));
    EXPECT_EQ(reading("a.tif").kind, ErrorKind::unsupported) << photometric;
  }
}

TEST_F(PictureKinds, InksWithoutAProfileAreUnsupportedInStripsAndInTiles) {
  write_bytes(folder_ / "a.tif", tiff_of(8, 5, 4, 2, std::string(8, '\x40')));
  const Refusal found = reading("a.tif");
  EXPECT_EQ(found.kind, ErrorKind::unsupported);
  EXPECT_THAT(found.words, HasSubstr("CMYK"));
}

// --- OpenEXR: layers and names

TEST_F(PictureKinds, LayersOfExrAreReadWhole) {
  OIIO::ImageSpec spec = kind_spec(1, 1, 7, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"AO.R", "diffuse.R", "diffuse.G", "diffuse.B", "spec.R", "spec.G", "spec.B"};
  save_picture(folder_ / "a.exr", spec, std::vector<float>{9, 1, 2, 3, 4, 5, 6});
  const Picture first = read("a.exr");
  EXPECT_EQ(texel_of(first, 0), V3f(1, 2, 3));
  EXPECT_THAT(first.notes, ElementsAre(AllOf(HasSubstr("\"diffuse\""), HasSubstr("spec"))));
  EXPECT_EQ(texel_of(read("a.exr", PictureRole::color, "spec"), 0), V3f(4, 5, 6));
  EXPECT_EQ(refusal([&] { read("a.exr", PictureRole::color, "gloss"); }).kind, ErrorKind::usage);
}

TEST_F(PictureKinds, APartIsALayerToo) {
  std::vector<OIIO::ImageSpec> specs(2, kind_spec(1, 1, 3, OIIO::TypeDesc::HALF));
  specs[0].attribute("oiio:subimagename", "beauty");
  specs[1].attribute("oiio:subimagename", "albedo");
  auto output = OIIO::ImageOutput::create("openexr");
  ASSERT_TRUE(output->open(folder_ / "m.exr", 2, specs.data()));
  const float first[] = {1, 2, 3}, second[] = {4, 5, 6};
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, first));
  ASSERT_TRUE(output->open(folder_ / "m.exr", specs[1], OIIO::ImageOutput::AppendSubimage));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, second));
  ASSERT_TRUE(output->close());
  EXPECT_EQ(texel_of(read("m.exr", PictureRole::color, "albedo"), 0), V3f(4, 5, 6));
  EXPECT_EQ(texel_of(read("m.exr", PictureRole::color, "beauty"), 0), V3f(1, 2, 3));
}

TEST_F(PictureKinds, VectorsAndHeightsAreFoundByTheirNames) {
  OIIO::ImageSpec vector = kind_spec(1, 1, 3, OIIO::TypeDesc::FLOAT);
  vector.channelnames = {"X", "Y", "Z"};
  save_picture(folder_ / "n.exr", vector, std::vector<float>{0.6f, 0, 0.8f});
  EXPECT_EQ(texel_of(read("n.exr", PictureRole::normal), 0), V3f(0.6f, 0, 0.8f));
  OIIO::ImageSpec height = kind_spec(1, 1, 1, OIIO::TypeDesc::FLOAT);
  height.channelnames = {"Z"};
  height.z_channel = 0;
  save_picture(folder_ / "z.exr", height, std::vector<float>{0.25f});
  EXPECT_EQ(read("z.exr", PictureRole::data).planes[0](0, 0), 0.25f);
}

// --- Primaries

TEST_F(PictureKinds, ChromaticitiesOfExrAreExchangedUnlessTheSpaceIsGiven) {
  OIIO::ImageSpec spec = kind_spec(1, 1, 3, OIIO::TypeDesc::FLOAT);
  const float bt2020[8] = {0.708f, 0.292f, 0.170f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.3290f};
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), bt2020);
  save_picture(folder_ / "a.exr", spec, std::vector<float>{0.5f, 0.5f, 0.25f});
  const Picture picture = read("a.exr");
  const V3f converted(0.5f * (1.6605f - 0.5876f) - 0.25f * 0.0728f, 0.5f * (1.1329f - 0.1246f) - 0.25f * 0.0083f,
                      0.25f * 1.1187f - 0.5f * (0.0182f + 0.1006f));  // BT.2087-0, to four digits
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(texel_of(picture, 0)[c], converted[c], 2e-4f);
  EXPECT_THAT(picture.notes, Contains(HasSubstr("chromaticities")));
  const Picture kept = read_picture({.path = folder_ / "a.exr", .space = InputSpace::linear});
  EXPECT_EQ(texel_of(kept, 0), V3f(0.5f, 0.5f, 0.25f));
}

Picture read_png(const PictureFolder& folder, const std::string& chunks) {
  PngParts parts{
      .width = 1, .height = 1, .bit_depth = 8, .color_type = 2, .extra_chunks = chunks, .rows = {"\xff\x80\x40"}};
  write_bytes(folder / "p.png", png_bytes(parts));
  return read_picture({.path = folder / "p.png"});
}

std::string chrm_chunk(const std::vector<uint32_t>& values) {
  std::string content;
  for (const uint32_t value : values) content += big_endian(value);
  return png_chunk("cHRM", content);
}

TEST_F(PictureKinds, ChromaticitiesOfPngAreExchanged) {
  const Picture picture = read_png(folder_, png_chunk("gAMA", big_endian(100000)) +
                                                chrm_chunk({31270, 32900, 70800, 29200, 17000, 79700, 13100, 4600}));
  const V3f light(1, 128 / 255.0f, 64 / 255.0f);
  EXPECT_NEAR(texel_of(picture, 0).x, 1.6605f * light.x - 0.5876f * light.y - 0.0728f * light.z, 2e-4f);
  EXPECT_THAT(picture.notes, Contains(HasSubstr("cHRM")));
}

TEST_F(PictureKinds, PngOfRec709PrimariesIsSrgbAsEver) {
  const Picture picture = read_png(folder_, png_chunk("gAMA", big_endian(45455)) +
                                                chrm_chunk({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000}));
  EXPECT_EQ(texel_of(picture, 0), light_of(255, 128, 64));
  EXPECT_THAT(picture.notes, IsEmpty());
}

TEST_F(PictureKinds, CodePointsOfPngCountBeforeTheRest) {
  const Picture picture =
      read_png(folder_, png_chunk("cICP", std::string("\x0c\x0d\x00\x01", 4)) + png_chunk("gAMA", big_endian(100000)));
  EXPECT_EQ(picture.space, "srgb");
  EXPECT_GT(texel_of(picture, 0).x, 1);  // the red of Display P3 lies outside
  EXPECT_EQ(refusal([&] { read_png(folder_, png_chunk("cICP", std::string("\x09\x10\x00\x01", 4))); }).kind,
            ErrorKind::unsupported);
}

TEST_F(PictureKinds, AProfileIsReadForWhatItIsNotForItsName) {
  OIIO::ImageSpec spec = kind_spec(1, 1, 3, OIIO::TypeDesc::UINT16);
  const std::string profile =
      profile_bytes({{{0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.3127, 0.329}}}, 1, "Linear sRGB");
  spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())), profile.data());
  save_picture(folder_ / "a.png", spec, std::vector<uint16_t>{13107, 26214, 65535});
  const Picture picture = read("a.png");
  EXPECT_EQ(picture.space, "linear");
  EXPECT_FLOAT_EQ(texel_of(picture, 0).x, 0.2f);
}

// --- What is missing at the end, and offsets

TEST_F(PictureKinds, PngWithoutItsEndIsReadWithAWarning) {
  PngParts parts{.width = 1, .height = 1, .bit_depth = 8, .color_type = 2, .rows = {"\x0a\x14\x1e"}};
  const std::string bytes = png_bytes(parts);
  write_bytes(folder_ / "a.png", bytes.substr(0, bytes.size() - 12));
  const Picture picture = read("a.png");
  EXPECT_EQ(texel_of(picture, 0), light_of(10, 20, 30));
  EXPECT_THAT(picture.notes, ElementsAre(HasSubstr("before the chunk IEND")));
}

TEST_F(PictureKinds, JpegWithoutItsEndIsReadWithAWarningAndWithoutItsLastTexelsRefused) {
  Codes codes;
  for (int i = 0; i < 64 * 64 * 3; ++i) codes.push_back(static_cast<uint8_t>(i * i % 251));
  save_picture(folder_ / "a.jpg", kind_spec(64, 64, 3, OIIO::TypeDesc::UINT8), codes);
  const Picture whole = read("a.jpg");
  const std::string bytes = read_bytes(folder_ / "a.jpg");
  write_bytes(folder_ / "b.jpg", bytes.substr(0, bytes.size() - 2));
  const Picture open_ended = read("b.jpg");
  for (int c = 0; c < 3; ++c) EXPECT_EQ(open_ended.planes[c], whole.planes[c]);
  EXPECT_THAT(open_ended.notes, ElementsAre(HasSubstr("end marker is missing")));
  write_bytes(folder_ / "c.jpg", bytes.substr(0, bytes.size() - 200));
  EXPECT_EQ(reading("c.jpg").kind, ErrorKind::bad_data);
}

TEST_F(PictureKinds, AnOffsetOfPngIsNoDataWindow) {
  const Picture picture = read_png(folder_, png_chunk("oFFs", big_endian(7) + big_endian(9) + std::string(1, '\0')));
  EXPECT_EQ(texel_of(picture, 0), light_of(255, 128, 64));
  EXPECT_THAT(picture.notes, IsEmpty());
}

// --- What leads decoders astray

TEST_F(PictureKinds, DdsThatWouldNeverEndIsRefused) {
  std::string header = dds_of(std::string(4, '\0'), "abc");
  header.replace(80, 4, little(0x40, 4));  // RGB
  header.replace(88, 4, little(24, 4));    // bits, and no masks
  write_bytes(folder_ / "a.dds", header);
  EXPECT_EQ(reading("a.dds").kind, ErrorKind::bad_data);
  header.replace(80, 4, little(0x20000, 4));  // luminance
  write_bytes(folder_ / "a.dds", header);
  EXPECT_EQ(reading("a.dds").kind, ErrorKind::unsupported);
  std::string huge = dds_of("DXT1", "abc");
  huge.replace(12, 8, std::string(8, '\xff'));  // sides whose product overflows
  write_bytes(folder_ / "a.dds", huge);
  EXPECT_EQ(reading("a.dds").kind, ErrorKind::bad_data);
  write_bytes(folder_ / "a.dds", dds_of("DXT1", "abc"));
  EXPECT_EQ(reading("a.dds").kind, ErrorKind::bad_data);
  write_bytes(folder_ / "a.dds", dds_of("DX10", std::string(64, '\0')));
  EXPECT_EQ(reading("a.dds").kind, ErrorKind::unsupported);
}

}  // namespace
}  // namespace texbake
