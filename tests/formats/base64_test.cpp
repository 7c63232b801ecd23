#include "formats/base64.h"

#include <gtest/gtest.h>

namespace texbake {
namespace {

std::string coded(const std::string& bytes) { return base64(bytes.data(), bytes.size()); }

// RFC 4648, §10.
TEST(Base64, FollowsTheStandard) {
  EXPECT_EQ(coded(""), "");
  EXPECT_EQ(coded("f"), "Zg==");
  EXPECT_EQ(coded("fo"), "Zm8=");
  EXPECT_EQ(coded("foo"), "Zm9v");
  EXPECT_EQ(coded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(coded(std::string("\0\xff\xfe", 3)), "AP/+");
}

TEST(Base64, LongTextsAreCodedInPartsWithoutASeam) {
  const std::string part = "foobar";
  std::string bytes, expected;
  while (bytes.size() < (size_t{4} << 20)) bytes += part, expected += "Zm9vYmFy";
  EXPECT_EQ(coded(bytes), expected);
  EXPECT_EQ(coded(bytes + "f"), expected + "Zg==");
}

}  // namespace
}  // namespace texbake
