#include "libbake/content/choice_figures.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/content/low_passed.h"

namespace texbake {
namespace {

// The two sums of G over a row.
struct RowSums {
  double shared = 0;
  double all = 0;
};

// G of an image whose mean is `mean`.
double repetition(const std::vector<std::vector<V2i>>& translations, ImageView<const V3f> image, V3f mean,
                  ImageView<const uint32_t> patch_idx) {
  const V2i size(image.width(), image.height());
  std::vector<RowSums> rows(static_cast<size_t>(size.y));
  parallel_for(0, size.y, [&](int y) {
    RowSums& row = rows[static_cast<size_t>(y)];
    for (int x = 0; x < size.x; ++x) {
      const auto& contents = translations[patch_idx(x, y)];
      V3f sum(0);
      double energy = 0.0;
      for (const V2i& t : contents) {
        const V2i q = wrap(V2i(x, y) + t, size);
        const V3f z = image(q.x, q.y) - mean;
        sum += z;
        energy += static_cast<double>(z.length2());
      }
      const auto n = static_cast<double>(contents.size());
      row.shared += static_cast<double>(sum.length2()) / (n * n);
      row.all += energy / n;
    }
  });
  RowSums total;
  for (const RowSums& row : rows) {
    total.shared += row.shared;
    total.all += row.all;
  }
  return total.all > 0.0 ? total.shared / total.all : 0.0;
}

double repetition_near(const std::vector<std::vector<V2i>>& translations, ImageView<const V3f> luv,
                       ImageView<const uint32_t> patch_idx) {
  double mean[3] = {};
  for (const V3f& c : luv)
    for (int i = 0; i < 3; ++i) mean[i] += static_cast<double>(c[i]) / static_cast<double>(luv.size());
  return repetition(translations, luv,
                    {static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2])}, patch_idx);
}

// On the cells of the low-passed tile.
double repetition_far(const std::vector<std::vector<V2i>>& translations, ImageView<const V3f> luv,
                      ImageView<const uint32_t> patch_idx) {
  const LowPassed low = low_passed(luv);
  Image<uint32_t> patch_of_cell(low.cells().x, low.cells().y);
  for (int y = 0; y < low.cells().y; ++y)
    for (int x = 0; x < low.cells().x; ++x) {
      const V2i p = low.middle_px({x, y});
      patch_of_cell(x, y) = patch_idx(p.x, p.y);
    }
  std::vector<std::vector<V2i>> shifts;
  for (const auto& contents : translations) {
    shifts.emplace_back();
    for (const V2i& t : contents) shifts.back().push_back(low.shift(t));
  }
  return repetition(shifts, low.color, V3f(0), patch_of_cell);
}

double use_deviation(const std::vector<std::vector<V2i>>& translations, ImageView<const uint32_t> patch_idx) {
  const V2i size(patch_idx.width(), patch_idx.height());
  Image<int> use(size.x, size.y);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (const V2i& t : translations[patch_idx(x, y)]) {
        const V2i q = wrap(V2i(x, y) + t, size);
        ++use(q.x, q.y);
      }
  double sum = 0.0, squares = 0.0;
  for (const int u : use) {
    sum += u;
    squares += static_cast<double>(u) * u;
  }
  const auto n = static_cast<double>(use.size());
  return std::sqrt(std::max(squares / n - sum * sum / (n * n), 0.0)) / (sum / n);
}

}  // namespace

ChoiceFigures choice_figures(const std::vector<std::vector<V2i>>& translations, ImageView<const V3f> base_luv,
                             ImageView<const uint32_t> patch_idx) {
  return {repetition_near(translations, base_luv, patch_idx), repetition_far(translations, base_luv, patch_idx),
          use_deviation(translations, patch_idx)};
}

}  // namespace texbake
