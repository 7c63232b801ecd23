#include "formats/exr_header.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <fstream>
#include <set>
#include <string_view>

#include "formats/limits.h"

namespace texbake {
namespace {

constexpr uint32_t kMagic = 20000630;
constexpr uint32_t kTiledFlag = 0x200, kDeepFlag = 0x800, kMultiPartFlag = 0x1000;
constexpr size_t kMaxNameBytes = 255;    // of an attribute or its type, in files with long names
constexpr size_t kMaxAttributes = 1000;  // of one part
constexpr uint32_t kMaxAttributeBytes = 1 << 20;

/// Ends the reading of headers that are not accepted.
struct HeaderFault {
  std::string fault;
};

/// Takes the value of an attribute apart.
class AttributeBytes {
 public:
  explicit AttributeBytes(std::string_view bytes) : rest_(bytes) {}

  bool done() const { return rest_.empty(); }
  std::string_view take(size_t count) {
    if (count > rest_.size()) throw HeaderFault{"an attribute that is too short"};
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  int32_t number() {
    int32_t value = 0;  // this program runs on little-endian processors, as the file is
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  V2i pair() {
    const int x = number();
    return {x, number()};
  }
  std::string text() {
    const size_t end = rest_.find('\0');
    if (end == std::string_view::npos) throw HeaderFault{"a channel whose name does not end"};
    const std::string text(take(end));
    take(1);
    return text;
  }

 private:
  std::string_view rest_;
};

std::vector<ExrChannel> channels_of(AttributeBytes bytes) {
  std::vector<ExrChannel> channels;
  while (true) {
    ExrChannel channel{.name = bytes.text()};
    if (channel.name.empty()) return channels;
    const int type = bytes.number();
    if (type < 0 || type > 2) throw HeaderFault{fmt::format("the channel \"{}\" of type {}", channel.name, type)};
    channel.type = static_cast<PixelType>(type);
    bytes.take(4);  // linear or not, and reserved
    channel.sampling = bytes.pair();
    channels.push_back(std::move(channel));
  }
}

class HeaderReader {
 public:
  explicit HeaderReader(const std::filesystem::path& path) : stream_(path, std::ios::binary) {
    std::error_code failed;
    bytes_ = std::filesystem::file_size(path, failed);
    if (failed) bytes_ = 0;
  }

  /// Throws HeaderFault.
  void read(std::vector<ExrPartHeader>& parts) {
    if (number() != kMagic) throw HeaderFault{"something that is not OpenEXR"};
    flags_ = number();
    const bool is_multi_part = (flags_ & kMultiPartFlag) != 0;
    while (true) {
      ExrPartHeader part;
      const bool is_end = !header(part);
      if (is_end && is_multi_part) return;  // an empty header ends the others
      check(part);
      parts.push_back(std::move(part));
      if (!is_multi_part) return;
      if (parts.size() > static_cast<size_t>(kMaxParts))
        throw HeaderFault{fmt::format("more than {} parts", kMaxParts)};
    }
  }

 private:
  /// False for a header without attributes.
  bool header(ExrPartHeader& part) {
    std::set<std::string> seen;
    while (true) {
      const std::string attribute = name();
      if (attribute.empty()) break;
      if (!seen.insert(attribute).second) throw HeaderFault{fmt::format("the attribute \"{}\" twice", attribute)};
      if (seen.size() > kMaxAttributes) throw HeaderFault{fmt::format("more than {} attributes", kMaxAttributes)};
      name();  // its type
      note(attribute, value(attribute), part);
    }
    // Which kind the only part has is a flag of the file.
    if ((flags_ & kMultiPartFlag) == 0 && (flags_ & kDeepFlag) == 0)
      part.kind = (flags_ & kTiledFlag) != 0 ? "tiledimage" : kExrScanLines;
    return !seen.empty();
  }

  static void note(const std::string& attribute, const std::string& value, ExrPartHeader& part) {
    if (attribute == "name") part.name = value;
    if (attribute == "type") part.kind = value;
    if (attribute == "compression") part.compression = static_cast<unsigned char>(AttributeBytes(value).take(1)[0]);
    if (attribute == "channels") part.channels = channels_of(AttributeBytes(value));
    if (attribute != "dataWindow") return;
    AttributeBytes window(value);
    part.low = window.pair();
    part.high = window.pair();
  }

  static void check(const ExrPartHeader& part) {
    const auto fits = [](int low, int high) { return low <= high && int64_t{high} - low < kMaxTileSize; };
    if (!fits(part.low.x, part.high.x) || !fits(part.low.y, part.high.y))
      throw HeaderFault{fmt::format("the data window ({}, {}) - ({}, {}) of a part", part.low.x, part.low.y,
                                    part.high.x, part.high.y)};
  }

  std::string value(const std::string& attribute) {
    const uint32_t size = number();
    const auto at = static_cast<uint64_t>(stream_.tellg());
    if (!stream_ || size > kMaxAttributeBytes || at + size > bytes_)
      throw HeaderFault{fmt::format("attribute \"{}\" of {} bytes in a file of {}", attribute, size, bytes_)};
    std::string bytes(size, '\0');
    stream_.read(bytes.data(), size);
    return bytes;
  }

  std::string name() {
    std::string text;
    for (int c = stream_.get(); c != 0; c = stream_.get()) {
      if (!stream_ || text.size() == kMaxNameBytes) throw HeaderFault{"an attribute whose name does not end"};
      text += static_cast<char>(c);
    }
    return text;
  }

  uint32_t number() {
    std::array<char, 4> bytes{};
    stream_.read(bytes.data(), bytes.size());
    return static_cast<uint32_t>(AttributeBytes({bytes.data(), bytes.size()}).number());
  }

  std::ifstream stream_;
  uint64_t bytes_ = 0;
  uint32_t flags_ = 0;
};

}  // namespace

size_t ExrPartHeader::texel_bytes() const {
  size_t bytes = 0;
  for (const ExrChannel& channel : channels) bytes += bytes_of(channel.type);
  return bytes;
}

ExrHeaders read_exr_headers(const std::filesystem::path& path) {
  ExrHeaders headers;
  try {
    HeaderReader(path).read(headers.parts);
  } catch (const HeaderFault& refused) {
    headers.fault = refused.fault;
  }
  return headers;
}

}  // namespace texbake
