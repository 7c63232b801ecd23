// What the numbers of a picture mean, apart from how its file is decoded: curve, orientation, values that are refused.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/options.h"
#include "libbake/base/torus.h"

namespace texbake {

/// What the numbers of a picture's file mean.
enum class InputSpace {
  automatic,  ///< what the file says; else sRGB for integers and linear for floats
  srgb,
  linear,
};
template <>
struct EnumNames<InputSpace> {
  static constexpr std::pair<InputSpace, std::string_view> values[] = {
      {InputSpace::automatic, "auto"}, {InputSpace::srgb, "srgb"}, {InputSpace::linear, "linear"}};
};

/// What a picture is for.
enum class PictureRole {
  color,   ///< light: three channels, decoded to linear Rec.709; gray is promoted
  data,    ///< numbers such as roughness or height, without any curve: one or three channels, integers to 0 … 1
  normal,  ///< vectors: three channels, decoded to −1 … 1, not renormalized
};

/// The curve between the numbers of a file and linear light.
class InputCurve {
 public:
  static InputCurve linear() { return InputCurve(1, "linear"); }
  static InputCurve srgb() { return InputCurve(0, "srgb"); }
  /// linear = encoded^gamma; a gamma within 0.05 of 2.2 is sRGB, which is what files that say 2.2 hold.
  static InputCurve power(double gamma);
  /// linear = encoded^gamma, even where that is near sRGB.
  static InputCurve exact_power(double gamma);
  /// `table` has the linear values of 0 … 1 at equal steps, two or more of them; beyond, the last step goes on.
  static InputCurve sampled(std::vector<float> table, const std::string& name);

  /// Odd: negative values keep their sign.
  float decode(float encoded) const;
  /// "srgb", "linear", "gamma 1.8" or that of a table.
  const std::string& name() const { return name_; }

 private:
  InputCurve(double gamma, std::string name) : gamma_(gamma), name_(std::move(name)) {}
  double gamma_;  ///< 0 stands for sRGB
  std::string name_;
  std::shared_ptr<const std::vector<float>> table_ = {};  ///< in place of `gamma_` where it is set
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
