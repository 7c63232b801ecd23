#include "libbake/quality/seams.h"

#include <algorithm>
#include <vector>

namespace texbake {
namespace {

float delta_e(const V3f& a, const V3f& b) { return (a - b).length(); }

// P(a > b) + ½ P(a = b) over all pairs, from the ranks of two sorted samples.
double area_under_curve(const std::vector<float>& sorted_a, const std::vector<float>& sorted_b) {
  double wins = 0.0;
  size_t below = 0;
  size_t not_above = 0;
  for (const float a : sorted_a) {
    while (below < sorted_b.size() && sorted_b[below] < a) ++below;
    while (not_above < sorted_b.size() && sorted_b[not_above] <= a) ++not_above;
    wins += 0.5 * (static_cast<double>(below) + static_cast<double>(not_above));
  }
  return wins / (static_cast<double>(sorted_a.size()) * static_cast<double>(sorted_b.size()));
}

float percentile95(const std::vector<float>& sorted) { return sorted[(sorted.size() - 1) * 95 / 100]; }

double share_above(const std::vector<float>& sorted, float threshold) {
  return static_cast<double>(sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), threshold)) /
         static_cast<double>(sorted.size());
}

// Σ len² / Σ len over the 8-connected components of the marked texels.
double mean_run(Image<uint8_t> marked) {
  double sum = 0.0;
  double sum_of_squares = 0.0;
  std::vector<V2i> stack;
  for (int y = 0; y < marked.height(); ++y)
    for (int x = 0; x < marked.width(); ++x) {
      if (!marked(x, y)) continue;
      double length = 0.0;
      stack.assign(1, V2i(x, y));
      marked(x, y) = 0;
      while (!stack.empty()) {
        const V2i p = stack.back();
        stack.pop_back();
        length += 1.0;
        for (int v = std::max(p.y - 1, 0); v <= std::min(p.y + 1, marked.height() - 1); ++v)
          for (int u = std::max(p.x - 1, 0); u <= std::min(p.x + 1, marked.width() - 1); ++u)
            if (marked(u, v)) {
              marked(u, v) = 0;
              stack.emplace_back(u, v);
            }
      }
      sum += length;
      sum_of_squares += length * length;
    }
  return sum > 0.0 ? sum_of_squares / sum : 0.0;
}

// Differences of all 4-neighbors on the torus, sorted.
std::vector<float> neighbor_differences(ImageView<const V3f> exemplar) {
  std::vector<float> differences;
  differences.reserve(2 * exemplar.size());
  const V2i size(exemplar.width(), exemplar.height());
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      differences.push_back(delta_e(exemplar(x, y), exemplar(wrap(x + 1, size.x), y)));
      differences.push_back(delta_e(exemplar(x, y), exemplar(x, wrap(y + 1, size.y))));
    }
  std::sort(differences.begin(), differences.end());
  return differences;
}

// Two neighbors of the rendering whose sources are not.
struct SeamPair {
  V2i p{0, 0};
  V2i q{0, 0};
  float difference = 0;  // across the seam
  float own = 0;         // of the exemplar across the same place of the tile
};

std::vector<SeamPair> seam_pairs(ImageView<const V3f> exemplar, ImageView<const V2i> source,
                                 const SeamOptions& options) {
  const V2i size(exemplar.width(), exemplar.height());
  const auto at = [&](V2i p) { return exemplar(p.x, p.y); };
  std::vector<SeamPair> pairs;
  const auto visit = [&](V2i p, V2i step) {
    const V2i q = p + step;
    if (!options.shape.empty() && options.shape(p.x, p.y) == options.shape(q.x, q.y)) return;
    const V2i expected = source(p.x, p.y) + step;
    if ((options.adjacency == Adjacency::torus ? wrap(expected, size) : expected) == source(q.x, q.y)) return;
    const V3f shown_p = options.shown.empty() ? at(source(p.x, p.y)) : options.shown(p.x, p.y);
    const V3f shown_q = options.shown.empty() ? at(source(q.x, q.y)) : options.shown(q.x, q.y);
    pairs.push_back({p, q, delta_e(shown_p, shown_q), delta_e(at(wrap(p, size)), at(wrap(q, size)))});
  };
  for (int y = 0; y < source.height(); ++y)
    for (int x = 0; x < source.width(); ++x) {
      if (x + 1 < source.width()) visit({x, y}, {1, 0});
      if (y + 1 < source.height()) visit({x, y}, {0, 1});
    }
  return pairs;
}

template <class Value>
std::vector<float> sorted(const std::vector<SeamPair>& pairs, const Value& value) {
  std::vector<float> values;
  values.reserve(pairs.size());
  for (const SeamPair& pair : pairs) values.push_back(value(pair));
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace

std::optional<Seams> seams(ImageView<const V3f> exemplar_luv, ImageView<const V2i> source, const SeamOptions& options) {
  const std::vector<SeamPair> pairs = seam_pairs(exemplar_luv, source, options);
  if (pairs.empty()) return std::nullopt;
  const std::vector<float> all = neighbor_differences(exemplar_luv);
  const std::vector<float> seam = sorted(pairs, [](const SeamPair& pair) { return pair.difference; });
  const std::vector<float> own = sorted(pairs, [](const SeamPair& pair) { return pair.own; });

  const float threshold_all = percentile95(all);
  Image<uint8_t> visible(source.width(), source.height());
  for (const SeamPair& pair : pairs)
    if (pair.difference > threshold_all) visible(pair.p.x, pair.p.y) = visible(pair.q.x, pair.q.y) = 1;

  Seams result;
  result.pair_count = pairs.size();
  result.auc_all = area_under_curve(seam, all);
  result.auc_own = area_under_curve(seam, own);
  result.tail_all = share_above(seam, threshold_all);
  result.tail_own = share_above(seam, percentile95(own));
  result.run_px = mean_run(std::move(visible));
  return result;
}

Image<SeamTexel> seam_texels(ImageView<const V3f> exemplar_luv, ImageView<const V2i> source,
                             const SeamOptions& options) {
  Image<SeamTexel> texels(source.width(), source.height(), SeamTexel::none);
  const std::vector<SeamPair> pairs = seam_pairs(exemplar_luv, source, options);
  if (pairs.empty()) return texels;
  const float threshold = percentile95(sorted(pairs, [](const SeamPair& pair) { return pair.own; }));
  for (const SeamPair& pair : pairs) {
    const SeamTexel state = pair.difference > threshold ? SeamTexel::visible : SeamTexel::hidden;
    for (const V2i& p : {pair.p, pair.q}) texels(p.x, p.y) = std::max(texels(p.x, p.y), state);
  }
  return texels;
}

}  // namespace texbake
