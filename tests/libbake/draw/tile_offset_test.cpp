// Tests libbake/draw/tile_offset.cpp.
#include <gtest/gtest.h>

#include <limits>

#include "libbake/base/error.h"
#include "libbake/draw/window.h"

namespace texbake {
namespace {

TileOffset parsed(std::string_view text) { return tile_offset(text, 100, "--origin"); }

TEST(TileOffset, NegativeCoordinatesLieInTheTileBefore) {
  EXPECT_EQ(tile_offset(-1, 0, 100), (TileOffset{0xffffffffu, 99 * 256}));
  EXPECT_EQ(tile_offset(-100, 0, 100), (TileOffset{0xffffffffu, 0}));
  EXPECT_EQ(tile_offset(0, -1, 100), (TileOffset{0xffffffffu, 100 * 256 - 1}));
  EXPECT_EQ(tile_offset(99, 256, 100), (TileOffset{1, 0}));
}

TEST(TileOffset, TilesWrapAtTwoToThe32) {
  const int64_t round = (int64_t{1} << 32) * 100;
  EXPECT_EQ(tile_offset(round + 205, 3, 100), (TileOffset{2, 5 * 256 + 3}));
  EXPECT_EQ(tile_offset(-round + 205, 3, 100), (TileOffset{2, 5 * 256 + 3}));
}

TEST(TileOffset, TheEndsOfInt64AreFine) {
  EXPECT_EQ(tile_offset(std::numeric_limits<int64_t>::max(), 0, 100).offset_256, 7u * 256);
  EXPECT_EQ(tile_offset(std::numeric_limits<int64_t>::min(), 0, 100).offset_256, 92u * 256);
  EXPECT_EQ(tile_offset(0, std::numeric_limits<int64_t>::min(), 100).offset_256 % 256, 0u);
}

TEST(TileOffset, DecimalsRoundToThe256thHalvesUp) {
  EXPECT_EQ(parsed("3.25"), (TileOffset{0, 3 * 256 + 64}));
  EXPECT_EQ(parsed("-3.25"), (TileOffset{0xffffffffu, 96 * 256 + 192}));
  EXPECT_EQ(parsed("0.001953125"), (TileOffset{0, 1}));  // half a step: up
  EXPECT_EQ(parsed("0.0019531249999999999"), (TileOffset{0, 0}));
  EXPECT_EQ(parsed("-0.001953125"), (TileOffset{0, 0}));  // up is towards zero
  EXPECT_EQ(parsed("-0.00195312500000001"), (TileOffset{0xffffffffu, 100 * 256 - 1}));
  EXPECT_EQ(parsed("0.9999"), (TileOffset{0, 256}));
  EXPECT_EQ(parsed("-.5"), (TileOffset{0xffffffffu, 99 * 256 + 128}));
  EXPECT_EQ(parsed("+7"), (TileOffset{0, 7 * 256}));
  EXPECT_EQ(parsed("429496729600"), (TileOffset{0, 0}));
}

TEST(TileOffset, WhatIsNoNumberIsRefusedByTheNameOfItsOption) {
  for (const char* text : {"", ".", "-", "1e5", "1,5", "0x10", "--1", "nan", "9223372036854775808", "1.2.3", " 1"}) {
    try {
      parsed(text);
      FAIL() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_NE(std::string(error.what()).find("--origin"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace texbake
