#include "libbake/tile/resample.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/base/portable_math.h"
#include "libbake/color/channels.h"

namespace texbake {
namespace {

constexpr double kLobes = 3;

double lanczos(double x) {
  if (x == 0) return 1;
  if (std::fabs(x) >= kLobes) return 0;
  const double a = std::numbers::pi * x;
  return kLobes * portable_sin(a) * portable_sin(a / kLobes) / (a * a);
}

int inside(int i, int size, Wrap border) { return border == Wrap::repeat ? wrap(i, size) : std::clamp(i, 0, size - 1); }

// The texels that one new texel is made of.
struct Taps {
  std::vector<int> index;
  std::vector<float> weight;  // sum 1
};

std::vector<Taps> taps_of_side(int old_size, int new_size, Wrap border) {
  const double scale = static_cast<double>(old_size) / new_size;
  const double stretch = std::max(scale, 1.0);
  std::vector<Taps> side(static_cast<size_t>(new_size));
  for (int i = 0; i < new_size; ++i) {
    const double center = (i + 0.5) * scale - 0.5;
    const int first = static_cast<int>(std::ceil(center - kLobes * stretch));
    const int last = static_cast<int>(std::floor(center + kLobes * stretch));
    std::vector<double> weights;
    double sum = 0;
    for (int k = first; k <= last; ++k) sum += weights.emplace_back(lanczos((k - center) / stretch));
    for (int k = first; k <= last; ++k) {
      side[i].index.push_back(inside(k, old_size, border));
      side[i].weight.push_back(static_cast<float>(weights[k - first] / sum));
    }
  }
  return side;
}

template <class T>
T weighted(const T* values, const Taps& taps, int stride) {
  T sum(0);
  for (size_t k = 0; k < taps.index.size(); ++k)
    sum += values[static_cast<size_t>(taps.index[k]) * static_cast<size_t>(stride)] * taps.weight[k];
  return sum;
}

template <class T>
Image<T> resample_image(ImageView<const T> image, int width, int height, Borders borders) {
  assert(!image.empty() && width >= 1 && height >= 1);
  Image<T> wide(width, image.height());
  const std::vector<Taps> columns = taps_of_side(image.width(), width, borders.x);
  parallel_for(0, image.height(), [&](int y) {
    for (int x = 0; x < width; ++x)
      wide(x, y) = width == image.width() ? image(x, y) : weighted(image.row(y), columns[x], 1);
  });
  if (height == image.height() && width == image.width()) return wide;

  Image<T> result(width, height);
  const std::vector<Taps> rows = taps_of_side(image.height(), height, borders.y);
  const std::pair<T, T> range = channel_range(image);
  parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const T value = height == image.height() ? wide(x, y) : weighted(wide.data() + x, rows[y], width);
      result(x, y) = clamp_channels(value, range.first, range.second);
    }
  });
  return result;
}

}  // namespace

Image<float> resample(ImageView<const float> image, int width, int height, Borders borders) {
  return resample_image(image, width, height, borders);
}

Image<V3f> resample(ImageView<const V3f> image, int width, int height, Borders borders) {
  return resample_image(image, width, height, borders);
}

}  // namespace texbake
