// What a bundle may hold at most. A reader checks these before it takes memory.
#pragma once

#include <cstddef>

namespace texbake {

inline constexpr int kMaxTileSize = 16384;                     ///< texels on each axis
inline constexpr size_t kMaxManifestBytes = size_t{64} << 20;  ///< of bundle.json
inline constexpr int kMaxManifestDepth = 64;                   ///< nested arrays and objects
inline constexpr size_t kMaxMembers = 4096;                    ///< of one object in it: looked up one by one
inline constexpr size_t kMaxValues = size_t{1} << 20;  ///< in all of it: each takes up to a hundred bytes of memory
inline constexpr size_t kMaxManifestScales = 16;       ///< coarse to fine
inline constexpr int kMaxParts = 256;                  ///< in one EXR file
inline constexpr size_t kMaxPartChannels = 4;          ///< in one part

}  // namespace texbake
