#include "libbake/tile/periodic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "libbake/base/parallel.h"
#include "libbake/color/luv.h"
#include "libbake/tile/period_search.h"
#include "libbake/tile/resample.h"
#include "libbake/tile/seam_cut.h"
#include "libbake/tile/seam_join.h"

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
    throw Error(ErrorKind::infeasible, fmt::format("--overlap: expected at most half of the exemplar's {} of {} "
                                                   "texels, found {}; use less, or a larger exemplar",
                                                   side, luv.width(), *options.overlap_px));
  const int multiple = multiple_within(options.multiple, range.least, range.greatest);
  const Period period = best_period(luv, {multiple, options.overlap_px});
  const int begin = (luv.width() - period.length - period.overlap) / 2;
  return {true, begin, period.length, period.overlap, nearest_size(period.length, multiple)};
}

Seam seam_of(const AxisPlan& axis, const std::vector<int>& cut, CutEnds ends) {
  return {axis.begin, axis.length, axis.overlap, ends, cut};
}

// The least visible cut along x.
std::vector<int> cut_along_x(ImageView<const V3f> luv, const AxisPlan& axis, CutEnds ends) {
  return minimum_cut(overlap_mismatch(luv, axis.begin, axis.length, axis.overlap), ends).column;
}

// The cut along x in the rows that the tile is made of.
std::vector<int> used_rows(const std::vector<int>& cut_x, const AxisPlan& y) {
  const auto first = cut_x.begin() + y.begin;
  return {first, first + y.length + y.overlap};
}

template <class T>
Image<T> rows_of(ImageView<const T> image, int first, int count) {
  Image<T> rows(image.width(), count);
  std::copy(image.row(first), image.row(first) + rows.size(), rows.begin());
  return rows;
}

// Everything but the resampling: closed along x, then along y.
template <class T>
Image<T> closed(const TilePlan& plan, ImageView<const T> image) {
  Image<T> tile = rows_of(image, plan.y.begin, plan.y.length + plan.y.overlap);
  if (plan.x.cut) tile = join_along_x(tile, seam_of(plan.x, plan.cut_x, CutEnds::open));
  if (!plan.y.cut) return tile;
  AxisPlan y = plan.y;
  y.begin = 0;  // the rows before it are gone
  return transposed<T>(join_along_x(transposed<T>(tile), seam_of(y, plan.cut_y, CutEnds::closed)));
}

// Neighbors that the cuts brought together, against all others.
double measure_cut(const TilePlan& plan, const Image<V3f>& tile) {
  const V2i size(tile.width(), tile.height());
  double joined_sum = 0, other_sum = 0;
  size_t joined = 0, other = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (int k = 0; k < 2; ++k) {
        const V2i step(k == 0, k == 1);
        const V2i next = wrap(V2i(x, y) + step, size);
        const double difference = (tile(x, y) - tile(next.x, next.y)).length();
        const bool neighbors = plan.source_place(next) == plan.source_place({x, y}) + step;
        (neighbors ? other_sum : joined_sum) += difference;
        ++(neighbors ? other : joined);
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
  return resample(closed<T>(plan, same), plan.x.size, plan.y.size, Borders{});
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
  Image<V3f> luv = cuts_x || cuts_y ? luv_from_linear(source) : Image<V3f>();
  plan.x = whole_axis(source.width(), options.multiple);
  plan.y = whole_axis(source.height(), options.multiple);
  if (cuts_x) {
    plan.x = cut_axis(luv, options, "width");
    plan.cut_x = cut_along_x(luv, plan.x, CutEnds::open);
    luv = join_along_x(luv, seam_of(plan.x, plan.cut_x, CutEnds::open));
  }
  if (cuts_y) {
    const Image<V3f> turned = transposed<V3f>(luv);
    plan.y = cut_axis(turned, options, "height");
    plan.cut_y = cut_along_x(turned, plan.y, CutEnds::closed);
    if (cuts_x) plan.cut_x = used_rows(plan.cut_x, plan.y);
  }

  if (plan.is_cut()) plan.cut_ratio = measure_cut(plan, luv_from_linear(closed(plan, source)));
  plan.after = plan.is_cut() || plan.is_resampled() ? measure_seam(apply(plan, source)) : plan.before;
  return plan;
}

Image<V3f> apply(const TilePlan& plan, ImageView<const V3f> map) { return apply_to_map(plan, map); }
Image<float> apply(const TilePlan& plan, ImageView<const float> map) { return apply_to_map(plan, map); }

Image<V3f> apply_to_normals(const TilePlan& plan, ImageView<const V3f> normals) {
  Image<V3f> tile = apply(plan, normals);
  const bool copied = V2i(normals.width(), normals.height()) == plan.source_size && !plan.is_resampled();
  if (!copied || plan.is_cut())
    for (V3f& normal : tile) normal = normal.length() > 0 ? normal / normal.length() : V3f(0, 0, 1);
  return tile;
}

}  // namespace texbake
