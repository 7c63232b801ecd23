#include "libbake/color/point_set.h"

#include <algorithm>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/base/random.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

constexpr uint64_t kSampleSeed = 0x7e4b;

// The range of cell `i` of `cells` over `size` texels.
int cell_begin(int i, int cells, int size) { return static_cast<int>(static_cast<int64_t>(i) * size / cells); }

}  // namespace

PointF PointSet::point(int i) const {
  PointF point{};
  for (size_t c = 0; c < static_cast<size_t>(dimension); ++c) point[c] = coordinates[c][static_cast<size_t>(i)];
  return point;
}

std::array<const float*, 4> PointSet::data(int first) const {
  std::array<const float*, 4> data{};
  for (size_t c = 0; c < static_cast<size_t>(dimension); ++c) data[c] = coordinates[c].data() + first;
  return data;
}

void PointSet::resize(int size) {
  for (size_t c = 0; c < static_cast<size_t>(dimension); ++c) coordinates[c].resize(static_cast<size_t>(size));
}

void PointSet::set(int i, const PointF& point) {
  for (size_t c = 0; c < static_cast<size_t>(dimension); ++c) coordinates[c][static_cast<size_t>(i)] = point[c];
}

void PointSet::append(const PointF& point) {
  resize(size() + 1);
  set(size() - 1, point);
}

PointF PointSource::point(int x, int y) const {
  const V3f luv = luv_from_linear(exemplar(x, y));
  return {luv.x, luv.y, luv.z, height_01.empty() ? 0.0f : height_01(x, y) * height_weight};
}

PointSet sample(const PointSource& source, int max_count) {
  const int width = source.exemplar.width(), height = source.exemplar.height();
  const double texels = static_cast<double>(width) * height;
  const double step = std::max(1.0, std::sqrt(texels / max_count));
  const int first_guess = std::max(1, static_cast<int>(width / step));
  const int rows = std::clamp(max_count / first_guess, 1, height), columns = std::clamp(max_count / rows, 1, width);

  PointSet points{.dimension = source.dimension(), .coordinates = {}};
  points.resize(columns * rows);
  parallel_for(0, rows, [&](int row) {
    Random random(kSampleSeed, static_cast<uint64_t>(row));
    const int top = cell_begin(row, rows, height), bottom = cell_begin(row + 1, rows, height);
    for (int column = 0; column < columns; ++column) {
      const int left = cell_begin(column, columns, width), right = cell_begin(column + 1, columns, width);
      const int x = left + static_cast<int>(random.below(static_cast<uint32_t>(right - left)));
      const int y = top + static_cast<int>(random.below(static_cast<uint32_t>(bottom - top)));
      points.set(row * columns + column, source.point(x, y));
    }
  });
  return points;
}

std::vector<PointF> distinct_points(const PointSource& source, size_t limit) {
  std::vector<PointF> found;
  for (int y = 0; y < source.exemplar.height(); ++y)
    for (int x = 0; x < source.exemplar.width(); ++x) {
      if (found.size() >= limit) return found;
      const PointF point = source.point(x, y);
      if (std::find(found.begin(), found.end(), point) == found.end()) found.push_back(point);
    }
  return found;
}

}  // namespace texbake
