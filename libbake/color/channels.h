// The least and greatest value of each channel, so that filters do not overshoot.
#pragma once

#include <algorithm>
#include <utility>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

inline float least_of(float a, float b) { return std::min(a, b); }
inline float greatest_of(float a, float b) { return std::max(a, b); }
inline V3f least_of(const V3f& a, const V3f& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
inline V3f greatest_of(const V3f& a, const V3f& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// (least, greatest) of a picture with at least one texel, each channel by itself.
template <class T>
std::pair<T, T> channel_range(ImageView<const T> image) {
  std::pair<T, T> range(image(0, 0), image(0, 0));
  for (const T& value : image) range = {least_of(range.first, value), greatest_of(range.second, value)};
  return range;
}

template <class T>
T clamp_channels(const T& value, const T& low, const T& high) {
  return least_of(greatest_of(value, low), high);
}

}  // namespace texbake
