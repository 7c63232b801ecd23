#include "libbake/planes/local_mean.h"

#include "libbake/base/gaussian.h"

namespace texbake {
namespace {

/// Half the width of a border's change, which spans 2 w − 1 texels on either side, in soft borders' px.
constexpr double kSigmaPerBorder = 2;

}  // namespace

Image<glsl::vec4> local_mean(ImageView<const glsl::vec4> texels, int soft_border_px) {
  Image<V3f> colors(texels.width(), texels.height());
  Image<float> last(texels.width(), texels.height());
  for (size_t i = 0; i < texels.size(); ++i) {
    const glsl::vec4& v = texels.data()[i];
    colors.data()[i] = {v.x, v.y, v.z};
    last.data()[i] = v.w;
  }
  const double sigma_px = kSigmaPerBorder * soft_border_px;
  colors = gaussian_blur(colors, sigma_px, Wrap::repeat);
  last = gaussian_blur(last, sigma_px, Wrap::repeat);
  Image<glsl::vec4> mean(texels.width(), texels.height(), {0, 0, 0, 0});
  for (size_t i = 0; i < mean.size(); ++i) {
    const V3f& c = colors.data()[i];
    mean.data()[i] = {c.x, c.y, c.z, last.data()[i]};
  }
  return mean;
}

}  // namespace texbake
