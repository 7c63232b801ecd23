#include "libbake/noise/color_basis.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/symmetric_eigen.h"

namespace texbake {
namespace {

V3f with_positive_peak(const V3f& v) {
  int peak = 0;
  for (int c = 1; c < 3; ++c)
    if (std::fabs(v[c]) > std::fabs(v[peak])) peak = c;
  return v[peak] < 0.0f ? -v : v;
}

}  // namespace

ColorBasis principal_basis(ImageView<const V3f> colors, ImageView<const uint8_t> mask) {
  double count = 0.0;
  std::array<double, 3> sum = {};
  for (size_t i = 0; i < colors.size(); ++i) {
    if (mask.data()[i] == 0) continue;
    count += 1.0;
    for (size_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(colors.data()[i][static_cast<int>(c)]);
  }
  ColorBasis basis;
  if (count == 0.0) return basis;
  SquareMatrix<3> covariance = {};
  for (size_t i = 0; i < colors.size(); ++i) {
    if (mask.data()[i] == 0) continue;
    std::array<double, 3> d;
    for (size_t c = 0; c < 3; ++c) d[c] = static_cast<double>(colors.data()[i][static_cast<int>(c)]) - sum[c] / count;
    for (size_t r = 0; r < 3; ++r)
      for (size_t c = 0; c < 3; ++c) covariance[r][c] += d[r] * d[c];
  }
  for (int c = 0; c < 3; ++c) basis.mean[c] = static_cast<float>(sum[static_cast<size_t>(c)] / count);
  if (!(covariance[0][0] + covariance[1][1] + covariance[2][2] > 0.0)) return basis;

  const SymmetricEigen<3> e = symmetric_eigen(covariance);
  std::array<size_t, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return e.values[a][a] > e.values[b][b]; });
  for (size_t c = 0; c < 3; ++c) {
    V3f axis;
    for (int i = 0; i < 3; ++i) axis[i] = static_cast<float>(e.vectors[static_cast<size_t>(i)][order[c]]);
    basis.axis[c] = with_positive_peak(axis);
  }
  return basis;
}

ColorBasis match_axes(const ColorBasis& basis, const ColorBasis& reference) {
  std::array<size_t, 3> order = {0, 1, 2};
  std::array<size_t, 3> best = order;
  float best_sum = -1.0f;
  do {
    float total = 0.0f;
    for (size_t c = 0; c < 3; ++c) total += std::fabs(basis.axis[order[c]].dot(reference.axis[c]));
    if (total > best_sum) {
      best_sum = total;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  ColorBasis matched{basis.mean, {}};
  for (size_t c = 0; c < 3; ++c) {
    const V3f& axis = basis.axis[best[c]];
    matched.axis[c] = axis.dot(reference.axis[c]) < 0.0f ? -axis : axis;
  }
  return matched;
}

}  // namespace texbake
