// SHA-256, by OpenSSL: names payload files and guards every plane. Based on: FIPS 180-4.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace texbake {

/// Hashes bytes as they come. After `hex()` the object is spent.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  void update(const void* bytes, size_t count);
  /// 64 lower-case hexadecimal digits.
  std::string hex();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string sha256(std::string_view bytes);
/// Hash of a file's bytes, read in blocks. Throws Error(io) when it cannot be read.
std::string sha256_file(const std::filesystem::path& path);

}  // namespace texbake
