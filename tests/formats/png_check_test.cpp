#include "formats/png_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/formats/picture_fixtures.h"

namespace texbake {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class PngChecks : public ::testing::Test {
 protected:
  PngCheck check(const std::string& bytes) {
    write_bytes(folder_ / "a.png", bytes);
    return check_png(folder_ / "a.png");
  }
  std::string damage_of(const std::string& bytes) { return check(bytes).damage.value_or(""); }
  /// Damage or warnings, as one text.
  std::string words_of(const std::string& bytes) {
    const PngCheck found = check(bytes);
    std::string words = found.damage.value_or("");
    for (const std::string& warning : found.warnings) words += warning;
    return words;
  }
  static std::string file_with(const std::string& chunks) {
    return png_bytes(
        {.width = 2, .height = 1, .bit_depth = 8, .color_type = 0, .extra_chunks = chunks, .rows = {"ab"}});
  }
  PictureFolder folder_;
  std::string sound_ = file_with("");
};

TEST_F(PngChecks, SoundFilesAndOtherFilesPass) {
  EXPECT_EQ(words_of(sound_), "");
  EXPECT_EQ(words_of(sound_ + "bytes after the end"), "");
  EXPECT_EQ(words_of(""), "");
  EXPECT_EQ(words_of("GIF89a"), "");
}

TEST_F(PngChecks, EveryCutIsFound) {
  for (size_t size = 8; size < sound_.size(); ++size) EXPECT_NE(words_of(sound_.substr(0, size)), "") << size;
}

TEST_F(PngChecks, EveryFlippedBitIsFound) {
  for (size_t at = 8; at < sound_.size(); ++at) {
    std::string bytes = sound_;
    bytes[at] = static_cast<char>(bytes[at] ^ 4);
    EXPECT_NE(words_of(bytes), "") << at;
  }
}

TEST_F(PngChecks, DamageOfTexelsIsNamed) {
  EXPECT_THAT(damage_of(sound_.substr(0, sound_.size() - 14)), HasSubstr("inside the chunk IDAT"));
  std::string bytes = sound_;
  bytes[sound_.size() - 20] ^= 1;
  EXPECT_THAT(damage_of(bytes), HasSubstr("checksum of the chunk IDAT"));
}

TEST_F(PngChecks, AMissingEndIsAWarning) {
  for (const size_t missing : {12, 8, 1}) {
    const PngCheck found = check(sound_.substr(0, sound_.size() - missing));
    EXPECT_FALSE(found.damage) << missing;
    EXPECT_THAT(found.warnings, ElementsAre(HasSubstr("IEND")));
  }
}

TEST_F(PngChecks, AWrongChecksumOfAnAncillaryChunkIsAWarningAndTheChunkDoesNotCount) {
  std::string chunk = png_chunk("gAMA", big_endian(100000));
  EXPECT_EQ(check(file_with(chunk)).color_chunks.at("gAMA"), big_endian(100000));
  chunk.back() = static_cast<char>(chunk.back() ^ 1);
  const PngCheck found = check(file_with(chunk));
  EXPECT_FALSE(found.damage);
  EXPECT_THAT(found.warnings, ElementsAre(HasSubstr("checksum of the chunk gAMA")));
  EXPECT_THAT(found.color_chunks, IsEmpty());
}

}  // namespace
}  // namespace texbake
