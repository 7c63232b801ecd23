#include "libbake/tile/period_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/tile/seam_cut.h"

namespace texbake {
namespace {

constexpr float kGradientFloor = 5;  // ΔE: a step as small is hardly seen on a flat ground
constexpr int kSearchSide = 256;     // a pattern's period is first looked for at this size
constexpr int kMostMultiples = 48;   // more are thinned out evenly
constexpr double kMuchBetter = 0.6;  // what a period must gain to be worth resampling

// Change of color around a texel: the lengths of both central differences.
float gradient(ImageView<const V3f> luv, int x, int y) {
  const int left = std::max(x - 1, 0), right = std::min(x + 1, luv.width() - 1);
  const int above = std::max(y - 1, 0), below = std::min(y + 1, luv.height() - 1);
  return (luv(right, y) - luv(left, y)).length() + (luv(x, below) - luv(x, above)).length();
}

// Means of factor × factor texels, fewer rows where there are fewer; what is left of a side is dropped.
Image<V3f> reduced(ImageView<const V3f> image, int factor) {
  const int rows = std::min(factor, image.height());
  Image<V3f> means(image.width() / factor, image.height() / rows);
  const float share = 1.0f / static_cast<float>(factor * rows);
  parallel_for(0, means.height(), [&](int y) {
    for (int x = 0; x < means.width(); ++x)
      for (int j = 0; j < rows; ++j)
        for (int i = 0; i < factor; ++i) means(x, y) += image(x * factor + i, y * rows + j) * share;
  });
  return means;
}

struct Scored {
  Period period;
  double score = 0;
};

// The error of a cut grows with the square of what is seen, so the lost length counts squared as well.
Scored score_period(ImageView<const V3f> luv, int length, std::optional<int> overlap) {
  const int used = overlap.value_or(std::min(luv.width() - length, length));
  const int begin = (luv.width() - length - used) / 2;
  const double cost = minimum_cut(overlap_mismatch(luv, begin, length, used), CutEnds::open).cost / luv.height();
  const double lost = static_cast<double>(luv.width()) / length;
  return {{length, used, cost}, cost * lost * lost};
}

// The best of several periods; of equals, the longest.
Scored best_of(ImageView<const V3f> luv, const std::vector<int>& lengths, std::optional<int> overlap) {
  std::vector<Scored> scored(lengths.size());
  parallel_for(0, static_cast<int>(lengths.size()), [&](int i) { scored[i] = score_period(luv, lengths[i], overlap); });
  return *std::min_element(scored.begin(), scored.end(), [](const Scored& a, const Scored& b) {
    return a.score != b.score ? a.score < b.score : a.period.length > b.period.length;
  });
}

// The multiples in a range, greatest first, thinned out when there are many.
std::vector<int> multiples_in(PeriodRange range, int multiple) {
  const int count = range.greatest / multiple - (range.least - 1) / multiple;
  const int stride = multiple * ((count + kMostMultiples - 1) / kMostMultiples);
  std::vector<int> lengths;
  for (int length = range.greatest / multiple * multiple; length >= range.least; length -= stride)
    lengths.push_back(length);
  return lengths;
}

std::vector<int> every_length(PeriodRange range) {
  std::vector<int> lengths;
  for (int length = range.greatest; length >= range.least; --length) lengths.push_back(length);
  return lengths;
}

// The best period of any length: found at reduced size, then refined.
Scored best_of_all(ImageView<const V3f> luv, PeriodRange range) {
  const int factor = std::max((luv.width() + kSearchSide - 1) / kSearchSide, 1);
  if (factor == 1) return best_of(luv, every_length(range), {});
  const Image<V3f> small = reduced(luv, factor);
  const int rough =
      best_of(small, every_length(period_range(small.width(), {})), {}).period.length * factor + factor / 2;
  return best_of(luv,
                 every_length({std::clamp(rough - factor, range.least, range.greatest),
                               std::clamp(rough + factor, range.least, range.greatest)}),
                 {});
}

}  // namespace

Image<float> overlap_mismatch(ImageView<const V3f> luv, int begin, int period, int overlap) {
  assert(begin >= 0 && begin + period + overlap <= luv.width());
  Image<float> mismatch(overlap, luv.height());
  parallel_for(0, luv.height(), [&](int y) {
    for (int i = 0; i < overlap; ++i) {
      const int x = begin + i;
      const float squared = (luv(x + period, y) - luv(x, y)).length2();
      mismatch(i, y) = squared / (kGradientFloor + 0.5f * (gradient(luv, x, y) + gradient(luv, x + period, y)));
    }
  });
  return mismatch;
}

PeriodRange period_range(int width, std::optional<int> overlap) {
  return {(width + 1) / 2, width - overlap.value_or(std::max(width / 16, 4))};
}

int multiple_within(int multiple, int least, int greatest) {
  while (greatest / multiple * multiple < least) multiple = multiple % 2 == 0 ? multiple / 2 : 1;
  return multiple;
}

Period best_period(ImageView<const V3f> luv, const PeriodOptions& options) {
  const PeriodRange range = period_range(luv.width(), options.overlap);
  const Scored whole = best_of(luv, multiples_in(range, options.multiple), options.overlap);
  if (options.overlap) return whole.period;

  // A pattern may repeat at another length; unless it is a multiple itself, the tile must be resampled for it.
  const Scored free = best_of_all(luv, range);
  const double gain = free.period.length % options.multiple == 0 ? 1 : kMuchBetter;
  return free.score < gain * whole.score ? free.period : whole.period;
}

}  // namespace texbake
