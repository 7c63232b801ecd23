// Chooses which channels of a file are the picture.
#pragma once

#include <string>
#include <vector>

#include "formats/picture_values.h"

namespace texbake {

/// Which of a file's channels are read.
struct ChannelChoice {
  std::vector<int> color = {};                 ///< one or three; two, or three by the names X, Y, Z, for a normal map
  int alpha = -1;                              ///< −1: none
  std::string layer = {};                      ///< that they belong to; "" for channels without one
  std::vector<std::string> other_layers = {};  ///< that could have been read instead
  bool is_vector = false;                      ///< channels named X, Y, Z: vectors, not codes
};

/// Of a file whose channels have `names`, such as "R", "diffuse.R", "N.X". The three channels of a color come from one
/// layer: `layer` where it is given (which may name a single channel too), else the channels without a layer, else the
/// first layer that has R, G, B. Names are compared without regard to case. Alpha is that of the same layer; depth is
/// left out, but a single channel "Z" is data.
///
/// Throws Error(usage) when there is no such layer, naming those that there are; Error(unsupported) for luminance with
/// chroma; Error(bad_data) where the channels do not suit `role`.
ChannelChoice choose_channels(const std::string& path, const std::vector<std::string>& names, PictureRole role,
                              const std::string& layer);

/// Does a file whose channels have `names` have `layer`, or a single channel of that name?
bool has_layer(const std::vector<std::string>& names, const std::string& layer);

}  // namespace texbake
