#include "libbake/height/refine.h"

#include <algorithm>
#include <vector>

#include "libbake/base/gaussian.h"
#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"

namespace texbake {
namespace {

constexpr double kEdge_delta_e = 1.0;
constexpr double kSmoothing_px = 1.0;
constexpr int kSteps = 40;  // the residual falls below 1e-3 of its start for strengths up to 64

using HeightField = Image<double>;

// Row sums in parallel, then the rows in order: the same for any number of threads.
double dot(const HeightField& a, const HeightField& b) {
  std::vector<double> of_row(static_cast<size_t>(a.height()), 0.0);
  parallel_for(0, a.height(), [&](int y) {
    double sum = 0.0;
    for (int x = 0; x < a.width(); ++x) sum += a(x, y) * b(x, y);
    of_row[static_cast<size_t>(y)] = sum;
  });
  double sum = 0.0;
  for (const double row : of_row) sum += row;
  return sum;
}

// a += b · factor
void add_scaled(HeightField& a, const HeightField& b, double factor) {
  parallel_for(0, a.height(), [&](int y) {
    for (int x = 0; x < a.width(); ++x) a(x, y) += b(x, y) * factor;
  });
}

// The matrix of the normal equations: 1 + strength · (weighted Laplacian of the torus).
class Smoothness {
 public:
  Smoothness(ImageView<const V3f> luv, double strength)
      : right_(luv.width(), luv.height()), below_(luv.width(), luv.height()) {
    const Image<V3f> color = gaussian_blur(luv, kSmoothing_px, Wrap::repeat);
    const auto weight = [&](const V3f& a, const V3f& b) {
      return strength * portable_exp(-static_cast<double>((a - b).length()) / kEdge_delta_e);
    };
    parallel_for(0, color.height(), [&](int y) {
      for (int x = 0; x < color.width(); ++x) {
        right_(x, y) = weight(color(x, y), color(wrap(x + 1, color.width()), y));
        below_(x, y) = weight(color(x, y), color(x, wrap(y + 1, color.height())));
      }
    });
  }

  HeightField times(const HeightField& h) const {
    const int width = h.width(), height = h.height();
    HeightField result(width, height);
    parallel_for(0, height, [&](int y) {
      const int above = wrap(y - 1, height), below = wrap(y + 1, height);
      for (int x = 0; x < width; ++x) {
        const int left = wrap(x - 1, width), right = wrap(x + 1, width);
        const double own = h(x, y);
        const double horizontal = right_(x, y) * (own - h(right, y)) + right_(left, y) * (own - h(left, y));
        const double vertical = below_(x, y) * (own - h(x, below)) + below_(x, above) * (own - h(x, above));
        result(x, y) = own + (horizontal + vertical);
      }
    });
    return result;
  }

  // 1 / diagonal, texel by texel.
  HeightField preconditioned(const HeightField& residual) const {
    const int width = residual.width(), height = residual.height();
    HeightField result(width, height);
    parallel_for(0, height, [&](int y) {
      for (int x = 0; x < width; ++x)
        result(x, y) =
            residual(x, y) /
            (1.0 + ((right_(x, y) + right_(wrap(x - 1, width), y)) + (below_(x, y) + below_(x, wrap(y - 1, height)))));
    });
    return result;
  }

 private:
  HeightField right_;  // weight between a texel and its neighbor to the right
  HeightField below_;
};

// Preconditioned conjugate gradients from h = target.
HeightField solve(const Smoothness& matrix, const HeightField& target) {
  HeightField h = target.clone();
  HeightField residual = target.clone();
  add_scaled(residual, matrix.times(h), -1.0);
  HeightField direction = matrix.preconditioned(residual);
  double energy = dot(residual, direction);
  for (int step = 0; step < kSteps && energy > 0.0; ++step) {
    const HeightField moved = matrix.times(direction);
    const double length = energy / dot(direction, moved);
    add_scaled(h, direction, length);
    add_scaled(residual, moved, -length);
    HeightField next = matrix.preconditioned(residual);
    const double next_energy = dot(residual, next);
    add_scaled(next, direction, next_energy / energy);
    direction = std::move(next);
    energy = next_energy;
  }
  return h;
}

}  // namespace

Image<float> refine(ImageView<const float> propagated, ImageView<const V3f> luv, float strength) {
  HeightField target(propagated.width(), propagated.height());
  for (int y = 0; y < target.height(); ++y)
    for (int x = 0; x < target.width(); ++x) target(x, y) = propagated(x, y);
  const HeightField h = solve(Smoothness(luv, strength), target);
  // The minimum lies between the least and the greatest height; so do these steps towards it.
  const auto [least, most] = std::minmax_element(target.begin(), target.end());
  Image<float> result(h.width(), h.height());
  for (size_t i = 0; i < h.size(); ++i) result.data()[i] = static_cast<float>(std::clamp(h.data()[i], *least, *most));
  return result;
}

}  // namespace texbake
