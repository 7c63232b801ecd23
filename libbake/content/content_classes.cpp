#include "libbake/content/content_classes.h"

#include <array>

#include "libbake/color/luv.h"
#include "libbake/content/saliency.h"

namespace texbake {

ContentClasses content_classes(const PrincipalVariation& colors, ImageView<const V3f> base) {
  ContentClasses result;
  const Image<float> salient = saliency(colors);
  result.saliency_threshold = two_class_threshold(salient);

  // Sum the colors of both halves of every class.
  const size_t halves = 2 * colors.palette.classes.size();
  std::vector<std::array<double, 3>> sums(halves);
  std::vector<size_t> counts(halves, 0);
  result.idx = Image<uint8_t>(base.width(), base.height());
  const Image<V3f> luv = luv_from_linear(base);
  size_t salient_count = 0;
  for (size_t i = 0; i < luv.size(); ++i) {
    const bool is_salient = salient.data()[i] > result.saliency_threshold;
    salient_count += is_salient ? 1 : 0;
    const size_t half = 2 * static_cast<size_t>(colors.index.data()[i]) + (is_salient ? 1 : 0);
    result.idx.data()[i] = static_cast<uint8_t>(half);
    for (int c = 0; c < 3; ++c) sums[half][static_cast<size_t>(c)] += static_cast<double>(luv.data()[i][c]);
    ++counts[half];
  }
  result.salient_share = static_cast<double>(salient_count) / static_cast<double>(luv.size());

  // Number those that occur.
  std::vector<uint8_t> number(halves, 0);
  for (size_t half = 0; half < halves; ++half) {
    if (counts[half] == 0) continue;
    number[half] = static_cast<uint8_t>(result.mean_luv.size());
    const auto n = static_cast<double>(counts[half]);
    result.mean_luv.emplace_back(static_cast<float>(sums[half][0] / n), static_cast<float>(sums[half][1] / n),
                                 static_cast<float>(sums[half][2] / n));
  }
  for (uint8_t& idx : result.idx) idx = number[idx];
  return result;
}

}  // namespace texbake
