#include "formats/exr_header.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>

#include "formats/limits.h"

namespace texbake {
namespace {

constexpr uint32_t kMagic = 20000630;
constexpr uint32_t kMultiPartFlag = 0x1000;
constexpr size_t kMaxNameBytes = 255;  // of an attribute or its type, in files with long names
constexpr int kMaxAttributes = 1000;   // of one part
constexpr uint32_t kMaxAttributeBytes = 1 << 20;

class HeaderScan {
 public:
  explicit HeaderScan(const std::filesystem::path& path) : stream_(path, std::ios::binary) {
    std::error_code failed;
    bytes_ = std::filesystem::file_size(path, failed);
    if (failed) bytes_ = 0;
  }

  std::string fault() {
    if (number() != kMagic) return "something that is not OpenEXR";
    const bool is_multi_part = (number() & kMultiPartFlag) != 0;
    for (int part = 0; part <= kMaxParts; ++part) {
      const auto attributes = header();
      if (!attributes) return fault_;
      // A multi-part file ends its headers with an empty one.
      if (!is_multi_part || *attributes == 0) return {};
    }
    return fmt::format("more than {} parts", kMaxParts);
  }

 private:
  /// Number of attributes of the next header; nothing after a fault.
  std::optional<int> header() {
    for (int count = 0; count < kMaxAttributes; ++count) {
      const std::string attribute = name();
      if (!fault_.empty()) return std::nullopt;
      if (attribute.empty()) return count;
      name();
      const uint32_t size = number();
      const auto at = static_cast<uint64_t>(stream_.tellg());
      if (!stream_ || !fault_.empty() || size > kMaxAttributeBytes || at + size > bytes_) {
        fault_ = fmt::format("attribute \"{}\" of {} bytes in a file of {}", attribute, size, bytes_);
        return std::nullopt;
      }
      stream_.seekg(size, std::ios::cur);
    }
    fault_ = fmt::format("more than {} attributes", kMaxAttributes);
    return std::nullopt;
  }

  std::string name() {
    std::string text;
    for (int c = stream_.get(); c != 0; c = stream_.get()) {
      if (!stream_ || text.size() == kMaxNameBytes) {
        fault_ = "an attribute whose name does not end";
        return {};
      }
      text += static_cast<char>(c);
    }
    return text;
  }

  uint32_t number() {
    std::array<unsigned char, 4> bytes{};
    stream_.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    return static_cast<uint32_t>(bytes[0]) | static_cast<uint32_t>(bytes[1]) << 8 |
           static_cast<uint32_t>(bytes[2]) << 16 | static_cast<uint32_t>(bytes[3]) << 24;
  }

  std::ifstream stream_;
  uint64_t bytes_ = 0;
  std::string fault_;
};

}  // namespace

std::string exr_header_fault(const std::filesystem::path& path) { return HeaderScan(path).fault(); }

}  // namespace texbake
