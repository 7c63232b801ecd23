#include "libbake/color/periodic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/color/luv.h"
#include "libbake/color/period_search.h"
#include "libbake/color/resample.h"
#include "libbake/color/seam_cut.h"

namespace texbake {
namespace {

constexpr double kMostStretch = 0.10;

template <class T>
Image<T> transposed(ImageView<const T> image) {
  Image<T> result(image.height(), image.width());
  parallel_for(0, result.height(), [&](int y) {
    for (int x = 0; x < result.width(); ++x) result(x, y) = image(y, x);
  });
  return result;
}

// The nearest multiple of `multiple`, which is halved until the side is not stretched by more than 10 %.
int nearest_size(int length, int multiple) {
  for (;; multiple = multiple % 2 == 0 ? multiple / 2 : 1) {
    const int size = std::max((length + multiple / 2) / multiple, 1) * multiple;
    if (std::abs(size - length) <= kMostStretch * length) return size;
  }
}

AxisPlan whole_axis(int length, int multiple) { return {false, 0, length, 0, nearest_size(length, multiple)}; }

// Where to close the x axis of `luv`.
AxisPlan cut_axis(ImageView<const V3f> luv, const PeriodicOptions& options, const char* side) {
  const PeriodRange range = period_range(luv.width(), options.overlap_px);
  if (range.greatest < range.least)
    throw Error(
        ErrorKind::infeasible,
        fmt::format("--overlap: expected at most half of the exemplar's {} of {} texels, found {}: give less, or "
                    "a larger exemplar",
                    side, luv.width(), *options.overlap_px));
  const int multiple = multiple_within(options.multiple, range.least, range.greatest);
  const Period period = best_period(luv, {multiple, options.overlap_px});
  const int begin = (luv.width() - period.length - period.overlap) / 2;
  return {true, begin, period.length, period.overlap, nearest_size(period.length, multiple)};
}

// The rows begin … begin + length + overlap − 1, closed along x.
template <class T>
Image<T> closed_along_x(ImageView<const T> image, const AxisPlan& x, const std::vector<int>& cut, int first_row,
                        int rows) {
  Image<T> result(x.length, rows);
  parallel_for(0, rows, [&](int y) {
    for (int i = 0; i < x.length; ++i) {
      const int further = x.cut && i < cut[y] ? x.length : 0;
      result(i, y) = image(x.begin + i + further, first_row + y);
    }
  });
  return result;
}

// Everything but the resampling.
template <class T>
Image<T> cropped_and_cut(const TilePlan& plan, ImageView<const T> image) {
  Image<T> tile(plan.x.length, plan.y.length);
  parallel_for(0, tile.height(), [&](int y) {
    for (int x = 0; x < tile.width(); ++x) {
      const V2i place = plan.source_place({x, y});
      tile(x, y) = image(place.x, place.y);
    }
  });
  return tile;
}

// Neighbours that the cuts brought together, against all others.
double measure_cut(const TilePlan& plan, ImageView<const V3f> source_luv) {
  const Image<V3f> tile = cropped_and_cut(plan, source_luv);
  const V2i size(tile.width(), tile.height());
  double joined_sum = 0, other_sum = 0;
  size_t joined = 0, other = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (int k = 0; k < 2; ++k) {
        const V2i step(k == 0, k == 1);
        const V2i next = wrap(V2i(x, y) + step, size);
        const double difference = (tile(x, y) - tile(next.x, next.y)).length();
        const bool neighbours = plan.source_place(next) == plan.source_place({x, y}) + step;
        (neighbours ? other_sum : joined_sum) += difference;
        ++(neighbours ? other : joined);
      }
  if (joined == 0 || other == 0 || other_sum == 0) return 1;
  return joined_sum / static_cast<double>(joined) / (other_sum / static_cast<double>(other));
}

void check(ImageView<const V3f> source, const PeriodicOptions& options) {
  check_options(options);
  if (source.width() < kMinExemplarSide || source.height() < kMinExemplarSide)
    throw Error(ErrorKind::bad_data, fmt::format("expected an exemplar of at least {} x {} texels, found {} x {}",
                                                 kMinExemplarSide, kMinExemplarSide, source.width(), source.height()));
}

Borders borders_of(const TilePlan& plan) {
  return {plan.x.cut ? Wrap::clamp : Wrap::repeat, plan.y.cut ? Wrap::clamp : Wrap::repeat};
}

template <class T>
Image<T> apply_to_map(const TilePlan& plan, ImageView<const T> map) {
  assert(!map.empty());
  if (!plan.is_cut()) return resample(map, plan.x.size, plan.y.size, Borders{});
  const Image<T> same = resample(map, plan.source_size.x, plan.source_size.y, borders_of(plan));
  return resample(cropped_and_cut<T>(plan, same), plan.x.size, plan.y.size, Borders{});
}

}  // namespace

V2i TilePlan::source_place(V2i p) const {
  const int row = p.y + (y.cut && p.y < cut_y[p.x] ? y.length : 0);
  const int column = p.x + (x.cut && p.x < cut_x[row] ? x.length : 0);
  return {x.begin + column, y.begin + row};
}

TilePlan plan_tile(ImageView<const V3f> source, const PeriodicOptions& options) {
  check(source, options);
  TilePlan plan;
  plan.source_size = {source.width(), source.height()};
  plan.before = measure_seam(source);
  const bool automatic = options.periodic == Periodic::automatic;
  const bool make = options.periodic == Periodic::make;
  const bool cuts_x = make || (automatic && !plan.before.x.tiles());
  const bool cuts_y = make || (automatic && !plan.before.y.tiles());

  // The cut along x first, over all rows; then a closed one along y, on what is periodic in x already.
  const Image<V3f> luv = cuts_x || cuts_y ? luv_from_linear(source) : Image<V3f>();
  plan.x = cuts_x ? cut_axis(luv, options, "width") : whole_axis(source.width(), options.multiple);
  std::vector<int> cut_of_source_rows;
  if (cuts_x)
    cut_of_source_rows =
        minimum_cut(overlap_mismatch(luv, plan.x.begin, plan.x.length, plan.x.overlap), CutEnds::open).column;
  plan.y = whole_axis(source.height(), options.multiple);
  if (cuts_y) {
    const Image<V3f> ring = transposed<V3f>(closed_along_x<V3f>(luv, plan.x, cut_of_source_rows, 0, source.height()));
    plan.y = cut_axis(ring, options, "height");
    plan.cut_y =
        minimum_cut(overlap_mismatch(ring, plan.y.begin, plan.y.length, plan.y.overlap), CutEnds::closed).column;
  }
  if (cuts_x)
    plan.cut_x.assign(cut_of_source_rows.begin() + plan.y.begin,
                      cut_of_source_rows.begin() + plan.y.begin + plan.y.length + plan.y.overlap);

  if (plan.is_cut()) plan.cut_ratio = measure_cut(plan, luv);
  plan.after = plan.is_cut() || plan.is_resampled() ? measure_seam(apply(plan, source)) : plan.before;
  return plan;
}

Image<V3f> apply(const TilePlan& plan, ImageView<const V3f> map) { return apply_to_map(plan, map); }
Image<float> apply(const TilePlan& plan, ImageView<const float> map) { return apply_to_map(plan, map); }

Image<V3f> apply_to_normals(const TilePlan& plan, ImageView<const V3f> normals) {
  Image<V3f> tile = apply(plan, normals);
  const bool same = V2i(normals.width(), normals.height()) == plan.source_size && !plan.is_resampled();
  if (!same)
    for (V3f& normal : tile) normal = normal.length() > 0 ? normal / normal.length() : V3f(0, 0, 1);
  return tile;
}

}  // namespace texbake
