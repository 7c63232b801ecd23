#include "libbake/noise/sharp_border.h"

#include <gtest/gtest.h>

#include "libbake/noise/masks.h"

namespace texbake {
namespace {

/// Two masks of 8×4 texels, the right half and the left half.
std::vector<Image<float>> halves() {
  std::vector<Image<float>> masks;
  for (int k = 0; k < 2; ++k) {
    masks.emplace_back(8, 4);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 8; ++x) masks.back()(x, y) = (x < 4) == (k == 0) ? 1.0f : 0.0f;
  }
  return masks;
}

TEST(SharpBorder, TheBandGoesAroundTheTorus) {
  const Image<uint8_t> band = border_band(halves(), 1.0);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) EXPECT_EQ(band(x, y), x == 0 || x == 3 || x == 4 || x == 7 ? 1 : 0) << x;
}

TEST(SharpBorder, InTheBandThereIsTheExemplarAndNoNoise) {
  const Image<V3f> exemplar(8, 4, V3f(0.75f));
  Image<V3f> structure(8, 4, V3f(0.5f));
  auto masks = halves();
  const Image<uint8_t> band = border_band(masks, 1.0);
  keep_sharp_borders(exemplar, band, structure, masks);
  ASSERT_EQ(masks.size(), 3u);
  EXPECT_NO_THROW(check_masks(masks));
  for (size_t i = 0; i < band.size(); ++i) {
    EXPECT_EQ(masks[2].data()[i], band.data()[i] ? 1.0f : 0.0f);
    EXPECT_EQ(structure.data()[i].x, band.data()[i] ? 0.75f : 0.5f);
  }
}

}  // namespace
}  // namespace texbake
