#include "libbake/draw/tile_offset.h"

#include <fmt/format.h>

#include <charconv>

#include "libbake/base/error.h"

namespace texbake {
namespace {

int64_t floor_div(int64_t a, int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }
int64_t floor_mod(int64_t a, int64_t b) { return a % b + (a % b < 0 ? b : 0); }

/// round(256 · sign · 0.digits), halves up. Exact for any number of digits: every k + ½ ends by the ninth digit, so
/// that what follows the tenth matters only by being there, below a negative half.
int64_t fraction_256_of(std::string_view digits, int sign) {
  constexpr size_t kDigits = 10;
  int64_t scaled = 0, unit = 1;
  for (size_t i = 0; i < kDigits; ++i) {
    scaled = scaled * 10 + (i < digits.size() ? digits[i] - '0' : 0);
    unit *= 10;
  }
  const bool beyond = digits.find_first_not_of('0', kDigits) != std::string_view::npos;
  return floor_div(sign * 512 * scaled + unit - (sign < 0 && beyond ? 1 : 0), 2 * unit);
}

bool all_digits(std::string_view text) { return text.find_first_not_of("0123456789") == std::string_view::npos; }

}  // namespace

TileOffset tile_offset(int64_t texels, int64_t fraction_256, int tile_side) {
  // Whole texels in the fraction are carried first, so that nothing overflows.
  const int64_t carry = floor_div(fraction_256, 256);
  const int64_t tile = floor_div(texels, tile_side) + floor_div(carry, tile_side);
  const int64_t p = floor_mod(texels, tile_side) + floor_mod(carry, tile_side);
  const int64_t overflow = p >= tile_side ? 1 : 0;
  return {static_cast<uint32_t>(static_cast<uint64_t>(tile + overflow)),
          static_cast<uint32_t>((p - overflow * tile_side) * 256 + floor_mod(fraction_256, 256))};
}

TileOffset tile_offset(std::string_view decimal_texels, int tile_side, std::string_view option) {
  std::string_view text = decimal_texels;
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  const std::string_view digits = point == std::string_view::npos ? std::string_view() : text.substr(point + 1);

  int64_t texels = 0;
  const bool some = !whole.empty() || !digits.empty();
  const auto parsed = std::from_chars(whole.data(), whole.data() + whole.size(), texels);
  const bool fits = whole.empty() || parsed.ec == std::errc();
  if (!some || !all_digits(whole) || !all_digits(digits) || !fits)
    throw Error(ErrorKind::usage, fmt::format("{}: expected a number of texels such as -1048576.25, found \"{}\"",
                                              option, decimal_texels));
  const int sign = negative ? -1 : 1;
  return tile_offset(sign * texels, fraction_256_of(digits, sign), tile_side);
}

}  // namespace texbake
