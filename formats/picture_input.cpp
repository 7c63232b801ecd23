#include "formats/picture_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "formats/dds_check.h"
#include "formats/input_file.h"
#include "formats/jpeg_check.h"
#include "libbake/base/error.h"

namespace texbake {
namespace {

constexpr int kTiffSeparated = 5;  // TIFF 6.0, PhotometricInterpretation: inks

// The decoder's own words on one line.
std::string one_line(std::string words) {
  while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back()))) words.pop_back();
  std::replace(words.begin(), words.end(), '\n', ';');
  return words.empty() ? "the decoder gives no reason" : words;
}

bool says_unsupported(const std::string& words) {
  const std::string low = OIIO::Strutil::lower(words);
  for (const char* word : {"support", "not implemented", "unimplemented"})
    if (low.find(word) != std::string::npos) return true;
  return false;
}

void check_dds_file(const std::string& path) {
  check_dds(path, file_bytes(path, kDdsHeaderBytes), std::filesystem::file_size(path));
}

bool open_reader(PictureInput& open, OIIO::ImageSpec settings) {
  settings["oiio:UnassociatedAlpha"] = 1;  // else the color of PNG is multiplied by alpha
  if (open.memory) {
    OIIO::Filesystem::IOProxy* const memory = open.memory.get();
    settings.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &memory);
  }
  open.input = OIIO::ImageInput::create(decoder_name(open.format));
  if (!open.input)
    throw Error(ErrorKind::unsupported,
                fmt::format("{}: {}: this build has no reader for it", open.path, format_name(open.format)));
  return open.input->open(open.path, open.spec, settings);
}

// A JPEG file whose end marker is missing is handed to the reader with one.
void complete_jpeg(PictureInput& open) {
  std::string bytes = file_bytes(open.path);
  if (!lacks_only_end_marker(bytes)) return;
  open.content = std::move(bytes) + "\xff\xd9";
  open.memory = std::make_unique<OIIO::Filesystem::IOMemReader>(open.content.data(), open.content.size());
  open.warnings.push_back("its end marker is missing: read as far as it goes");
}

}  // namespace

void throw_reader_failure(const std::string& path, const std::string& words) {
  if (says_unsupported(words))
    throw Error(ErrorKind::unsupported,
                fmt::format("{}: expected an image of a kind that is supported, found another ({}); export it as a "
                            "plain PNG, TIFF or OpenEXR",
                            path, one_line(words)));
  throw Error(
      ErrorKind::bad_data,
      fmt::format("{}: expected a complete image, found a truncated or damaged file ({}); copy or export it again",
                  path, one_line(words)));
}

std::unique_ptr<PictureInput> open_picture_input(const std::string& path) {
  check_input_file(path);
  auto open = std::make_unique<PictureInput>();
  open->path = path;
  open->format = picture_format(path);
  if (open->format == FileFormat::jpeg) complete_jpeg(*open);
  if (open->format == FileFormat::dds) check_dds_file(path);
  if (!open_reader(*open, {})) throw_reader_failure(path, open->input->geterror());

  // Inks are read as they are: OpenImageIO's own conversion knows no profile, and overruns tiles.
  if (open->format == FileFormat::tiff &&
      open->spec.get_int_attribute("tiff:PhotometricInterpretation") == kTiffSeparated) {
    OIIO::ImageSpec settings;
    settings["oiio:RawColor"] = 1;
    open->input->close();
    if (!open_reader(*open, settings)) throw_reader_failure(path, open->input->geterror());
  }
  return open;
}

bool select_part(PictureInput& open, int part) {
  if (!open.input->seek_subimage(part, 0)) {
    open.input->geterror();  // else it waits for the next call
    return false;
  }
  open.spec = open.input->spec();
  open.part = part;
  return true;
}

}  // namespace texbake
