#include "formats/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "libbake/base/error.h"

namespace texbake {

namespace fs = std::filesystem;

void check_input_file(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    throw Error(ErrorKind::io, fmt::format("{}: expected an image file, found no such file; check the path", path));
  if (error) throw Error(ErrorKind::io, fmt::format("{}: cannot be opened: {}", path, error.message()));
  if (fs::is_directory(status))
    throw Error(ErrorKind::io, fmt::format("{}: expected an image file, found a directory{}", path,
                                           path.ends_with(".texbundle") || path.ends_with(".texbundle/")
                                               ? "; a bundle is the input of other verbs"
                                               : "; name a file in it"));
  if (!fs::is_regular_file(status))
    throw Error(ErrorKind::io, fmt::format("{}: expected an image file, found a device, pipe or socket", path));
  if (path.find('?') != std::string::npos)  // OpenImageIO takes what follows it as settings
    throw Error(ErrorKind::io, fmt::format("{}: a file name that contains '?' cannot be read; rename the file", path));
  if (!std::ifstream(path, std::ios::binary))
    throw Error(ErrorKind::io, fmt::format("{}: cannot be opened: {}", path, std::strerror(errno)));
  if (fs::file_size(path, error) == 0)
    throw Error(ErrorKind::bad_data, fmt::format("{}: expected an image, found an empty file (0 bytes)", path));
}

bool is_forbidden(const fs::path& path) {
  return ::faccessat(AT_FDCWD, path.c_str(), R_OK, AT_EACCESS) != 0 && errno == EACCES;
}

std::string file_bytes(const std::string& path, size_t most) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(ErrorKind::io, fmt::format("{}: cannot be opened: {}", path, std::strerror(errno)));
  if (most == std::string::npos) return {std::istreambuf_iterator<char>(stream), {}};
  std::string bytes(most, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<size_t>(stream.gcount()));
  return bytes;
}

}  // namespace texbake
