#include "libbake/color/convert.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "libbake/base/half.h"
#include "libbake/base/parallel.h"
#include "libbake/color/auto_classes.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

constexpr int kSearchTexels = 1 << 14;  // for the choice of K and of the start
constexpr int kRefineTexels = 1 << 18;  // for the classes: the mean of 1/64 of them is known to σ/64
constexpr LineKMeansOptions kRefinement{.along_weight = 0, .max_iterations = 30, .least_gain = 1e-4};
constexpr size_t kFewColors = 256;  // an exemplar with fewer may hide one from the sample
constexpr int kBands = 64;          // rows are summed band by band, whatever the number of threads
constexpr float kLargestVariation = 60000;

// Points of the exemplar; where there are few colors, each is among them.
PointSet sample_with_rare_colors(const PointSource& source, int max_count, const std::vector<PointF>& distinct) {
  PointSet points = sample(source, max_count);
  if (distinct.size() < kFewColors && static_cast<size_t>(points.size()) < source.exemplar.size())
    for (const PointF& point : distinct) points.append(point);
  return points;
}

void check_class_count(const ConvertOptions& options, const std::vector<PointF>& distinct) {
  if (!options.classes || static_cast<size_t>(*options.classes) <= distinct.size()) return;
  throw Error(ErrorKind::bad_data, fmt::format("--classes: expected at most {}, the number of distinct colors in the "
                                               "exemplar, found {}; ask for fewer classes",
                                               distinct.size(), *options.classes));
}

// The lines from which the classes are refined: one for each class.
std::vector<ColorLine> start_lines(const PointSource& source, const ConvertOptions& options,
                                   const std::vector<PointF>& distinct) {
  const PointSet points = sample_with_rare_colors(source, kSearchTexels, distinct);
  std::vector<ColorLine> lines = options.classes ? best_lines(points, *options.classes, options.along_weight).lines
                                                 : best_lines_of_auto_count(points, options.along_weight).lines;
  // Colors closer than the octree's cells: the classes still missing start empty and take the worst points.
  if (options.classes) lines.resize(static_cast<size_t>(*options.classes), lines.front());
  return lines;
}

struct Band {
  int begin = 0, end = 0;  // rows
};

Band band(int i, int height) {
  return {static_cast<int>(static_cast<int64_t>(i) * height / kBands),
          static_cast<int>(static_cast<int64_t>(i + 1) * height / kBands)};
}

// Gives every texel the nearest line and returns the moments of the colors of each class.
std::vector<Moments> assign_texels(const PointSource& source, const std::vector<ColorLine>& lines, float along_weight,
                                   Image<uint8_t>& index) {
  std::vector<std::vector<Moments>> partial(kBands, std::vector<Moments>(lines.size()));
  parallel_for(0, kBands, [&](int i) {
    PointSet row{.dimension = source.dimension(), .coordinates = {}};
    row.resize(index.width());
    for (int y = band(i, index.height()).begin; y < band(i, index.height()).end; ++y) {
      for (int x = 0; x < index.width(); ++x) row.set(x, source.point(x, y));
      assign_to_lines(row.data(), row.dimension, row.size(), lines, along_weight, index.row(y));
      for (int x = 0; x < index.width(); ++x) {
        const PointF p = row.point(x);
        partial[static_cast<size_t>(i)][index(x, y)].add<3>({p[0], p[1], p[2], 0});
      }
    }
  });
  std::vector<Moments> moments(lines.size());
  for (const auto& part : partial)
    for (size_t k = 0; k < moments.size(); ++k) moments[k].add(part[k]);
  return moments;
}

// D and V of the colors of a class. A class of one color varies along lightness.
ColorClass color_class(const Moments& moments) {
  const PointD mean = moments.mean();
  const PrincipalAxis axis = principal_axis(moments.covariance(), 3);
  ColorClass c;
  for (int i = 0; i < 3; ++i) {
    c.dominant[i] = static_cast<float>(mean[static_cast<size_t>(i)]);
    c.variation[i] = static_cast<float>(axis.direction[static_cast<size_t>(i)]);
  }
  if (c.variation == V3f(0)) c.variation = V3f(1, 0, 0);
  return c;
}

// The palette, dark first, and the place in it of each class; a class without a texel has none.
Palette ordered_palette(const std::vector<Moments>& moments, std::vector<uint8_t>& place) {
  std::vector<size_t> order;
  for (size_t k = 0; k < moments.size(); ++k)
    if (moments[k].count > 0) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return static_cast<float>(moments[a].mean()[0]) < static_cast<float>(moments[b].mean()[0]);
  });
  Palette palette;
  place.assign(moments.size(), 0);
  for (const size_t k : order) {
    place[k] = static_cast<uint8_t>(palette.classes.size());
    palette.classes.push_back(color_class(moments[k]));
  }
  return palette;
}

// v of every texel on the stored line; returns the distance that is left.
Image<float> project_texels(const PointSource& source, PrincipalVariation& colors) {
  Image<float> delta_e(source.exemplar.width(), source.exemplar.height());
  parallel_for(0, delta_e.height(), [&](int y) {
    for (int x = 0; x < delta_e.width(); ++x) {
      const ColorClass& c = colors.palette.classes[colors.index(x, y)];
      const V3f difference = luv_from_linear(source.exemplar(x, y)) - c.dominant;
      const float along = difference.dot(c.variation);
      const float v = half_exact(std::clamp(along, -kLargestVariation, kLargestVariation));
      const V3f left = difference - c.variation * v;
      colors.variation(x, y) = v;
      delta_e(x, y) = std::sqrt(left.dot(left));
    }
  });
  return delta_e;
}

ColorError color_error(Image<float> delta_e) {
  std::vector<double> rows(static_cast<size_t>(delta_e.height()));
  for (int y = 0; y < delta_e.height(); ++y)
    rows[static_cast<size_t>(y)] = std::accumulate(delta_e.row(y), delta_e.row(y) + delta_e.width(), 0.0);
  const auto texels = static_cast<double>(delta_e.size());
  // The least value that 99 % of the texels do not exceed.
  float* p99 = delta_e.begin() + static_cast<std::ptrdiff_t>(std::ceil(0.99 * texels)) - 1;
  std::nth_element(delta_e.begin(), p99, delta_e.end());
  return {.mean_delta_e = std::accumulate(rows.begin(), rows.end(), 0.0) / texels, .p99_delta_e = *p99};
}

}  // namespace

ConvertOptions resolve(const ConvertOptions& options, ImageView<const V3f> exemplar, ImageView<const float> height_01) {
  check_options(options);
  const PointSource source{exemplar, height_01, options.height_weight};
  const std::vector<PointF> distinct = distinct_points(source, kFewColors);
  check_class_count(options, distinct);
  ConvertOptions resolved = options;
  resolved.classes = static_cast<int>(start_lines(source, options, distinct).size());
  return resolved;
}

Conversion convert(ImageView<const V3f> exemplar, ImageView<const float> height_01, const ConvertOptions& options,
                   const Progress& progress) {
  assert(!exemplar.empty() && (height_01.empty() || same_size(exemplar, height_01)));
  check_options(options);
  const PointSource source{exemplar, height_01, options.height_weight};
  const std::vector<PointF> distinct = distinct_points(source, kFewColors);
  check_class_count(options, distinct);

  // Choose K and a start on few texels, refine the classes on more.
  std::vector<ColorLine> lines = start_lines(source, options, distinct);
  report_progress(progress, 0.4);
  const PointSet points = sample_with_rare_colors(source, kRefineTexels, distinct);
  LineKMeansOptions refinement = kRefinement;
  refinement.along_weight = options.along_weight;
  Conversion result{.colors = {}, .error = {}, .effective = options};
  result.effective.classes = static_cast<int>(lines.size());
  lines = line_kmeans(points, std::move(lines), refinement).lines;
  report_progress(progress, 0.7);

  // Assign all texels; mean and principal axis of each class are its entry in the palette.
  PrincipalVariation& colors = result.colors;
  colors.index = Image<uint8_t>(exemplar.width(), exemplar.height());
  colors.variation = Image<float>(exemplar.width(), exemplar.height());
  const std::vector<Moments> moments = assign_texels(source, lines, options.along_weight, colors.index);
  std::vector<uint8_t> place;
  colors.palette = ordered_palette(moments, place);
  for (uint8_t& index : colors.index) index = place[index];
  report_progress(progress, 0.9);

  // The coordinate along the line, and what is lost.
  result.error = color_error(project_texels(source, colors));
  report_progress(progress, 1);
  return result;
}

}  // namespace texbake
