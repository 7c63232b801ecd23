// Planes of pixels as the parts of one OpenEXR file. The only place that knows OpenEXR.
// Based on: the OpenEXR 2 multi-part file layout; compression ZIP, scan lines, one displayWindow for all parts.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "formats/issues.h"
#include "formats/pixel_type.h"
#include "formats/safe_file.h"
#include "libbake/base/torus.h"

namespace texbake {

/// A plane as a file sees it: which part, which channels, how large. Its data window starts at (0, 0).
struct PlaneShape {
  std::string part;
  std::vector<std::string> channels;
  PixelType type = PixelType::half;
  int width = 0;
  int height = 0;

  /// Canonical bytes of one row: the channels in the order of `channels`, each `width` little-endian values from the
  /// left. The canonical bytes of a plane are its rows from the top: what `pixelHash` hashes.
  size_t row_bytes() const { return channels.size() * static_cast<size_t>(width) * bytes_of(type); }
  size_t total_bytes() const { return row_bytes() * static_cast<size_t>(height); }
};

/// A plane to be written; `row` fills the canonical bytes of row y.
struct ExrPart {
  PlaneShape shape;
  std::function<void(int y, std::byte* row)> row;
};

/// SHA-256 of the canonical bytes.
std::string pixel_hash(const ExrPart& part);

/// Writes `parts` in this order with displayWindow (0, 0) - `size`. The same bytes for any number of threads. Does not
/// commit. Throws Error(io).
void write_exr(SafeFile& file, V2i size, const std::vector<ExrPart>& parts);

/// An OpenEXR file that is trusted in nothing.
class ExrReader {
 public:
  /// Reads the headers. Reports file_missing and exr_unreadable, and, before OpenEXR sees the file, part_kind and
  /// part_compression of any of its parts.
  ExrReader(const std::filesystem::path& path, IssueLog& log);
  ~ExrReader();
  ExrReader(ExrReader&&) noexcept;

  bool is_open() const;
  std::vector<std::string> part_names() const;
  /// Can the plane be read as its shape says? Reports what stands against it: part_missing, part_window, part_channels.
  bool holds(const PlaneShape& shape, IssueLog& log) const;
  /// Is the file large enough for all of `shapes`, which it holds, when each is read once? Else reports file_too_small.
  /// Nothing as large as an image is allocated before this has said yes.
  bool has_room_for(const std::vector<PlaneShape>& shapes, IssueLog& log) const;
  /// Calls `row` for each row from the top, and returns the hash of the canonical bytes; empty after exr_unreadable.
  std::string read(const PlaneShape& shape, const std::function<void(int y, const std::byte* row)>& row,
                   IssueLog& log) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace texbake
