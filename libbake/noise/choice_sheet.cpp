#include "libbake/noise/choice_sheet.h"

#include <algorithm>

namespace texbake {
namespace {

constexpr int kColumns = 4;
constexpr int kFrame_px = 8;
constexpr float kMiddleGray = 0.2159f;  // half of the codes of sRGB
const V3f kDark(0.02f);
const V3f kLight(0.9f);

void paste(ImageView<const V3f> picture, V2i size, V2i at, float offset, Image<V3f>& sheet) {
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) sheet(at.x + x, at.y + y) = picture(x, y) + V3f(offset);
}

}  // namespace

Image<V3f> choice_sheet(ImageView<const V3f> exemplar, std::span<const LocalSizeCandidate> candidates, int chosen,
                        int side) {
  const V2i size(std::min(side, exemplar.width()), std::min(side, exemplar.height()));
  const V2i pitch = size + V2i(kFrame_px);
  Image<V3f> sheet(kColumns * pitch.x + kFrame_px, static_cast<int>(candidates.size()) * pitch.y + kFrame_px, kDark);
  for (size_t row = 0; row < candidates.size(); ++row) {
    const LocalSizeCandidate& candidate = candidates[row];
    const int top = static_cast<int>(row) * pitch.y;
    if (candidate.test.local_size == chosen)
      for (int y = top; y < top + pitch.y + kFrame_px; ++y) std::fill_n(sheet.row(y), sheet.width(), kLight);
    const auto place = [&](int column) { return V2i(column * pitch.x, top) + V2i(kFrame_px); };
    paste(exemplar, size, place(0), 0.0f, sheet);
    paste(candidate.structure, size, place(1), 0.0f, sheet);
    paste(noise_layer(exemplar, candidate.structure, candidate.space), size, place(2), kMiddleGray, sheet);
    paste(candidate.synthesis, size, place(3), 0.0f, sheet);
  }
  return sheet;
}

}  // namespace texbake
