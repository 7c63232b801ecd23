#include "formats/jpeg_check.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace texbake {
namespace {

// The walk through the segments of a file.
class JpegWalk {
 public:
  explicit JpegWalk(std::string_view bytes) : bytes_(bytes) {}

  int byte_at(size_t at) const { return at < bytes_.size() ? static_cast<uint8_t>(bytes_[at]) : -1; }
  size_t at() const { return at_; }

  /// The marker at the current place; nothing where there is none.
  std::optional<int> marker() {
    if (byte_at(at_) != 0xFF) return std::nullopt;
    while (byte_at(at_ + 1) == 0xFF) ++at_;  // fill bytes
    const int code = byte_at(at_ + 1);
    return code > 0 ? std::optional(code) : std::nullopt;
  }
  /// Past the current marker and its parameters.
  void skip_segment() { at_ += 2 + static_cast<size_t>(byte_at(at_ + 2) * 256 + byte_at(at_ + 3)); }
  /// Past entropy coded data, to the next marker that is none of its own; false where the file ends before.
  bool skip_scan() {
    for (; at_ + 1 < bytes_.size(); ++at_) {
      const int code = byte_at(at_ + 1);
      if (byte_at(at_) == 0xFF && code != 0 && code != 0xFF && (code < 0xD0 || code > 0xD7)) return true;
    }
    return false;
  }
  bool is_inside(size_t count) const { return at_ + count <= bytes_.size(); }

 private:
  std::string_view bytes_;
  size_t at_ = 2;
};

constexpr int kBaseline = 0xC0, kExtended = 0xC1, kScan = 0xDA, kEnd = 0xD9;

}  // namespace

bool lacks_only_end_marker(std::string_view bytes) {
  JpegWalk walk(bytes);
  int components = 0;
  for (;;) {
    const std::optional<int> marker = walk.marker();
    if (!marker || *marker == kEnd || !walk.is_inside(10)) return false;
    if (*marker == kBaseline || *marker == kExtended) components = walk.byte_at(walk.at() + 9);
    if (*marker == kScan) break;
    walk.skip_segment();
  }
  const bool only_scan = components > 0 && walk.byte_at(walk.at() + 4) == components;
  walk.skip_segment();
  return only_scan && !walk.skip_scan();
}

}  // namespace texbake
