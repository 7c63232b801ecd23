// Distances are symmetric, w(x, y) = w(y, x): each pair of texels is measured once, and once for all iterations.
#include "libbake/noise/structure.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/noise/lanes.h"

namespace texbake {
namespace {

constexpr int kReach = 8;                    // the largest |δ| along an axis
constexpr int kRowOffsets = 2 * kReach + 1;  // δx = −8 … 8 of one row above
constexpr float kUnitWeight = 65535.0f;
static_assert(kReach <= SpectraRows::kMargin);

/// The weights of all pairs (x, x + δ) with δ before 0 in reading order. A row of an offset covers a margin on the
/// torus, as the filter reads the pair (x, x − δ) at x − δ.
class PairWeights {
 public:
  PairWeights(int width, int height)
      : height_(height),
        stride_(static_cast<size_t>(round_to_lanes(width + 2 * kReach + 2 * kLanes))),
        data_(static_cast<size_t>(height) * kOffsets * stride_) {}

  /// Element [x] belongs to the pair (x, y), (x + dx, y + dy). (dx, dy) is before (0, 0); y is on the torus.
  uint16_t* row(int y, int dx, int dy) {
    return data_.data() + (static_cast<size_t>(y) * kOffsets + offset_idx(dx, dy)) * stride_ + kReach;
  }
  const uint16_t* row(int y, int dx, int dy) const {
    return const_cast<PairWeights*>(this)->row(wrap(y, height_), dx, dy);
  }

  void wrap_margins(uint16_t* row, int width) const {
    for (int i = 1; i <= kReach; ++i) row[-i] = row[wrap(-i, width)];
    for (int i = 0; i < kReach + kLanes; ++i) row[width + i] = row[wrap(i, width)];
  }

 private:
  static constexpr size_t kOffsets = kReach * kRowOffsets + kReach;
  static size_t offset_idx(int dx, int dy) { return static_cast<size_t>((dy + kReach) * kRowOffsets + dx + kReach); }

  int height_;
  size_t stride_;
  std::vector<uint16_t> data_;
};

/// How a squared distance becomes a weight. From `limit` on the weight rounds to 0.
struct WeightCurve {
  explicit WeightCurve(double sigma)
      : factor(static_cast<float>(1.0 / (2.0 * sigma * sigma))), limit(static_cast<float>(12.0 / factor)) {}
  float factor;
  float limit;
};

void store_weights(Lanes squared_distance, const WeightCurve& curve, uint16_t* out) {
  Lanes exponent = squared_distance * curve.factor;
  exponent = exponent < splat(80.0f) ? exponent : splat(80.0f);
  const Lanes weight = exp_of_negative(exponent) * kUnitWeight + splat(0.5f);
  for (int i = 0; i < kLanes; ++i) out[i] = static_cast<uint16_t>(weight[i]);
}

bool all_beyond(const Lanes* distances, int count, float limit) {
  Lanes least = distances[0];
  for (int i = 1; i < count; ++i) least = distances[i] < least ? distances[i] : least;
  return least[0] > limit && least[1] > limit && least[2] > limit && least[3] > limit;
}

/// Weights of the pairs (x, x + dx + i) for i < N and four texels from `x`. `here` and `there` point at bin 0 of texel
/// 0 of the two rows. A sum that is past the limit only grows: it is given up without a change of the result.
template <int N>
void pair_weights(const float* here, const float* there, int bins, size_t stride, int x, int dx, int dy, int y,
                  const WeightCurve& curve, PairWeights& weights) {
  Lanes squared[N] = {};
  const float* a = here + x;
  const float* b = there + x + dx;
  constexpr int kCheckEvery = 8;
  for (int bin = 0; bin < bins;) {
    const int stop = std::min(bin + kCheckEvery, bins);
    for (; bin < stop; ++bin, a += stride, b += stride) {
      const Lanes value = load_lanes(a);
      for (int i = 0; i < N; ++i) {
        const Lanes difference = value - load_lanes(b + i);
        squared[i] += difference * difference;
      }
    }
    if (all_beyond(squared, N, curve.limit)) break;
  }
  for (int i = 0; i < N; ++i) store_weights(squared[i], curve, weights.row(y, dx + i, dy) + x);
}

void weights_of_row(const SpectraRows& spectra, int y, int width, const WeightCurve& curve, PairWeights& weights,
                    int height) {
  const int torus_y = wrap(y, height);
  for (int dy = -kReach; dy <= 0; ++dy) {
    const float* here = spectra.row(y, 0);
    const float* there = spectra.row(y + dy, 0);
    for (int x = 0; x < width; x += kLanes) {
      const auto run = [&]<int N>(std::integral_constant<int, N>, int dx) {
        pair_weights<N>(here, there, spectra.bins(), spectra.stride(), x, dx, dy, torus_y, curve, weights);
      };
      run(std::integral_constant<int, 8>{}, -kReach);
      if (dy < 0) run(std::integral_constant<int, 9>{}, 0);
    }
    for (int dx = -kReach; dx <= (dy < 0 ? kReach : -1); ++dx)
      weights.wrap_margins(weights.row(torus_y, dx, dy), width);
  }
}

PairWeights measure_pairs(const LocalSpectra& guide, double sigma, const Progress& progress) {
  PairWeights weights(guide.width(), guide.height());
  const WeightCurve curve(sigma);
  constexpr int kRowsAtOnce = 32;
  const int bands = (guide.height() + kRowsAtOnce - 1) / kRowsAtOnce;
  parallel_for(0, bands, [&](int band) {
    const int y_begin = band * kRowsAtOnce;
    const int y_end = std::min(y_begin + kRowsAtOnce, guide.height());
    const SpectraRows spectra = guide.rows(y_begin - kReach, y_end);
    for (int y = y_begin; y < y_end; ++y) weights_of_row(spectra, y, guide.width(), curve, weights, guide.height());
  });
  report_progress(progress, 0.6);
  return weights;
}

/// The three channels of an image apart, each row with a margin on the torus.
class Planes {
 public:
  Planes(int width, int height)
      : width_(width),
        height_(height),
        stride_(static_cast<size_t>(round_to_lanes(width + 2 * kReach + 2 * kLanes))),
        data_(3 * static_cast<size_t>(height) * stride_) {}
  explicit Planes(ImageView<const V3f> image) : Planes(image.width(), image.height()) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x)
        for (int c = 0; c < 3; ++c) row(y, c)[x] = image(x, y)[c];
      wrap_margins(y);
    }
  }
  float* row(int y, int c) {
    return data_.data() + (static_cast<size_t>(y) * 3 + static_cast<size_t>(c)) * stride_ + kReach;
  }
  const float* row(int y, int c) const { return const_cast<Planes*>(this)->row(wrap(y, height_), c); }
  void wrap_margins(int y) {
    for (int c = 0; c < 3; ++c) {
      float* r = row(y, c);
      for (int i = 1; i <= kReach; ++i) r[-i] = r[wrap(-i, width_)];
      for (int i = 0; i < kReach + kLanes; ++i) r[width_ + i] = r[wrap(i, width_)];
    }
  }
  Image<V3f> image() const {
    Image<V3f> result(width_, height_);
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) result(x, y) = V3f(row(y, 0)[x], row(y, 1)[x], row(y, 2)[x]);
    return result;
  }

 private:
  int width_;
  int height_;
  size_t stride_;
  std::vector<float> data_;
};

struct WeightRow {
  const uint16_t* weight;  // of texel 0
  int dx;
  int row_idx;  // into the rows of the channels
};

/// The weights of every δ ≠ 0 around the texels of row y, and the offset each reads at.
std::vector<WeightRow> rows_around(const PairWeights& weights, int y) {
  std::vector<WeightRow> rows;
  for (int dy = kFilterBegin; dy <= kFilterEnd; ++dy)
    for (int dx = kFilterBegin; dx <= kFilterEnd; ++dx) {
      const bool before = dy < 0 || (dy == 0 && dx < 0);
      if (dx == 0 && dy == 0) continue;
      const uint16_t* weight = before ? weights.row(y, dx, dy) : weights.row(y + dy, -dx, -dy) + dx;
      rows.push_back({weight, dx, dy - kFilterBegin});
    }
  return rows;
}

Lanes load_weights(const uint16_t* weight) {
  using Weights = uint16_t __attribute__((vector_size(8)));
  Weights w;
  std::memcpy(&w, weight, sizeof w);
  return __builtin_convertvector(__builtin_convertvector(w, LaneBits), Lanes);
}

void filter_row(const Planes& from, const PairWeights& weights, int y, int width, Planes& to) {
  const std::vector<WeightRow> around = rows_around(weights, y);
  std::array<std::array<const float*, 3>, kFilterEnd - kFilterBegin + 1> source;
  for (int dy = kFilterBegin; dy <= kFilterEnd; ++dy)
    for (int c = 0; c < 3; ++c)
      source[static_cast<size_t>(dy - kFilterBegin)][static_cast<size_t>(c)] = from.row(y + dy, c);
  for (int x = 0; x < width; x += kLanes) {
    Lanes total = splat(kUnitWeight);
    std::array<Lanes, 3> sum;
    for (size_t c = 0; c < 3; ++c) sum[c] = load_lanes(source[-kFilterBegin][c] + x) * kUnitWeight;
    for (const WeightRow& row : around) {
      const Lanes w = load_weights(row.weight + x);
      total += w;
      const auto& rows = source[static_cast<size_t>(row.row_idx)];
      for (size_t c = 0; c < 3; ++c) sum[c] += w * load_lanes(rows[c] + x + row.dx);
    }
    for (int c = 0; c < 3; ++c) store_lanes(to.row(y, c) + x, sum[static_cast<size_t>(c)] / total);
  }
}

}  // namespace

Image<V3f> extract_structure(ImageView<const V3f> image, const LocalSpectra& guide,
                             const StructureParameters& parameters, const Progress& progress) {
  const PairWeights weights = measure_pairs(guide, parameters.sigma, progress);
  Planes from(image);
  Planes to(image.width(), image.height());
  for (int i = 0; i < parameters.iterations; ++i) {
    parallel_for(
        0, image.height(),
        [&](int y) {
          filter_row(from, weights, y, image.width(), to);
          to.wrap_margins(y);
        },
        16);
    std::swap(from, to);
    report_progress(progress, 0.6 + 0.4 * (i + 1) / parameters.iterations);
  }
  return from.image();
}

}  // namespace texbake
