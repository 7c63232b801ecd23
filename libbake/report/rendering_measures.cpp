#include "libbake/report/rendering_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libbake/quality/fidelity.h"
#include "libbake/quality/repetition.h"

namespace texbake {
namespace {

constexpr const char* kOneColor = "the exemplar has only one color";

Measured measured(const std::optional<double>& value, const std::string& reason) {
  return value && std::isfinite(*value) ? Measured::of(*value) : Measured::undefined(reason);
}

void measure_repetition(ImageView<const V3f> rendering_luv, V2i tile, MeasureRow& row) {
  if (rendering_luv.size() < 2 * static_cast<size_t>(tile.x) * static_cast<size_t>(tile.y)) return;
  const int side = std::min(tile.x, tile.y);
  const auto near = repetition(rendering_luv, tile, 0.0);
  const auto middle = repetition(rendering_luv, tile, side / 64.0);
  const auto far = repetition(rendering_luv, tile, side / 16.0);
  const auto share = [](const std::optional<Repetition>& found, const char* reason) {
    return found ? Measured::of(found->share) : Measured::undefined(reason);
  };
  const char* faded = "the rendering has only one color at this distance";
  row[Measure::repetition_near] = share(near, kOneColor);
  row[Measure::repetition_mid] = share(middle, faded);
  row[Measure::repetition_far] = share(far, faded);
  row[Measure::amplitude_far] = far ? Measured::of(far->amplitude_delta_e) : Measured::undefined(faded);
}

void measure_bands(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv, MeasureRow& row) {
  const auto ratios = octave_band_ratios(exemplar_luv, rendering_luv);
  for (size_t i = 0; i < kBandCount; ++i)
    row[static_cast<Measure>(static_cast<size_t>(Measure::band_finest) + i)] =
        measured(ratios[i], "the exemplar has no variation at this size");
}

void measure_fidelity(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv,
                      ImageView<const V3f> periodic_luv, uint32_t seed, MeasureRow& row) {
  row[Measure::color] = measured(color_distance(exemplar_luv, rendering_luv), kOneColor);
  const int side = std::min(exemplar_luv.width(), exemplar_luv.height());
  row[Measure::spectrum] =
      measured(spectrum_distance_db(exemplar_luv, rendering_luv),
               side < 32 ? fmt::format("the exemplar is {} texels wide, fewer than the 32 that a spectrum needs", side)
                         : kOneColor);
  const auto gradients = gradient_match(exemplar_luv, rendering_luv);
  row[Measure::gradient_ratio] = gradients ? Measured::of(gradients->ratio_of_means) : Measured::undefined(kOneColor);
  row[Measure::gradient_distance] =
      gradients ? Measured::of(gradients->quantile_distance) : Measured::undefined(kOneColor);
  row[Measure::structure] =
      measured(structure_distance(exemplar_luv, rendering_luv, periodic_luv, seed),
               side < 8 ? fmt::format("the exemplar is {} texels wide, narrower than a window of 8", side)
                        : "more than half of the exemplar's windows are exact copies of others, which leaves no "
                          "distance to compare with");
}

// Columns begin … end−1.
Image<V3f> columns(ImageView<const V3f> image, int begin, int end) {
  Image<V3f> part(end - begin, image.height());
  for (int y = 0; y < image.height(); ++y) std::copy(image.row(y) + begin, image.row(y) + end, part.row(y));
  return part;
}

}  // namespace

void measure_rendering(ImageView<const V3f> exemplar_luv, ImageView<const V3f> rendering_luv, uint32_t seed,
                       MeasureRow& row) {
  measure_repetition(rendering_luv, {exemplar_luv.width(), exemplar_luv.height()}, row);
  measure_bands(exemplar_luv, rendering_luv, row);
  measure_fidelity(exemplar_luv, rendering_luv, periodic_luv(exemplar_luv, {2, 2}), seed, row);
}

void measure_seams(ImageView<const V3f> exemplar_luv, const RenderingSources& sources, Adjacency adjacency,
                   MeasureRow& row) {
  const auto found = seams(exemplar_luv, sources.source, {sources.shape, adjacency, sources.shown});
  const auto set = [&](Measure measure, double Seams::*value) {
    row[measure] =
        found ? Measured::of((*found).*value) : Measured::undefined("no two contents meet: there is no seam");
  };
  set(Measure::seam_auc, &Seams::auc_own);
  set(Measure::seam_tail, &Seams::tail_own);
  set(Measure::seam_auc_all, &Seams::auc_all);
  set(Measure::seam_tail_all, &Seams::tail_all);
  set(Measure::seam_run, &Seams::run_px);
}

MeasureRow fidelity_floor(ImageView<const V3f> exemplar_luv) {
  MeasureRow row;
  const int half = exemplar_luv.width() / 2;
  if (half < 8 || exemplar_luv.height() < 8) {
    for (const Measure measure :
         {Measure::color, Measure::spectrum, Measure::gradient_ratio, Measure::gradient_distance, Measure::structure})
      row[measure] = Measured::undefined("the exemplar is too small to be halved");
    return row;
  }
  const Image<V3f> left = columns(exemplar_luv, 0, half);
  const Image<V3f> right = columns(exemplar_luv, half, 2 * half);
  measure_fidelity(left, right, left, 1, row);
  return row;
}

MeasureRow over_seeds(const std::vector<MeasureRow>& rows) {
  MeasureRow result;
  for (const MeasureKind& kind : measure_kinds()) {
    const auto n = static_cast<double>(rows.size());
    double sum = 0.0;
    double squares = 0.0;
    const Measured* undefined = nullptr;
    for (const MeasureRow& row : rows) {
      const Measured& one = row[kind.measure];
      if (!one.value) {
        undefined = &one;
        continue;
      }
      sum += one.value->mean;
      squares += one.value->mean * one.value->mean;
    }
    if (rows.empty()) continue;
    const double mean = sum / n;
    const double variance = n > 1 ? std::max(squares - sum * mean, 0.0) / (n - 1) : 0.0;
    result[kind.measure] = undefined ? *undefined : Measured::of(mean, std::sqrt(variance));
  }
  return result;
}

}  // namespace texbake
