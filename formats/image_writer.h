// Writes a picture by rows, so that one of any height takes little memory.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "formats/image_reader.h"
#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// How one sample is stored.
enum class SampleType { uint8, uint16, half, float32 };
template <>
struct EnumNames<SampleType> {
  static constexpr std::pair<SampleType, std::string_view> values[] = {
      {SampleType::uint8, "8"}, {SampleType::uint16, "16"}, {SampleType::half, "half"}, {SampleType::float32, "float"}};
};

struct PictureFormat {
  int width = 0;
  int height = 0;
  int channels = 3;                        ///< 1 or 3
  PictureRole role = PictureRole::color;   ///< what the values given are
  std::optional<SampleType> samples = {};  ///< unset: the first that the kind of file has, below
};

/// Writes the file that `path` names, by its extension: .png (uint8, uint16), .jpg .jpeg (uint8), .tif .tiff (uint8,
/// uint16, float32) or .exr (half, float32).
///
/// Integers hold colors by the sRGB curve, data of 0 … 1 and normals by code (formats/srgb_codes.h), clamped and
/// rounded to the nearest; floats hold linear colors, data and vectors as they are, halves clamped to ±65504. The same
/// values give the same bytes: nothing but the picture is stored.
///
/// The file appears under its name in `close`, whole; a writer destroyed before removes what it wrote. Every failure of
/// the file system throws Error(io), an extension or sample type that is not listed, or a size that is too large,
/// Error(usage).
class PictureWriter {
 public:
  PictureWriter(const std::string& path, const PictureFormat& format);
  ~PictureWriter();
  PictureWriter(PictureWriter&&) noexcept;
  PictureWriter& operator=(PictureWriter&&) noexcept;

  /// The next `rows.height()` rows, `format.width` wide and not NaN. Of colors a picture of one channel
  /// takes the first; a view of floats is for one channel.
  void write_rows(ImageView<const V3f> rows);
  void write_rows(ImageView<const float> rows);
  /// All `format.height` rows have been written.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A whole picture at once.
void write_picture(const std::string& path, ImageView<const V3f> image, PictureRole role,
                   std::optional<SampleType> samples = {});
void write_picture(const std::string& path, ImageView<const float> image, PictureRole role,
                   std::optional<SampleType> samples = {});

/// Throws Error(usage) unless a picture can be written under the name `path` with `samples`; says which names can.
void check_picture_name(const std::string& path, std::optional<SampleType> samples = {});
/// Throws Error(usage) for a picture that is larger than its kind of file holds: .jpg 65500 pixels on a side, .png a
/// million. The writer throws the same.
void check_picture_size(const std::string& path, int width, int height);

}  // namespace texbake
