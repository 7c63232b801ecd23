#include "formats/byte_text.h"

#include <gtest/gtest.h>

namespace texbake {
namespace {

TEST(ByteText, WellFormedUtf8IsTextAlready) {
  for (const char* text : {"", "leaves.png", "bl\u00e4tter", "\u20ac", "\U0001f343", "\uffff", "\ud7ff\ue000", "\uef7f",
                           "\uf000", "\U0010ffff"}) {
    EXPECT_TRUE(is_utf8(text)) << text;
    EXPECT_EQ(text_of_bytes(text), text);
    EXPECT_EQ(bytes_of_text(text), text);
  }
}

TEST(ByteText, BytesOfNoCharacterBecomeCharactersOfThePrivateUseArea) {
  EXPECT_EQ(text_of_bytes("bl\xe4tter"), "bl\uefe4tter");
  EXPECT_EQ(text_of_bytes("\x80\xff"), "\uef80\uefff");
  EXPECT_EQ(text_of_bytes("\xc3"), "\uefc3");                                // cut off
  EXPECT_EQ(text_of_bytes("\xc0\xaf"), "\uefc0\uefaf");                      // longer than need be
  EXPECT_EQ(text_of_bytes("\xed\xa0\x80"), "\uefed\uefa0\uef80");            // half a surrogate pair
  EXPECT_EQ(text_of_bytes("\xf4\x90\x80\x80"), "\ueff4\uef90\uef80\uef80");  // beyond Unicode
  EXPECT_EQ(text_of_bytes("\xe2\x82"
                          "a"),
            "\uefe2\uef82"
            "a");
  for (const char* bytes : {"bl\xe4tter", "\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82", "\xf8"})
    EXPECT_FALSE(is_utf8(bytes));
}

TEST(ByteText, EveryPairAndEveryThirdByteComeBack) {
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second)
      for (const int third : {0x00, 0x41, 0x80, 0xbf, 0xc3, 0xef, 0xff}) {
        const std::string bytes = {static_cast<char>(first), static_cast<char>(second), static_cast<char>(third)};
        const std::string text = text_of_bytes(bytes);
        ASSERT_TRUE(is_utf8(text)) << first << " " << second << " " << third;
        ASSERT_EQ(bytes_of_text(text), bytes) << first << " " << second << " " << third;
      }
}

TEST(ByteText, CharactersThatStandForBytesComeBackThemselves) {
  EXPECT_EQ(text_of_bytes("\uef80"), "\uefee\uefbe\uef80");
  EXPECT_EQ(bytes_of_text(text_of_bytes("\uef80 \uefff")), "\uef80 \uefff");
}

}  // namespace
}  // namespace texbake
