#include "formats/exif_color.h"

#include <gtest/gtest.h>

#include <string>

namespace texbake {
namespace {

using namespace std::string_literals;

// A directory of one entry of type `type`, big-endian, at `at` of the EXIF data; its value is `value`, 4 bytes.
std::string directory_of(const std::string& tag, char type, char count, const std::string& value) {
  return "\0\1"s + tag + "\0"s + type + "\0\0\0"s + count + value + "\0\0\0\0"s;
}
std::string exif_of(const std::string& index) {
  std::string bytes = "MM\0*\0\0\0\x08"s;
  bytes += directory_of("\x87\x69", 4, 1, "\0\0\0\x1a"s);  // at 8, 18 bytes
  bytes += directory_of("\xa0\x05", 4, 1, "\0\0\0\x2c"s);  // at 26
  bytes += directory_of("\0\1"s, 2, 4, index);             // at 44
  return "\xff\xd8\xff\xe1\0\x50"s + "Exif\0\0"s + bytes;
}

TEST(ExifColor, TheIndexR03IsAdobeRgb) {
  EXPECT_TRUE(says_adobe_rgb(exif_of("R03\0"s)));
  EXPECT_FALSE(says_adobe_rgb(exif_of("R98\0"s)));
  EXPECT_FALSE(says_adobe_rgb("\xff\xd8\xff\xe0"));
}

TEST(ExifColor, EveryCutIsHarmless) {
  const std::string whole = exif_of("R03\0"s);
  for (size_t size = 0; size + 6 < whole.size(); ++size) says_adobe_rgb(whole.substr(0, size));
}

}  // namespace
}  // namespace texbake
