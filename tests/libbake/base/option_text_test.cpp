#include "libbake/base/option_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libbake/content/select_contents.h"

namespace texbake {
namespace {

constexpr Field kClasses{.name = "classes", .unit = "colours", .min = 1, .max = 64};

template <class Read>
std::string refusal(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.what();
  }
  return "accepted";
}

TEST(OptionText, NumbersAreReadWholeOrRefused) {
  EXPECT_EQ(parse_integer("classes", kClasses, "12"), 12);
  EXPECT_EQ(refusal([] { parse_integer("classes", kClasses, "12x"); }),
            "--classes: expected a whole number, 1 to 64 colours, found \"12x\"");
  EXPECT_EQ(refusal([] { parse_integer("classes", kClasses, "65"); }),
            "--classes: expected 1 to 64 colours, found \"65\"");
  EXPECT_NE(refusal([] { parse_integer("classes", kClasses, ""); }), "accepted");
  EXPECT_NE(refusal([] { parse_integer("classes", kClasses, "99999999999999999999"); }), "accepted");
  EXPECT_NE(refusal([] { parse_number("classes", kClasses, "nan"); }), "accepted");
  EXPECT_NE(refusal([] { parse_number("classes", kClasses, "inf"); }), "accepted");
  EXPECT_NE(refusal([] { parse_number("classes", kClasses, " 2"); }), "accepted");
}

TEST(OptionText, OptionalsTakeAuto) {
  std::optional<int> classes = 3;
  assign_text(classes, "classes", kClasses, "auto");
  EXPECT_EQ(classes, std::nullopt);
  assign_text(classes, "classes", kClasses, "7");
  EXPECT_EQ(classes, 7);
}

TEST(OptionText, NamesOfEnumsAreSuggested) {
  Choice choice = Choice::impact;
  assign_text(choice, "choice", {}, "balanced");
  EXPECT_EQ(choice, Choice::balanced);
  EXPECT_EQ(refusal([&] { assign_text(choice, "choice", {}, "balancd"); }),
            "--choice: expected one of impact, balanced, found \"balancd\"; did you mean \"balanced\"?");
}

TEST(OptionText, SizesAreTwoWholeNumbersFromOne) {
  EXPECT_EQ(parse_size("size", "4096x2048").width, 4096);
  EXPECT_EQ(parse_size("size", "4096x2048").height, 2048);
  EXPECT_EQ(parse_size("size", "64").height, 64);
  EXPECT_EQ(parse_size("size", "64X32").height, 32);
  EXPECT_EQ(parse_size("size", "64,32").width, 64);
  for (const char* wrong : {"", "x", "0x4", "4x0", "-4x4", "4x", "4x4x4", "4,4x4", "4X", "4.5x4", "99999999999x1"})
    EXPECT_NE(refusal([&] { parse_size("size", wrong); }), "accepted") << wrong;
}

TEST(OptionText, BytesHaveUnitsOfPowersOf1024) {
  EXPECT_EQ(parse_bytes("max-memory", "1000"), 1000u);
  EXPECT_EQ(parse_bytes("max-memory", "512M"), 512u << 20);
  EXPECT_EQ(parse_bytes("max-memory", "1.5K"), 1536u);
  EXPECT_EQ(parse_bytes("max-memory", "4GiB"), uint64_t{4} << 30);
  for (const char* wrong : {"", "M", "4Q", "4MM", "-1", "0", "1e40", "4 G", "99999999T"})
    EXPECT_NE(refusal([&] { parse_bytes("max-memory", wrong); }), "accepted") << wrong;
}

TEST(OptionText, NamedFilesKeepEverythingAfterTheFirstEqualsSign) {
  const NamedFile map = parse_named_file("map", "normal=a=b.png");
  EXPECT_EQ(map.name, "normal");
  EXPECT_EQ(map.file, "a=b.png");
  for (const char* wrong : {"normal", "=a.png", "normal=", "nor mal=a.png", "../x=a.png", "", "1=a.png", "-a=a.png"})
    EXPECT_NE(refusal([&] { parse_named_file("map", wrong); }), "accepted") << wrong;
  EXPECT_TRUE(is_plane_name(std::string(63, 'a')));
  EXPECT_FALSE(is_plane_name(std::string(64, 'a')));
}

}  // namespace
}  // namespace texbake
