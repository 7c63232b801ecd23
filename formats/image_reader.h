// Reads a picture of any format into planes of linear light, data, or normal vectors.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "formats/limits.h"
#include "formats/picture_values.h"
#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

inline constexpr int kMaxPictureSide = kMaxTileSize;

/// Whether values that a material cannot have are refused.
enum class PictureValues {
  checked,  ///< NaN, infinity and too large colours are refused, negative colours become 0
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

/// Reads the first picture of the file at `request.path`, upright: the EXIF orientation is applied.
///
/// Integers of b bits are divided by 2^b − 1; normal maps follow formats/srgb_codes.h. A float normal map that holds
/// negative components is taken as vectors already, else as 0 … 1. `space` counts for PictureRole::color alone.
/// Palettes and 1, 2, 4 bits are expanded. Alpha is dropped, and premultiplied colour divided by it. Data whose three
/// channels are equal everywhere has one channel. Colours are ≥ 0 and ≤ 65504, the largest half float: negative ones
/// become 0.
///
/// Throws Error(io) when the file cannot be opened; Error(unsupported) for deep or volume pictures and turned normal
/// maps; Error(bad_data) for what is not a picture, is cut off or damaged, is larger than kMaxPictureSide, has a number
/// of channels that does not suit `role`, or holds NaN, infinity or colours above 65504 (their count and first texel).
Picture read_picture(const PictureRequest& request);

/// Three planes as one image. All have the same size.
Image<V3f> interleave(const Image<float> (&planes)[3]);

}  // namespace texbake
