#include "formats/jpeg_check.h"

#include <gtest/gtest.h>

#include <string>

namespace texbake {
namespace {

using namespace std::string_literals;

// SOI, a frame of `components`, a scan of `scan_components`, and some entropy coded data.
std::string jpeg_of(char frame_code, char components, char scan_components) {
  std::string bytes = "\xff\xd8\xff"s + frame_code + "\0\x0b\x08\0\x08\0\x08"s + components + "\x01\x11\0"s;
  bytes += "\xff\xda\0\x06"s + scan_components + "\0\0\0"s;
  return bytes + "data\xff\0more\xff\xd3rest"s;
}

TEST(JpegCheck, OnlyAMissingEndOfASingleSequentialScanCounts) {
  EXPECT_TRUE(lacks_only_end_marker(jpeg_of('\xc0', 1, 1)));
  EXPECT_FALSE(lacks_only_end_marker(jpeg_of('\xc0', 1, 1) + "\xff\xd9"));
  EXPECT_FALSE(lacks_only_end_marker(jpeg_of('\xc0', 3, 1)));  // other scans would follow
  EXPECT_FALSE(lacks_only_end_marker(jpeg_of('\xc2', 1, 1)));  // progressive: finer scans would follow
  EXPECT_FALSE(lacks_only_end_marker(jpeg_of('\xc0', 1, 1) + "\xff\xda"));
}

TEST(JpegCheck, WhatIsCutBeforeItsScanLacksMore) {
  const std::string bytes = jpeg_of('\xc0', 1, 1);
  for (size_t size = 0; size < 20; ++size) EXPECT_FALSE(lacks_only_end_marker(bytes.substr(0, size))) << size;
}

}  // namespace
}  // namespace texbake
