#include "libbake/segment/contrast.h"

#include <cmath>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

// Between smooth concrete, 1.4, and the next fainter of fourteen photographs, worn wood, 3.1.
constexpr double kFaintBorder = 2.0;
// Sand, whose only feature is its grain, has 0.64, the other photographs at most 0.45; a picture without any feature 1.
constexpr double kSizeLimited = 0.75;

/// Sums over the edges to the right and below of one row.
struct RowSums {
  double border = 0, interior = 0;
  int64_t border_edges = 0, interior_edges = 0;
  int64_t limited_texels = 0;
};

double delta_e(const V3f& a, const V3f& b) {
  const V3f d = a - b;
  return std::sqrt(static_cast<double>(d.x * d.x + d.y * d.y + d.z * d.z));
}

}  // namespace

ContrastReport contrast_report(ImageView<const V3f> base, const FragmentMap& fragments, int max_area_px) {
  const Image<V3f> luv = luv_from_linear(base);
  const Image<uint32_t>& idx = fragments.partition.idx;
  const int width = luv.width(), height = luv.height();
  std::vector<RowSums> rows(static_cast<size_t>(height));
  parallel_for(0, height, [&](int y) {
    RowSums& sums = rows[static_cast<size_t>(y)];
    for (int x = 0; x < width; ++x) {
      for (int n = 0; n < 2; ++n) {
        const int u = wrap(x + kNeighborX[n], width), v = wrap(y + kNeighborY[n], height);
        const double difference = delta_e(luv(x, y), luv(u, v));
        const bool is_border = idx(x, y) != idx(u, v);
        (is_border ? sums.border : sums.interior) += difference;
        ++(is_border ? sums.border_edges : sums.interior_edges);
      }
      if (fragments.partition.areas_px[idx(x, y)] >= static_cast<uint32_t>(max_area_px)) ++sums.limited_texels;
    }
  });

  RowSums total;
  for (const RowSums& row : rows) {
    total.border += row.border;
    total.interior += row.interior;
    total.border_edges += row.border_edges;
    total.interior_edges += row.interior_edges;
    total.limited_texels += row.limited_texels;
  }
  ContrastReport report;
  if (total.border_edges > 0) report.border_delta_e = total.border / static_cast<double>(total.border_edges);
  if (total.interior_edges > 0) report.interior_delta_e = total.interior / static_cast<double>(total.interior_edges);
  report.size_limited_share = static_cast<double>(total.limited_texels) / static_cast<double>(luv.size());
  return report;
}

std::optional<LowContrast> low_contrast(const ContrastReport& report) {
  if (report.border_delta_e < kFaintBorder) return LowContrast::faint_borders;
  if (report.size_limited_share > kSizeLimited) return LowContrast::size_limited;
  return std::nullopt;
}

}  // namespace texbake
