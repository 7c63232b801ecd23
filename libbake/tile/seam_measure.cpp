// Based on: measured on photographs made seamless by their publishers, and on crops of them, which are not.
#include "libbake/tile/seam_measure.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

constexpr int kBlock = 8;  // the side of JPEG's blocks
constexpr double kLargestRatio = 1000;

double difference(const V3f& a, const V3f& b) { return (a - b).length(); }
double difference(float a, float b) { return std::fabs(a - b); }

// Steps from each column to the next, the last to the first. Bands of rows are summed apart, then in order.
template <class T>
std::vector<double> column_steps(ImageView<const T> image) {
  constexpr int kBandRows = 64;
  const int bands = (image.height() + kBandRows - 1) / kBandRows;
  Image<double> sums(image.width(), bands);
  parallel_for(0, bands, [&](int band) {
    for (int y = band * kBandRows; y < std::min((band + 1) * kBandRows, image.height()); ++y)
      for (int x = 0; x < image.width(); ++x)
        sums(x, band) += difference(image(x, y), image(x + 1 < image.width() ? x + 1 : 0, y));
  });
  std::vector<double> steps(static_cast<size_t>(image.width()), 0.0);
  for (int band = 0; band < bands; ++band)
    for (int x = 0; x < image.width(); ++x) steps[x] += sums(x, band) / image.height();
  return steps;
}

template <class T>
std::vector<double> row_steps(ImageView<const T> image) {
  std::vector<double> steps(static_cast<size_t>(image.height()), 0.0);
  parallel_for(0, image.height(), [&](int y) {
    const int next = y + 1 < image.height() ? y + 1 : 0;
    for (int x = 0; x < image.width(); ++x) steps[y] += difference(image(x, y), image(x, next)) / image.width();
  });
  return steps;
}

// Means of whole blocks; what is left of a side is not counted.
template <class T>
Image<T> block_means(ImageView<const T> image) {
  Image<T> means(image.width() / kBlock, image.height() / kBlock);
  parallel_for(0, means.height(), [&](int y) {
    for (int x = 0; x < means.width(); ++x)
      for (int j = 0; j < kBlock; ++j)
        for (int i = 0; i < kBlock; ++i)
          means(x, y) += image(x * kBlock + i, y * kBlock + j) * (1.0f / (kBlock * kBlock));
  });
  return means;
}

double ratio_of(double wrap, double reference) {
  if (wrap == 0 && reference == 0) return 1;
  return reference > 0 ? std::min(wrap / reference, kLargestRatio) : kLargestRatio;
}

// Mean of steps[first], steps[first + stride], … without the last step, which is the wrap.
double mean_inside(const std::vector<double>& steps, size_t first, size_t stride) {
  double sum = 0;
  int count = 0;
  for (size_t i = first; i + 1 < steps.size(); i += stride, ++count) sum += steps[i];
  return count ? sum / count : 0;
}

AxisSeam judge(const std::vector<double>& steps, const std::vector<double>& coarse_steps) {
  AxisSeam seam;
  if (steps.size() < 3) return seam;
  const double wrap = steps.back();
  double reference = steps.size() % kBlock == 0 ? mean_inside(steps, kBlock - 1, kBlock) : 0;
  if (reference == 0) reference = mean_inside(steps, 0, 1);
  seam.ratio = ratio_of(wrap, reference);
  seam.share_of_largest = ratio_of(wrap, *std::max_element(steps.begin(), steps.end() - 1));
  seam.share_of_beside = ratio_of(wrap, std::max(steps[0], steps[steps.size() - 2]));
  if (coarse_steps.size() >= 3) seam.coarse_ratio = ratio_of(coarse_steps.back(), mean_inside(coarse_steps, 0, 1));
  return seam;
}

template <class T>
SeamMeasure measure(ImageView<const T> image) {
  const Image<T> coarse = block_means(image);
  return {judge(column_steps(image), column_steps(coarse.view())), judge(row_steps(image), row_steps(coarse.view()))};
}

}  // namespace

bool AxisSeam::tiles() const {
  const bool usual = ratio <= kLargestSeamRatio && coarse_ratio <= kLargestCoarseSeamRatio;
  const bool edge = share_of_largest <= 1 && share_of_beside <= kLargestShareOfBeside;
  return usual || edge;
}

SeamMeasure measure_seam(ImageView<const V3f> linear) {
  Image<V3f> encoded(linear.width(), linear.height());
  parallel_for(0, linear.height(), [&](int y) {
    for (int x = 0; x < linear.width(); ++x)
      for (int c = 0; c < 3; ++c) encoded(x, y)[c] = srgb_from_linear(linear(x, y)[c]);
  });
  return measure<V3f>(encoded);
}

SeamMeasure measure_seam(ImageView<const float> values) { return measure<float>(values); }

SeamMeasure measure_vector_seam(ImageView<const V3f> values) { return measure<V3f>(values); }

}  // namespace texbake
