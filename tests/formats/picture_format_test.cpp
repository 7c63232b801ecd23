#include "formats/picture_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/formats/picture_fixtures.h"

namespace texbake {
namespace {

using namespace std::string_view_literals;
using ::testing::AllOf;
using ::testing::HasSubstr;

class PictureFormats : public ::testing::Test {
 protected:
  FileFormat format_of(std::string_view bytes) {
    write_bytes(folder_ / "a", bytes);
    return picture_format(folder_ / "a");
  }
  Refusal refusal_of(std::string_view bytes) {
    return refusal([&] { format_of(bytes); });
  }
  PictureFolder folder_;
};

TEST_F(PictureFormats, EachIsKnownByItsFirstBytes) {
  EXPECT_EQ(format_of("\x89PNG\r\n\x1a\n...."), FileFormat::png);
  EXPECT_EQ(format_of("\xff\xd8\xff\xe1"), FileFormat::jpeg);
  for (const std::string_view mark : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
    EXPECT_EQ(format_of(mark), FileFormat::tiff);
  EXPECT_EQ(format_of("\x76\x2f\x31\x01\x02"), FileFormat::openexr);
  EXPECT_EQ(format_of("#?RADIANCE\n"), FileFormat::hdr);
  EXPECT_EQ(format_of("BM......"), FileFormat::bmp);
  EXPECT_EQ(format_of("RIFF....WEBPVP8L"), FileFormat::webp);
  EXPECT_EQ(format_of("\0\0\0\x1c"
                      "ftypheic"sv),
            FileFormat::heif);
  EXPECT_EQ(format_of("DDS |"), FileFormat::dds);
  EXPECT_EQ(format_of("P6\n2 2\n255\n"), FileFormat::pnm);
  EXPECT_EQ(format_of("GIF89a"), FileFormat::gif);
  EXPECT_EQ(format_of("\0\0\0\x0cjP  \r\n\x87\n"sv), FileFormat::jpeg2000);
  EXPECT_EQ(format_of("8BPS\0\x01"sv), FileFormat::psd);
}

// TGA 2.0: map type 0, kind 2 (true color) or 10 (packed), 5 + 4 bytes, then width, height, bits, description
TEST_F(PictureFormats, TgaIsKnownByAHeaderThatAgreesWithItself) {
  std::array<char, 18> header = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 96, 0, 64, 0, 24, 0};
  const auto bytes = [&] { return std::string_view(header.data(), header.size()); };
  EXPECT_EQ(format_of(bytes()), FileFormat::targa);
  header[2] = 10;
  EXPECT_EQ(format_of(bytes()), FileFormat::targa);
  for (const auto& [place, value] : {std::pair{2, 7}, {16, 23}, {1, 9}, {12, 0}, {17, 64}}) {
    const char before = std::exchange(header[static_cast<size_t>(place)], static_cast<char>(value));
    EXPECT_EQ(refusal_of(bytes()).kind, ErrorKind::unsupported) << "byte " << place;
    header[static_cast<size_t>(place)] = before;
  }
}

TEST_F(PictureFormats, OthersAreRefusedAsUnsupportedByTheirName) {
  const auto expect_name = [&](std::string_view bytes, const char* name) {
    const Refusal found = refusal_of(bytes);
    EXPECT_EQ(found.kind, ErrorKind::unsupported) << name;
    EXPECT_THAT(found.words, AllOf(HasSubstr("format not supported"), HasSubstr(name), HasSubstr("PNG, JPEG, TIFF")));
  };
  expect_name("SIMPLE  =                    T", "FITS");
  expect_name("\x01\xda\x01\x01", "SGI");
  expect_name("SDPX", "DPX");
  expect_name("II*\0\x10\0\0\0CR\x02\0"sv, "raw");
  expect_name("hello\n", "something else");
}

TEST_F(PictureFormats, TheNameOfTheFileCountsForNothing) {
  write_bytes(folder_ / "a.null", "\x89PNG\r\n\x1a\n....");
  EXPECT_EQ(picture_format(folder_ / "a.null"), FileFormat::png);
}

}  // namespace
}  // namespace texbake
