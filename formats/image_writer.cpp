#include "formats/image_writer.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <exception>
#include <filesystem>
#include <string_view>
#include <vector>

#include "formats/safe_file.h"
#include "formats/srgb_codes.h"
#include "libbake/base/half.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

constexpr int kRowsWritten = 64;  // rows encoded at a time: a band of the widest picture is 12 MB

// The kinds of file, and the sample types each holds, the usual first.
struct Kind {
  std::string_view extension;
  const char* plugin;
  std::vector<SampleType> samples;
  int max_side = 1 << 30;
};

constexpr int kMaxJpegSide = 65500;   // of libjpeg, JPEG_MAX_DIMENSION; beyond it the library ends the program
constexpr int kMaxPngSide = 1000000;  // of libpng, PNG_USER_WIDTH_MAX

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> list = {
      {"png", "png", {SampleType::uint8, SampleType::uint16}, kMaxPngSide},
      {"exr", "openexr", {SampleType::half, SampleType::float32}},
      {"tif", "tiff", {SampleType::uint8, SampleType::uint16, SampleType::float32}},
      {"tiff", "tiff", {SampleType::uint8, SampleType::uint16, SampleType::float32}},
      {"jpg", "jpeg", {SampleType::uint8}, kMaxJpegSide},
      {"jpeg", "jpeg", {SampleType::uint8}, kMaxJpegSide},
  };
  return list;
}

const Kind& kind_of(const std::string& path, std::optional<SampleType> samples) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  const auto kind =
      std::find_if(kinds().begin(), kinds().end(), [&](const Kind& k) { return k.extension == extension; });
  if (kind == kinds().end())
    throw Error(ErrorKind::usage,
                fmt::format("{}: expected a picture name ending in .png, .exr, .tif or .jpg, found {}", path,
                            extension.empty() ? "no extension" : "." + extension));
  if (samples && std::find(kind->samples.begin(), kind->samples.end(), *samples) == kind->samples.end()) {
    std::string can;
    for (const SampleType type : kind->samples) can += (can.empty() ? "" : " or ") + std::string(enum_name(type));
    throw Error(ErrorKind::usage, fmt::format("{}: expected {} bits for .{}, found {}; choose another name or depth",
                                              path, can, extension, enum_name(*samples)));
  }
  return *kind;
}

OIIO::TypeDesc oiio_type(SampleType type) {
  switch (type) {
    case SampleType::uint8:
      return OIIO::TypeDesc::UINT8;
    case SampleType::uint16:
      return OIIO::TypeDesc::UINT16;
    case SampleType::half:
      return OIIO::TypeDesc::HALF;
    default:
      return OIIO::TypeDesc::FLOAT;
  }
}

// Lets an encoder write into a SafeFile. Encoders are C: what the file throws waits here until they have returned.
class SafeFileProxy : public OIIO::Filesystem::IOProxy {
 public:
  SafeFileProxy(SafeFile& file, const std::string& name) : IOProxy(name, Write), file_(file) {}
  const char* proxytype() const override { return "texbake"; }
  void close() override { m_mode = Closed; }
  int64_t tell() override { return static_cast<int64_t>(file_.position()); }
  bool seek(int64_t offset) override {
    return guarded([&] {
      file_.seek(static_cast<uint64_t>(offset));
      size_ = std::max(size_, file_.position());
    });
  }
  size_t write(const void* bytes, size_t count) override {
    const bool written = guarded([&] {
      file_.write(bytes, count);
      size_ = std::max(size_, file_.position());
    });
    return written ? count : 0;
  }
  size_t size() const override { return static_cast<size_t>(size_); }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  template <class Action>
  bool guarded(const Action& action) {
    if (failure_) return false;
    try {
      action();
    } catch (...) {
      failure_ = std::current_exception();
    }
    return !failure_;
  }

  SafeFile& file_;
  uint64_t size_ = 0;
  std::exception_ptr failure_;
};

// One value as it is stored in a float file.
float stored_float(float value, SampleType type) {
  assert(!std::isnan(value));
  return type == SampleType::half ? std::clamp(value, -kLargestHalf, kLargestHalf) : value;
}

Image<float> first_channel(ImageView<const V3f> rows) {
  Image<float> channel(rows.width(), rows.height());
  for (int y = 0; y < rows.height(); ++y)
    for (int x = 0; x < rows.width(); ++x) channel(x, y) = rows(x, y).x;
  return channel;
}

}  // namespace

struct PictureWriter::State {
  State(const std::string& target, const PictureFormat& wanted, const Kind& kind)
      : path(target),
        format(wanted),
        samples(wanted.samples.value_or(kind.samples.front())),
        file(resolved(target)),
        proxy(file, target),
        output(OIIO::ImageOutput::create(kind.plugin)) {
    if (is_integer() && format.role == PictureRole::color) srgb.emplace(bits());
    spec = OIIO::ImageSpec(format.width, format.height, format.channels, oiio_type(samples));
    if (format.channels == 1) spec.channelnames = {"Y"};
    spec.attribute("DateTime", "");  // else OpenEXR and TIFF store the time of writing
    const bool is_tiff = kind.extension.starts_with('t');
    // A color space in TIFF needs a second directory, for which the file would have to be read while it is written.
    if (srgb && !is_tiff) spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("compression", kind.extension.starts_with('j') ? "jpeg:95" : "zip");
    if (!output)
      throw Error(ErrorKind::unsupported, fmt::format("{}: this build cannot write .{}", path, kind.extension));
  }

  // Through a symbolic link, the file it points to is replaced; anything but a plain file is not.
  static std::filesystem::path resolved(const std::string& target) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(target, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
      throw Error(ErrorKind::io, fmt::format("{}: expected a file to write, found a {}; choose another name", target,
                                             std::filesystem::is_directory(status) ? "directory" : "device or pipe"));
    return std::filesystem::is_symlink(std::filesystem::symlink_status(target, error)) &&
                   std::filesystem::exists(status)
               ? std::filesystem::canonical(target)
               : std::filesystem::path(target);
  }

  bool is_integer() const { return samples == SampleType::uint8 || samples == SampleType::uint16; }
  int bits() const { return samples == SampleType::uint8 ? 8 : 16; }

  void check(bool done) {
    proxy.rethrow();
    if (!done) throw Error(ErrorKind::io, fmt::format("{}: cannot be written: {}", path, output->geterror()));
  }

  uint16_t code(float value) const {
    if (srgb) return (*srgb)(value);
    return format.role == PictureRole::normal ? code_from_normal(value, bits()) : code_from_unit(value, bits());
  }

  // Encodes `count` samples of one row and writes `height` rows that way.
  template <class Sample, class Encode>
  void write_bands(const float* values, int height, const Encode& encode) {
    const size_t row_samples = static_cast<size_t>(format.width) * static_cast<size_t>(format.channels);
    std::vector<Sample> band(row_samples * static_cast<size_t>(std::min(height, kRowsWritten)));
    for (int begin = 0; begin < height; begin += kRowsWritten) {
      const int end = std::min(begin + kRowsWritten, height);
      parallel_for(begin, end, [&](int y) {
        const float* from = values + static_cast<size_t>(y) * row_samples;
        Sample* to = band.data() + static_cast<size_t>(y - begin) * row_samples;
        for (size_t i = 0; i < row_samples; ++i) to[i] = encode(from[i]);
      });
      const auto type = OIIO::TypeDesc(OIIO::BaseTypeFromC<Sample>::value);
      check(output->write_scanlines(rows_written, rows_written + end - begin, 0, type, band.data()));
      rows_written += end - begin;
    }
  }

  /// Only for the first row: libpng complains aloud of a file that is given up before it.
  void open() {
    output->set_ioproxy(&proxy);
    check(output->open(path, spec));
  }

  void write_rows(const float* values, int height) {
    assert(rows_written + height <= format.height);
    if (rows_written == 0) open();
    if (samples == SampleType::uint8)
      write_bands<uint8_t>(values, height, [&](float value) { return static_cast<uint8_t>(code(value)); });
    else if (samples == SampleType::uint16)
      write_bands<uint16_t>(values, height, [&](float value) { return code(value); });
    else
      write_bands<float>(values, height, [&](float value) { return stored_float(value, samples); });
  }

  std::string path;
  PictureFormat format;
  SampleType samples;
  std::optional<SrgbEncoder> srgb;
  OIIO::ImageSpec spec;
  int rows_written = 0;
  SafeFile file;  // outlives the encoder, which may write when it is destroyed
  SafeFileProxy proxy;
  std::unique_ptr<OIIO::ImageOutput> output;
};

PictureWriter::PictureWriter(const std::string& path, const PictureFormat& format) {
  assert(format.width > 0 && format.height > 0 && (format.channels == 1 || format.channels == 3));
  check_picture_size(path, format.width, format.height);
  state_ = std::make_unique<State>(path, format, kind_of(path, format.samples));
}
PictureWriter::~PictureWriter() = default;
PictureWriter::PictureWriter(PictureWriter&&) noexcept = default;
PictureWriter& PictureWriter::operator=(PictureWriter&&) noexcept = default;

void PictureWriter::write_rows(ImageView<const V3f> rows) {
  assert(rows.width() == state_->format.width);
  if (state_->format.channels == 1) return write_rows(first_channel(rows));
  static_assert(sizeof(V3f) == 3 * sizeof(float));
  state_->write_rows(&rows.data()->x, rows.height());
}

void PictureWriter::write_rows(ImageView<const float> rows) {
  assert(state_->format.channels == 1 && rows.width() == state_->format.width);
  state_->write_rows(rows.data(), rows.height());
}

void PictureWriter::close() {
  assert(state_->rows_written == state_->format.height);
  state_->check(state_->output->close());
  state_->file.commit();
  state_.reset();
}

void write_picture(const std::string& path, ImageView<const V3f> image, PictureRole role,
                   std::optional<SampleType> samples) {
  PictureWriter writer(path, {image.width(), image.height(), 3, role, samples});
  writer.write_rows(image);
  writer.close();
}

void write_picture(const std::string& path, ImageView<const float> image, PictureRole role,
                   std::optional<SampleType> samples) {
  PictureWriter writer(path, {image.width(), image.height(), 1, role, samples});
  writer.write_rows(image);
  writer.close();
}

void check_picture_name(const std::string& path, std::optional<SampleType> samples) { kind_of(path, samples); }

void check_picture_size(const std::string& path, int width, int height) {
  const Kind& kind = kind_of(path, {});
  if (std::max(width, height) > kind.max_side)
    throw Error(ErrorKind::usage,
                fmt::format("{}: expected at most {} pixels on a side of a .{}, found {} x {}; choose .exr or .tif",
                            path, kind.max_side, kind.extension, width, height));
}

}  // namespace texbake
