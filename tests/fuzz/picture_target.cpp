// What is read of a picture before and beside its decoder: kinds of files, chunks, markers, headers, color profiles.
#include <zlib.h>

#include <algorithm>
#include <filesystem>

#include "formats/bundle_io.h"
#include "formats/byte_order.h"
#include "formats/dds_check.h"
#include "formats/exif_color.h"
#include "formats/exr_header.h"
#include "formats/icc_profile.h"
#include "formats/jpeg_check.h"
#include "formats/picture_format.h"
#include "formats/png_check.h"
#include "tests/formats/profile_fixtures.h"
#include "tests/fuzz/sound_bundles.h"
#include "tests/fuzz/target.h"

namespace texbake::fuzz {
namespace {

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1a\n", 8);

std::string big_endian_bytes(uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

std::string checksum_of(std::string_view kind_and_content) {
  const auto* bytes = reinterpret_cast<const Bytef*>(kind_and_content.data());
  return big_endian_bytes(static_cast<uint32_t>(crc32(0, bytes, static_cast<uInt>(kind_and_content.size()))));
}

std::string chunk(const std::string& kind, const std::string& content) {
  return big_endian_bytes(static_cast<uint32_t>(content.size())) + kind + content + checksum_of(kind + content);
}

/// One row of one gray texel, stored; what the chunks say of colors is made up.
std::string png_seed() {
  const std::string header = big_endian_bytes(1) + big_endian_bytes(1) + std::string("\x08\0\0\0\0", 5);
  const std::string row("\x78\x01\x01\x02\0\xfd\xff\0\x07\0\x09\0\x08", 13);
  return std::string(kPngSignature) + chunk("IHDR", header) + chunk("cICP", std::string("\x01\x0d\0\x01", 4)) +
         chunk("gAMA", big_endian_bytes(45455)) + chunk("cHRM", std::string(32, '\x10')) +
         chunk("sRGB", std::string(1, '\0')) + chunk("tEXt", std::string("a\0b", 3)) + chunk("IDAT", row) +
         chunk("IEND", "");
}

/// Checksums as the chunks have them now, as far as there are chunks.
std::string with_checksums(std::string png) {
  size_t at = kPngSignature.size();
  while (at + 12 <= png.size()) {
    const uint64_t size = big_endian(png, at, 4);
    if (size > png.size() - at - 12) break;
    png.replace(at + 8 + size, 4, checksum_of(std::string_view(png).substr(at + 4, 4 + size)));
    at += 12 + size;
  }
  return png;
}

/// EXIF data that lead by two tables to the index "R03"; a scan of two bytes.
std::string jpeg_seed() {
  const auto entry = [](const char* tag_and_type, char count, const char* value) {
    return std::string(tag_and_type, 4) + count + std::string(3, '\0') + std::string(value, 4);
  };
  const std::string end(4, '\0');
  const std::string tiff = std::string("II*\0\x08\0\0\0", 8) + std::string("\x01\0", 2) +
                           entry("\x69\x87\x04\0", 1, "\x1a\0\0\0") + end + std::string("\x01\0", 2) +
                           entry("\x05\xa0\x04\0", 1, "\x2c\0\0\0") + end + std::string("\x01\0", 2) +
                           entry("\x01\0\x02\0", 4, "R03\0") + end;
  const auto segment = [](char marker, const std::string& content) {
    return std::string("\xff") + marker + big_endian_bytes(static_cast<uint32_t>(content.size() + 2)).substr(2) +
           content;
  };
  return "\xff\xd8" + segment('\xe1', std::string("Exif\0\0", 6) + tiff) +
         segment('\xc0', std::string("\x08\0\x01\0\x01\x01\x01\x11\0", 9)) +
         segment('\xda', std::string("\x01\x01\0\0\x3f\0", 6)) + "\x12\xff" + std::string(1, '\0') + "\xff\xd9";
}

/// Four texels of 32 bits by masks.
std::string dds_seed() {
  std::string bytes = "DDS ";
  const auto append = [&](std::initializer_list<uint32_t> values) {
    for (const uint32_t value : values)
      for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
  };
  append({124, 0x100f, 2, 2, 8, 0, 0});
  bytes.append(44, '\0');
  append({32, 0x41, 0, 32, 0xff0000, 0xff00, 0xff, 0xff000000, 0x1000, 0, 0, 0, 0});
  return bytes + std::string(16, '\x7f');
}

std::string exr_seed() {
  const std::filesystem::path folder = scratch() / "exr.texbundle";
  write_bundle(sound_bundles()[0], folder);
  for (const auto& [name, bytes] : files_of(folder))
    if (name.ends_with(".exr")) return bytes;
  return {};
}

std::vector<std::string> picture_seeds() {
  const Chromaticities rec709{{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}}};
  return {png_seed(), jpeg_seed(), dds_seed(), exr_seed(), profile_bytes(rec709, 2.2, "a name"), ink_profile_bytes()};
}

/// Of a file of pixels, its headers.
std::string mutate_picture(const std::string& input, Random& random) {
  const size_t head = std::min<size_t>(input.size(), 3000);
  const std::string changed = mutate_bytes(input.substr(0, head), random) + input.substr(head);
  return changed.starts_with(kPngSignature) && random.below(4) != 0 ? with_checksums(changed) : changed;
}

/// A message is what a reader may answer.
template <class Read>
void attempt(const Read& read) {
  try {
    read();
  } catch (const Error&) {
  }
}

void convert_some(const IccProfile& profile) {
  constexpr int kTexels = 3;
  const float encoded[kTexels * 4] = {0, 0.5f, 1, 0.25f, 1, 1, 1, 1, 0.01f, 0.99f, 0.7f, 0.3f};
  float linear[kTexels * 3];
  if (profile.transform && profile.channels <= 4) profile.transform->apply(encoded, linear, kTexels);
}

void run_picture(const std::string& input) {
  const std::string path = (scratch() / "picture").string();
  write_file(path, input);
  attempt([&] { format_name(picture_format(path)); });
  attempt([&] { check_png(path); });
  attempt([&] {
    if (input.size() >= kDdsHeaderBytes)
      check_dds(path, std::string_view(input).substr(0, kDdsHeaderBytes), input.size());
  });
  lacks_only_end_marker(input);
  says_adobe_rgb(input);
  read_exr_headers(path);
  if (const auto profile = read_icc_profile(input)) convert_some(*profile);
}

}  // namespace

const Target kPicture = {"picture", picture_seeds, mutate_picture, run_picture};

}  // namespace texbake::fuzz
