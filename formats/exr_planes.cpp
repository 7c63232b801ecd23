#include "formats/exr_planes.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfThreading.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>

#include "formats/exr_header.h"
#include "formats/input_file.h"
#include "formats/json_text.h"
#include "formats/limits.h"
#include "formats/sha256.h"

namespace texbake {
namespace {

static_assert(std::endian::native == std::endian::little, "canonical bytes are little-endian");

constexpr int kZipLevel = 4;  // OpenEXR's own default since 3.1.3, named so that another default changes no bytes
constexpr size_t kBlockBytes = size_t{8} << 20;  // of the rows handed to OpenEXR at once
constexpr int kZipRows = 16;                     // rows in one ZIP block
constexpr size_t kMaxZipRatio = 1100;            // deflate cannot reach 1032
constexpr size_t kMaxShownNames = 300;           // bytes of what a file calls its parts, in a message
constexpr size_t kMaxShownKind = 60;

Imf::PixelType imf_type(PixelType type) {
  if (type == PixelType::uint) return Imf::UINT;
  return type == PixelType::half ? Imf::HALF : Imf::FLOAT;
}

/// As many threads for compression as the caller allows everything else.
int use_threads() {
  const auto count = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const int threads = count > 1 ? static_cast<int>(count) : 0;
  if (Imf::globalThreadCount() != threads) Imf::setGlobalThreadCount(threads);
  return threads;
}

int rows_at_once(const PlaneShape& shape) {
  const size_t rows = kBlockBytes / std::max<size_t>(shape.row_bytes(), 1) / kZipRows * kZipRows;
  return static_cast<int>(std::clamp<size_t>(rows, kZipRows, 4096));
}

/// Rows y0 … of a block in canonical order, as OpenEXR addresses them.
Imf::FrameBuffer frame_buffer(const PlaneShape& shape, std::byte* block, int y0) {
  Imf::FrameBuffer frame;
  const size_t value = bytes_of(shape.type);
  for (size_t c = 0; c < shape.channels.size(); ++c) {
    const Imath::Box2i window(V2i(0, y0), V2i(shape.width - 1, y0 + 1));
    std::byte* channel = block + c * static_cast<size_t>(shape.width) * value;
    frame.insert(shape.channels[c], Imf::Slice::Make(imf_type(shape.type), channel, window, value, shape.row_bytes()));
  }
  return frame;
}

Imf::Header header_of(const PlaneShape& shape, V2i size) {
  Imf::Header header(Imath::Box2i(V2i(0, 0), size - V2i(1, 1)),
                     Imath::Box2i(V2i(0, 0), V2i(shape.width - 1, shape.height - 1)));
  header.setName(shape.part);
  header.setType(Imf::SCANLINEIMAGE);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.zipCompressionLevel() = kZipLevel;
  for (const std::string& channel : shape.channels)
    header.channels().insert(channel, Imf::Channel(imf_type(shape.type)));
  return header;
}

/// Hands OpenEXR's bytes to a SafeFile.
class SafeStream : public Imf::OStream {
 public:
  explicit SafeStream(SafeFile& file) : Imf::OStream("payload"), file_(file) {}
  // OpenEXR swallows what is thrown while it closes a file: it is kept for `rethrow`.
  void write(const char* bytes, int count) override {
    guard([&] { file_.write(bytes, static_cast<size_t>(count)); });
  }
  uint64_t tellp() override { return file_.position(); }
  void seekp(uint64_t position) override {
    guard([&] { file_.seek(position); });
  }
  void rethrow() const {
    if (failure_) throw *failure_;
  }

 private:
  template <class Action>
  void guard(const Action& action) {
    try {
      action();
    } catch (const Error& error) {
      failure_ = error;
      throw;
    }
  }

  SafeFile& file_;
  std::optional<Error> failure_;
};

void write_part(Imf::OutputPart& output, const ExrPart& part) {
  const int rows = rows_at_once(part.shape);
  std::vector<std::byte> block(part.shape.row_bytes() * static_cast<size_t>(std::min(rows, part.shape.height)));
  for (int y0 = 0; y0 < part.shape.height; y0 += rows) {
    const int count = std::min(rows, part.shape.height - y0);
    for (int y = 0; y < count; ++y) part.row(y0 + y, block.data() + static_cast<size_t>(y) * part.shape.row_bytes());
    output.setFrameBuffer(frame_buffer(part.shape, block.data(), y0));
    output.writePixels(count);
  }
}

}  // namespace

std::string pixel_hash(const ExrPart& part) {
  Sha256 hash;
  std::vector<std::byte> row(part.shape.row_bytes());
  for (int y = 0; y < part.shape.height; ++y) {
    part.row(y, row.data());
    hash.update(row.data(), row.size());
  }
  return hash.hex();
}

void write_exr(SafeFile& file, V2i size, const std::vector<ExrPart>& parts) {
  std::vector<Imf::Header> headers;
  for (const ExrPart& part : parts) headers.push_back(header_of(part.shape, size));
  SafeStream stream(file);
  try {
    Imf::MultiPartOutputFile output(stream, headers.data(), static_cast<int>(headers.size()), false, use_threads());
    for (size_t i = 0; i < parts.size(); ++i) {
      Imf::OutputPart part(output, static_cast<int>(i));
      write_part(part, parts[i]);
    }
  } catch (const Iex::BaseExc& error) {
    stream.rethrow();
    throw Error(ErrorKind::io, fmt::format("{}: {}", file.temporary_path().string(), error.what()));
  }
  stream.rethrow();
}

struct ExrReader::File {
  std::filesystem::path path;
  std::uintmax_t bytes = 0;
  std::vector<ExrPartHeader> parts;
  std::unique_ptr<Imf::MultiPartInputFile> input;

  std::string name() const { return path.filename().string(); }
  Place place(const std::string& part = {}) const { return {.file = name(), .part = part}; }
  /// Number of the part, or −1.
  int find(const std::string& part) const {
    const auto found = std::ranges::find(parts, part, &ExrPartHeader::name);
    return found == parts.end() ? -1 : static_cast<int>(found - parts.begin());
  }
  bool may_be_opened(IssueLog& log);
};

/// Reads the headers; OpenEXR gets to see nothing but scan lines in the compression that the specification names.
bool ExrReader::File::may_be_opened(IssueLog& log) {
  ExrHeaders headers = read_exr_headers(path);
  if (!headers.fault.empty()) {
    log.add({IssueId::exr_unreadable, place(), fmt::format("expected OpenEXR headers, found {}", headers.fault)});
    return false;
  }
  for (const ExrPartHeader& part : headers.parts) {
    if (part.kind != kExrScanLines)
      log.add({IssueId::part_kind, place(part.name),
               fmt::format("expected {}, found {}", kExrScanLines, shortened(part.kind, kMaxShownKind))});
    if (part.compression != kExrZip)
      log.add({IssueId::part_compression, place(part.name),
               fmt::format("expected ZIP, which is number {} of OpenEXR, found {}", kExrZip, part.compression)});
  }
  parts = std::move(headers.parts);
  return std::ranges::all_of(
      parts, [](const ExrPartHeader& part) { return part.kind == kExrScanLines && part.compression == kExrZip; });
}

ExrReader::ExrReader(const std::filesystem::path& path, IssueLog& log) : file_(std::make_unique<File>()) {
  file_->path = path;
  if (is_forbidden(path)) {
    log.add({IssueId::file_unreadable, file_->place(),
             fmt::format("expected a readable file, found: {}", std::strerror(EACCES))});
    return;
  }
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) {
    log.add({IssueId::file_missing, file_->place(), "expected the file, found nothing"});
    return;
  }
  file_->bytes = std::filesystem::file_size(path, failed);
  if (!file_->may_be_opened(log)) return;
  try {
    file_->input =
        std::make_unique<Imf::MultiPartInputFile>(path.c_str(), use_threads(), /*reconstructChunkOffsetTable=*/false);
    if (file_->input->parts() == static_cast<int>(file_->parts.size())) return;
    log.add({IssueId::exr_unreadable, file_->place(),
             fmt::format("expected {} parts, found {}", file_->parts.size(), file_->input->parts())});
  } catch (const std::exception& error) {
    log.add({IssueId::exr_unreadable, file_->place(), fmt::format("expected OpenEXR, found: {}", error.what())});
  }
  file_->input.reset();
}

ExrReader::~ExrReader() = default;
ExrReader::ExrReader(ExrReader&&) noexcept = default;

bool ExrReader::is_open() const { return file_->input != nullptr; }

std::vector<std::string> ExrReader::part_names() const {
  std::vector<std::string> names;
  for (const ExrPartHeader& part : file_->parts) names.push_back(part.name);
  return names;
}

bool ExrReader::holds(const PlaneShape& shape, IssueLog& log) const {
  const auto refuse = [&](IssueId id, const std::string& detail) {
    log.add({id, file_->place(shape.part), detail});
    return false;
  };
  const int number = file_->find(shape.part);
  if (number < 0)
    return refuse(IssueId::part_missing,
                  fmt::format("expected the part, found {}",
                              shortened(fmt::format("{}", fmt::join(part_names(), ", ")), kMaxShownNames)));
  const ExrPartHeader& part = file_->parts[static_cast<size_t>(number)];
  if (part.low != V2i(0, 0) || part.high != V2i(shape.width - 1, shape.height - 1))
    return refuse(IssueId::part_window,
                  fmt::format("expected the data window (0, 0) - ({}, {}), found ({}, {}) - ({}, {})", shape.width - 1,
                              shape.height - 1, part.low.x, part.low.y, part.high.x, part.high.y));
  if (part.channels.size() > kMaxPartChannels)
    return refuse(IssueId::part_channels,
                  fmt::format("expected at most {} channels, found {}", kMaxPartChannels, part.channels.size()));
  for (const std::string& name : shape.channels) {
    const auto channel = std::ranges::find(part.channels, name, &ExrChannel::name);
    if (channel == part.channels.end())
      return refuse(IssueId::part_channels, fmt::format("expected the channel {}, found none", name));
    if (channel->type != shape.type || channel->sampling != V2i(1, 1))
      return refuse(IssueId::part_channels,
                    fmt::format("expected the channel {} as {} for every texel, found another type or sampling", name,
                                name_of(shape.type)));
  }
  return true;
}

bool ExrReader::has_room_for(const std::vector<PlaneShape>& shapes, IssueLog& log) const {
  size_t promised = 0;
  for (const PlaneShape& shape : shapes)
    promised += static_cast<size_t>(shape.width) * static_cast<size_t>(shape.height) *
                file_->parts[static_cast<size_t>(file_->find(shape.part))].texel_bytes();
  if (promised / kMaxZipRatio <= file_->bytes) return true;
  log.add({IssueId::file_too_small, file_->place(),
           fmt::format("expected {} bytes of pixels, found a file of {} bytes", promised, file_->bytes)});
  return false;
}

std::string ExrReader::read(const PlaneShape& shape, const std::function<void(int, const std::byte*)>& row,
                            IssueLog& log) const {
  try {
    Imf::InputPart part(*file_->input, file_->find(shape.part));
    const int rows = rows_at_once(shape);
    std::vector<std::byte> block(shape.row_bytes() * static_cast<size_t>(std::min(rows, shape.height)));
    Sha256 hash;
    for (int y0 = 0; y0 < shape.height; y0 += rows) {
      const int count = std::min(rows, shape.height - y0);
      part.setFrameBuffer(frame_buffer(shape, block.data(), y0));
      part.readPixels(y0, y0 + count - 1);
      const size_t bytes = shape.row_bytes() * static_cast<size_t>(count);
      hash.update(block.data(), bytes);
      for (int y = 0; y < count; ++y) row(y0 + y, block.data() + static_cast<size_t>(y) * shape.row_bytes());
    }
    return hash.hex();
  } catch (const Iex::BaseExc& error) {
    log.add(
        {IssueId::exr_unreadable, file_->place(shape.part), fmt::format("expected all rows, found: {}", error.what())});
    return {};
  }
}

}  // namespace texbake
