#include "formats/dds_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "formats/byte_order.h"
#include "libbake/base/error.h"

namespace texbake {
namespace {

constexpr uint32_t kDdsFourCc = 0x4, kDdsRgb = 0x40;

uint32_t dds_number(std::string_view header, size_t at) { return static_cast<uint32_t>(little_endian(header, at, 4)); }

// Is this one run of bits, none of them beyond `bits`?
bool is_mask(uint32_t mask, uint32_t bits) {
  if (mask == 0 || (bits < 32 && mask >> bits != 0)) return false;
  while ((mask & 1) == 0) mask >>= 1;
  return (mask & (mask + 1)) == 0;
}

// Of the largest picture; sides that no picture has count as this long, so that nothing overflows.
constexpr uint64_t kLongestSide = uint64_t{1} << 20;
uint64_t texel_bytes(std::string_view header) {
  const uint64_t height = std::min<uint64_t>(dds_number(header, 12), kLongestSide);
  const uint64_t width = std::min<uint64_t>(dds_number(header, 16), kLongestSide);
  if ((dds_number(header, 80) & kDdsFourCc) == 0) return width * height * ((dds_number(header, 88) + 7) / 8);
  const uint64_t block_bytes = header.substr(84, 4) == "DXT1" ? 8 : 16;
  return (width + 3) / 4 * ((height + 3) / 4) * block_bytes;
}

[[noreturn]] void throw_damaged_dds(const std::string& path, const std::string& found) {
  throw Error(ErrorKind::bad_data,
              fmt::format("{}: expected a complete image, found a truncated or damaged file ({}); copy or export it "
                          "again",
                          path, found));
}

}  // namespace

void check_dds(const std::string& path, std::string_view header, uint64_t file_size) {
  if (header.size() < kDdsHeaderBytes) throw_damaged_dds(path, "the file ends inside its header");
  const uint32_t flags = dds_number(header, 80), bits = dds_number(header, 88);
  if ((flags & kDdsFourCc) == 0) {
    if ((flags & kDdsRgb) == 0)
      throw Error(ErrorKind::unsupported,
                  fmt::format("{}: expected RGB or a compressed image, found luminance or alpha "
                              "alone, which is not supported in DDS; export it as PNG",
                              path));
    for (const size_t at : {92, 96, 100})
      if (bits == 0 || bits > 32 || !is_mask(dds_number(header, at), bits))
        throw_damaged_dds(path, fmt::format("a mask of its {} bits selects no channel", bits));
  }
  const uint64_t needed = kDdsHeaderBytes + texel_bytes(header);
  if (needed > file_size)
    throw_damaged_dds(path, fmt::format("its texels need {} bytes, it has {}", needed, file_size));
}

}  // namespace texbake
