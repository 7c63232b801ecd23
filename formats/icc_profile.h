// What an ICC profile says: curves and primaries where it is that simple, a transform of Little CMS where it is not.
// Based on: ICC.1:2010.
#pragma once

#include <Imath/ImathMatrix.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/picture_values.h"

namespace texbake {

/// A transform to linear Rec.709, relative to white.
class IccTransform {
 public:
  virtual ~IccTransform() = default;
  /// `count` texels of `channels` values 0 … 1 each, interleaved, to three values each. May be called at once by
  /// several threads.
  virtual void apply(const float* encoded, float* linear, int count) const = 0;
};

struct IccProfile {
  std::string name;                                    ///< its description
  int channels = 0;                                    ///< 1 gray, 3 RGB, 4 CMYK
  std::vector<InputCurve> curves = {};                 ///< one for each channel, where the profile is no more than that
  Imath::M33d xyz_d50_from_rgb = {};                   ///< and how its primaries mix: rows are the primaries
  std::shared_ptr<const IccTransform> transform = {};  ///< set where there are no curves
};

/// Of the bytes of a profile; nothing where they are none, or none of gray, RGB or CMYK.
std::optional<IccProfile> read_icc_profile(std::string_view bytes);

}  // namespace texbake
