#include "libbake/content/saliency.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"

namespace texbake {
namespace {

constexpr int kSaliencyCells = 32;           // along the shorter side
constexpr double kNearness = 0.25;           // σ_p of the article, in units of the tile's side
constexpr double kDistributionWeight = 6.0;  // k of the article's eq. 5

// The texels of one class in one cell.
struct Element {
  double v = 0;
  double x = 0, y = 0;  // centroid, texels
  double area_px = 0;
  double uniqueness = 0;
  double distribution = 0;
  double saliency = 0;
};

struct Grid {
  V2i size;
  int cell_px;
  V2i cells;
};

Grid make_grid(V2i size) {
  const int cell_px = std::max(1, std::min(size.x, size.y) / kSaliencyCells);
  return {size, cell_px, {(size.x + cell_px - 1) / cell_px, (size.y + cell_px - 1) / cell_px}};
}

// Elements of one class, cell by cell; area 0 where the class does not occur.
std::vector<Element> elements_of(const PrincipalVariation& colors, int class_idx, const Grid& grid) {
  std::vector<Element> elements(static_cast<size_t>(grid.cells.x * grid.cells.y));
  for (int y = 0; y < grid.size.y; ++y)
    for (int x = 0; x < grid.size.x; ++x) {
      if (colors.index(x, y) != class_idx) continue;
      Element& element = elements[static_cast<size_t>(y / grid.cell_px * grid.cells.x + x / grid.cell_px)];
      element.v += static_cast<double>(colors.variation(x, y));
      element.x += x;
      element.y += y;
      element.area_px += 1.0;
    }
  for (Element& element : elements) {
    if (element.area_px == 0.0) continue;
    element.v /= element.area_px;
    element.x /= element.area_px;
    element.y /= element.area_px;
  }
  return elements;
}

double shortest_distance(double d, double n) {
  const double magnitude = std::fabs(d);
  return magnitude > n / 2.0 ? n - magnitude : magnitude;
}

// exp(−d²/2) for d = 0 … 8 in steps of 1/256, read at the nearest step: the weights need no more.
class GaussianTable {
 public:
  GaussianTable() {
    for (size_t i = 0; i < table_.size(); ++i) {
      const double d = static_cast<double>(i) / 256.0;
      table_[i] = portable_exp(-0.5 * d * d);
    }
  }
  double operator()(double d) const {
    const double position = std::fabs(d) * 256.0 + 0.5;
    return position < static_cast<double>(table_.size()) ? table_[static_cast<size_t>(position)] : 0.0;
  }

 private:
  std::array<double, 8 * 256> table_;
};

// The article's eq. 1 and 3 for the elements of one class.
void measure(std::vector<Element>& elements, const Grid& grid, double sigma_v, const GaussianTable& gaussian) {
  const double width = grid.size.x;
  const double height = grid.size.y;
  parallel_for(0, static_cast<int>(elements.size()), [&](int i) {
    Element& own = elements[static_cast<size_t>(i)];
    if (own.area_px == 0.0) return;
    double near_sum = 0.0, unlike = 0.0;
    double similar_sum = 0.0, spread = 0.0;
    for (const Element& other : elements) {
      if (other.area_px == 0.0) continue;
      const double dx = shortest_distance(other.x - own.x, width) / width;
      const double dy = shortest_distance(other.y - own.y, height) / height;
      const double squared_distance = dx * dx + dy * dy;
      const double dv = other.v - own.v;
      const double near = gaussian(std::sqrt(squared_distance) / kNearness) * other.area_px;
      const double similar = gaussian(dv / sigma_v) * other.area_px;
      near_sum += near;
      unlike += near * dv * dv;
      similar_sum += similar;
      spread += similar * squared_distance;
    }
    own.uniqueness = unlike / near_sum;
    own.distribution = spread / similar_sum;
  });
}

// The article's eq. 6: a texel takes the mean of the elements around it, near and similar ones weighing more.
float texel_saliency(const std::vector<Element>& elements, const Grid& grid, V2i p, double v, double sigma_v,
                     const GaussianTable& gaussian) {
  double sum = 0.0;
  double weights = 0.0;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      const V2i cell = wrap(V2i(p.x / grid.cell_px + i, p.y / grid.cell_px + j), grid.cells);
      const Element& element = elements[static_cast<size_t>(cell.y * grid.cells.x + cell.x)];
      if (element.area_px == 0.0) continue;
      const double dx = shortest_distance(element.x - p.x, grid.size.x) / grid.cell_px;
      const double dy = shortest_distance(element.y - p.y, grid.size.y) / grid.cell_px;
      const double weight = gaussian(dx) * gaussian(dy) * gaussian((element.v - v) / sigma_v) + 1e-9;
      sum += weight * element.saliency;
      weights += weight;
    }
  return static_cast<float>(sum / weights);
}

double deviation(ImageView<const float> values) {
  double sum = 0.0, squares = 0.0;
  for (const float v : values) {
    sum += static_cast<double>(v);
    squares += static_cast<double>(v) * static_cast<double>(v);
  }
  const auto n = static_cast<double>(values.size());
  return std::sqrt(std::max(squares / n - sum * sum / (n * n), 0.0));
}

}  // namespace

Image<float> saliency(const PrincipalVariation& colors) {
  const Grid grid = make_grid({colors.index.width(), colors.index.height()});
  Image<float> result(grid.size.x, grid.size.y);
  const double sigma_v = deviation(colors.variation);
  if (sigma_v == 0.0) return result;

  // Uniqueness and distribution of the elements of each class.
  const GaussianTable gaussian;
  std::vector<std::vector<Element>> elements_of_class;
  double most_unique = 0.0, most_spread = 0.0;
  for (size_t k = 0; k < colors.palette.classes.size(); ++k) {
    elements_of_class.push_back(elements_of(colors, static_cast<int>(k), grid));
    measure(elements_of_class.back(), grid, sigma_v, gaussian);
    for (const Element& element : elements_of_class.back()) {
      most_unique = std::max(most_unique, element.uniqueness);
      most_spread = std::max(most_spread, element.distribution);
    }
  }
  if (most_unique == 0.0) return result;

  // S = U · exp(−k D), both scaled to 0 … 1 over the picture; then the greatest S is 1.
  double most_salient = 0.0;
  for (auto& elements : elements_of_class)
    for (Element& element : elements) {
      const double spread = most_spread > 0.0 ? element.distribution / most_spread : 0.0;
      element.saliency = element.uniqueness / most_unique * portable_exp(-kDistributionWeight * spread);
      most_salient = std::max(most_salient, element.saliency);
    }
  for (auto& elements : elements_of_class)
    for (Element& element : elements) element.saliency /= most_salient;

  parallel_for(0, grid.size.y, [&](int y) {
    for (int x = 0; x < grid.size.x; ++x)
      result(x, y) = texel_saliency(elements_of_class[colors.index(x, y)], grid, {x, y},
                                    static_cast<double>(colors.variation(x, y)), sigma_v, gaussian);
  });
  return result;
}

float two_class_threshold(ImageView<const float> values) {
  constexpr int kBins = 256;
  std::array<double, kBins> histogram{};
  for (const float value : values)
    histogram[static_cast<size_t>(std::clamp(static_cast<int>(value * kBins), 0, kBins - 1))] += 1.0;
  double total = 0.0;
  for (size_t i = 0; i < kBins; ++i) total += static_cast<double>(i) * histogram[i];

  // The split with the greatest variance between the groups; the lowest of equal ones.
  const auto count = static_cast<double>(values.size());
  double below_count = 0.0, below_sum = 0.0, best = 0.0;
  float threshold = 1.0f;
  for (size_t i = 0; i + 1 < kBins; ++i) {
    below_count += histogram[i];
    below_sum += static_cast<double>(i) * histogram[i];
    const double above_count = count - below_count;
    if (below_count == 0.0 || above_count == 0.0) continue;
    const double difference = below_sum / below_count - (total - below_sum) / above_count;
    const double between = below_count * above_count * difference * difference;
    if (between > best) {
      best = between;
      threshold = static_cast<float>(i + 1) / kBins;
    }
  }
  return threshold;
}

}  // namespace texbake
