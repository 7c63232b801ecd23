// The planes of a scale: how the images in memory and the parts of a file correspond. One list serves writing, reading,
// hashing and the range checks.
#pragma once

#include <functional>
#include <limits>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "formats/bundle.h"
#include "formats/exr_planes.h"

namespace texbake {

/// The values a channel may have; others raise `id`, NaN and infinity raise not_finite.
struct ChannelRange {
  double low = 0;
  double high = 0;
  IssueId id = IssueId::not_finite;
};

inline constexpr double kAnyFloat = std::numeric_limits<float>::max();

/// Whether planes made from a T can be filled: a scale that is only read is const.
template <class T>
inline constexpr bool writable = !std::is_const_v<std::remove_reference_t<T>>;

/// One plane. Rows pass as float (half and float planes) or as uint32_t (uint planes), channel by channel.
struct ScalePlane {
  std::string key;  ///< member of `planes` in the manifest, or "map.NAME"
  PlaneShape shape;
  std::vector<ChannelRange> ranges;  ///< one for each channel
  std::function<void(int channel, int y, float* row)> get_floats;
  std::function<void(int channel, int y, uint32_t* row)> get_labels;
  std::function<void(int channel, int y, const float* row)> put_floats;  ///< empty for a scale that is only read
  std::function<void(int channel, int y, const uint32_t* row)> put_labels;
};

inline constexpr const char* kMapKey = "map.";  ///< before the name of a map: its part
inline constexpr const char* kMasksKey = "masks";

/// The planes that a scale has, in the order in which they are written. `exemplar` shares the part `preview`.
std::vector<ScalePlane> planes_of(const Scale& scale);
/// The same to be filled, with a tile of `size`: by those that `allocate_planes` has made room for.
std::vector<ScalePlane> planes_of(Scale& scale, V2i size);

/// Makes the images of `size` and the tables that the planes `keys` fill, and no others; `scale.maps` and `scale.masks`
/// have their number already.
void allocate_planes(Scale& scale, V2i size, size_t fragment_count, const std::set<std::string>& keys);

/// The data window of a table of `count` rows stored as a plane: as wide as the tile, filled by rows.
V2i table_size(size_t count, V2i tile);

/// Owner offset as stored: (x + 1) + 3 (y + 1); 4 is (0, 0).
uint32_t owner_code(OwnerOffset owner);
OwnerOffset owner_of(uint32_t code);

/// A plane for write_exr.
ExrPart exr_part(const ScalePlane& plane);

}  // namespace texbake
