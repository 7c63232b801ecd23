// Opens the file of a picture with the one reader of its format.
#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>
#include <vector>

#include "formats/picture_format.h"

namespace texbake {

/// A file that was opened: everything known before its texels are read.
struct PictureInput {
  std::string path = {};
  FileFormat format = FileFormat::png;
  std::string content = {};                                ///< the file's bytes where it is read from memory
  std::unique_ptr<OIIO::Filesystem::IOProxy> memory = {};  ///< reads `content`
  std::unique_ptr<OIIO::ImageInput> input = {};
  OIIO::ImageSpec spec = {};               ///< of the picture that is read
  int part = 0;                            ///< its place among the pictures of the file
  std::vector<std::string> warnings = {};  ///< what is wrong with the file but changes no texel
};

/// Colors keep their straight alpha, and inks stay inks. Throws Error as check_input_file and picture_format do,
/// Error(unsupported) for what the reader does not know, Error(bad_data) for what is damaged.
std::unique_ptr<PictureInput> open_picture_input(const std::string& path);

/// Goes on to another picture of the file; false where there is none.
bool select_part(PictureInput& open, int part);

/// Throws Error for the words of a reader that failed: unsupported where they say so, else bad_data.
[[noreturn]] void throw_reader_failure(const std::string& path, const std::string& words);

}  // namespace texbake
