// A picture that was read, and what is asked for when one is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "formats/limits.h"
#include "formats/picture_values.h"
#include "libbake/base/image.h"

namespace texbake {

inline constexpr int kMaxPictureSide = kMaxTileSize;

/// Whether values that a material cannot have are refused.
enum class PictureValues {
  checked,  ///< NaN, infinity and too large colors are refused, negative colors become 0
  kept,     ///< a frame to compare: only decoded; no value and no number of channels is changed, alpha divides nothing
};

/// Which picture is read, and as what.
struct PictureRequest {
  std::string path;
  InputSpace space = InputSpace::automatic;  ///< counts for PictureRole::color alone
  PictureRole role = PictureRole::color;
  PictureValues values = PictureValues::checked;
  std::string layer = {};  ///< of a file that names its layers; "": the file's own choice
};

struct Picture {
  int channels = 0;        ///< 1 or 3
  Image<float> planes[3];  ///< `channels` of them, all of the same size
  int source_bits = 8;     ///< of one sample in the file
  bool is_float = false;   ///< the file holds floating point
  std::string space;       ///< the curve that was undone: "srgb", "linear", "gamma 1.8"; "linear" unless color
  bool alpha_dropped = false;
  std::string name;                ///< of the file, without its folder
  std::string sha256;              ///< of the file, 64 hex digits
  uint64_t size_bytes = 0;         ///< of the file
  std::vector<std::string> notes;  ///< what a person should know, one sentence each, starting with the path

  int width() const { return planes[0].width(); }
  int height() const { return planes[0].height(); }
};

}  // namespace texbake
