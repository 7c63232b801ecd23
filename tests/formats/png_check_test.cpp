#include "formats/png_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/formats/picture_fixtures.h"

namespace texbake {
namespace {

using ::testing::HasSubstr;

class PngCheck : public ::testing::Test {
 protected:
  std::string damage_of(const std::string& bytes) {
    write_bytes(folder_ / "a.png", bytes);
    return find_png_damage(folder_ / "a.png").value_or("");
  }
  PictureFolder folder_;
  std::string sound_ =
      png_bytes({.width = 2, .height = 1, .bit_depth = 8, .color_type = 0, .extra_chunks = {}, .rows = {"ab"}});
};

TEST_F(PngCheck, SoundFilesAndOtherFilesPass) {
  EXPECT_EQ(damage_of(sound_), "");
  EXPECT_EQ(damage_of(sound_ + "bytes after the end"), "");
  EXPECT_EQ(damage_of(""), "");
  EXPECT_EQ(damage_of("GIF89a"), "");
}

TEST_F(PngCheck, EveryCutIsFound) {
  for (size_t size = 8; size < sound_.size(); ++size) EXPECT_NE(damage_of(sound_.substr(0, size)), "") << size;
}

TEST_F(PngCheck, EveryFlippedBitIsFound) {
  for (size_t at = 8; at < sound_.size(); ++at) {
    std::string bytes = sound_;
    bytes[at] = static_cast<char>(bytes[at] ^ 4);
    EXPECT_NE(damage_of(bytes), "") << at;
  }
}

TEST_F(PngCheck, DamageIsNamed) {
  EXPECT_THAT(damage_of(sound_.substr(0, sound_.size() - 12)), HasSubstr("before the chunk IEND"));
  EXPECT_THAT(damage_of(sound_.substr(0, sound_.size() - 14)), HasSubstr("inside the chunk IDAT"));
  std::string bytes = sound_;
  bytes[sound_.size() - 20] ^= 1;
  EXPECT_THAT(damage_of(bytes), HasSubstr("checksum of the chunk IDAT"));
}

}  // namespace
}  // namespace texbake
