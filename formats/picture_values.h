// What the numbers of a picture mean, apart from how its file is decoded: curve, orientation, values that are refused.
#pragma once

#include <string>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/torus.h"

namespace texbake {

/// The curve between the numbers of a file and linear light.
class InputCurve {
 public:
  static InputCurve linear() { return InputCurve(1); }
  static InputCurve srgb() { return InputCurve(0); }
  /// linear = encoded^gamma; a gamma within 0.05 of 2.2 is sRGB, which is what files that say 2.2 hold.
  static InputCurve power(double gamma);

  /// Odd: negative values keep their sign.
  float decode(float encoded) const;
  /// "srgb", "linear" or "gamma 1.8".
  std::string name() const;

 private:
  explicit InputCurve(double gamma) : gamma_(gamma) {}
  double gamma_;  ///< 0 stands for sRGB
};

/// EXIF orientation 1 … 8 of a picture stored as `stored` = (width, height): its size when upright, and where the texel
/// stored at `p` is then.
V2i upright_size(V2i stored, int orientation);
V2i upright_place(V2i p, V2i stored, int orientation);

/// Throws Error(bad_data) when a value is NaN or infinite: how many texels are, and the first in reading order.
void check_finite(const std::string& path, const std::vector<ImageView<const float>>& planes);
/// Throws Error(bad_data) when a value is above `largest`: how many texels are, and the first in reading order.
void check_largest(const std::string& path, const std::vector<ImageView<const float>>& planes, float largest);

}  // namespace texbake
