#include "libbake/report/report.h"

#include <algorithm>

#include "libbake/color/luv.h"
#include "libbake/content/choice_figures.h"
#include "libbake/report/cost.h"
#include "libbake/report/rendering_measures.h"
#include "libbake/report/scene.h"
#include "libbake/tile/seam_measure.h"

namespace texbake {
namespace {

constexpr const char* kNoContents = "the bundle has no contents yet: run \"texbake select-contents\"";

const char* title_of(Method method) {
  switch (method) {
    case Method::periodic:
      return "Periodic tiling";
    case Method::wang:
      return "Wang tiles, 2 × 2 colors";
    case Method::hex:
      return "Hex tiling";
    default:
      return "This bundle";
  }
}

Image<V3f> rendering_luv(const Scene& scene, Method method, uint32_t seed) {
  switch (method) {
    case Method::periodic:
      return periodic_luv(scene.luv, scene.tiles);
    case Method::wang:
      return wang_luv(scene.luv, scene.tiles, seed);
    case Method::hex:
      return hex_luv(scene.exemplar, scene.tiles, seed);
    default:
      return bundle_luv(scene.planes, scene.tiles, seed);
  }
}

void measure_method_seams(const Scene& scene, V2i tiles, Method method, uint32_t seed, MeasureRow& row) {
  switch (method) {
    case Method::periodic:
      return measure_seams(scene.luv, periodic_sources(scene.size(), tiles), Adjacency::plane, row);
    case Method::wang:
      return measure_seams(scene.luv, wang_sources(scene.luv, tiles, seed), Adjacency::torus, row);
    case Method::hex:
      for (const Measure measure :
           {Measure::seam_auc, Measure::seam_tail, Measure::seam_auc_all, Measure::seam_tail_all, Measure::seam_run})
        row[measure] = Measured::undefined("every texel blends three samples: there is no seam");
      return;
    default:
      return measure_seams(scene.luv, bundle_sources(scene.planes, tiles, seed), Adjacency::torus, row);
  }
}

// Draws, measures and, once, pictures every method.
class Measuring {
 public:
  Measuring(const Scenes& scenes, const ReportOptions& options, Report& report, const Progress& progress)
      : scenes_(scenes), scene_(scenes.main), options_(options), report_(report), progress_(progress) {}

  void run(bool has_contents) {
    const std::vector<Method> methods = has_contents
                                            ? std::vector{Method::bundle, Method::periodic, Method::wang, Method::hex}
                                            : std::vector{Method::periodic, Method::wang, Method::hex};
    for (const Method method : methods) {
      // Periodic tiling is the same for every seed.
      const int seeds = method == Method::periodic ? 1 : options_.seeds;
      std::vector<MeasureRow> rows;
      for (int seed = 0; seed < seeds; ++seed) {
        rows.push_back(measured(method, static_cast<uint32_t>(seed)));
        done_ += 1.0 / (seeds * static_cast<double>(methods.size()));
        report_progress(progress_, 0.1 + 0.9 * done_);
      }
      report_.methods[static_cast<size_t>(method)] = over_seeds(rows);
    }
  }

 private:
  MeasureRow measured(Method method, uint32_t seed) {
    MeasureRow row;
    const Image<V3f> rendering = rendering_luv(scene_, method, seed);
    measure_rendering(scene_.luv, rendering, seed + 1, row);
    measure_method_seams(scenes_.seams(), scenes_.seam_tiles, method, seed, row);
    if (seed == 0) add_pictures(method, rendering);
    return row;
  }

  void add_pictures(Method method, const Image<V3f>& rendering) {
    for (ReportPicture& picture : rendering_pictures(title_of(method), rendering, scene_.size()))
      report_.pictures.push_back(std::move(picture));
    if (method != Method::bundle) return;
    const Scene& seams = scenes_.seams();
    report_.pictures.push_back(seam_picture(seams.luv, bundle_sources(seams.planes, {2, 2}, 0)));
    report_.pictures.push_back(repetition_picture(rendering, scene_.size()));
  }

  const Scenes& scenes_;
  const Scene& scene_;
  const ReportOptions& options_;
  Report& report_;
  const Progress& progress_;
  double done_ = 0;
};

// What the contents foretell without drawing.
void add_prediction(const Scene& scene, const std::optional<PairImpact>& pairs, MeasureRow& row) {
  const ChoiceFigures figures = choice_figures(*scene.tile.contents, scene.base_luv, scene.tile.patches->partition);
  row[Measure::predicted_near] = Measured::of(figures.repetition_near);
  row[Measure::predicted_far] = Measured::of(figures.repetition_far);
  row[Measure::pair_mean] = pairs ? Measured::of(pairs->mean) : Measured::undefined("select-contents recorded none");
  row[Measure::pair_worst] = pairs ? Measured::of(pairs->worst) : Measured::undefined("select-contents recorded none");
}

bool is_noise(Measure measure) { return kind_of(measure).group == "Noise"; }

void undefine_missing(const std::string& reason, MeasureRow& row) {
  for (const MeasureKind& kind : measure_kinds()) {
    Measured& measured = row[kind.measure];
    if (!measured.value && measured.undefined_because.empty() && !is_noise(kind.measure))
      measured = Measured::undefined(reason);
  }
}

void add_noise(const NoiseSummary& noise, MeasureRow& row) {
  const auto set = [&](Measure measure, const std::optional<double>& value) {
    row[measure] = value ? Measured::of(*value) : Measured::undefined("decompose or estimate-psd recorded none");
  };
  set(Measure::noise_spectrum, noise.spectrum_db);
  set(Measure::noise_power, noise.power_error);
  set(Measure::noise_kurtosis, noise.excess_kurtosis);
  set(Measure::noise_energy, noise.energy_deviation);
  set(Measure::noise_coherence, noise.coherence_drop);
}

// One axis of a wrap. An edge of the pattern that runs along it is doubtful at worst.
Verdict judge_wrap(const AxisSeam& axis) {
  const Verdict verdict = judge(*limits_of(Measure::tile_x, 1), Measured::of(axis.ratio));
  return axis.tiles() ? std::min(verdict, Verdict::warn) : verdict;
}

SeamMeasure measure_map(const MapInput& map) {
  if (map.channels.size() < 3) return measure_seam(map.channels[0]);
  Image<V3f> values(map.channels[0].width(), map.channels[0].height());
  for (size_t at = 0; at < values.size(); ++at)
    for (size_t c = 0; c < 3; ++c) values.data()[at][static_cast<int>(c)] = map.channels[c].data()[at];
  return measure_vector_seam(values);
}

std::vector<MapReport> map_reports(const std::vector<MapInput>& maps) {
  std::vector<MapReport> reports;
  for (const MapInput& map : maps) {
    const SeamMeasure seam = measure_map(map);
    reports.push_back({map.name, seam.x.ratio, seam.y.ratio, std::max(judge_wrap(seam.x), judge_wrap(seam.y))});
  }
  return reports;
}

// Every judged measure, and the maps.
void judge_all(const SeamMeasure& seam, int soft_border_px, bool has_noise, Report& report) {
  const MeasureRow& row = report.of(Method::bundle);
  std::vector<Verdict> verdicts;
  for (const MapReport& map : report.maps) verdicts.push_back(map.verdict);
  for (const MeasureKind& kind : measure_kinds()) {
    const auto limits = limits_of(kind.measure, std::max(report.content_count, 1), soft_border_px);
    const bool absent = is_noise(kind.measure) && !has_noise;
    if (!limits || absent) continue;
    Verdict verdict = judge(*limits, row[kind.measure]);
    if (kind.measure == Measure::tile_x) verdict = judge_wrap(seam.x);
    if (kind.measure == Measure::tile_y) verdict = judge_wrap(seam.y);
    report.judgements.push_back({kind.measure, *limits, verdict});
    verdicts.push_back(verdict);
  }
  report.verdict = worst(verdicts);
}

}  // namespace

Report report(const ReportInput& input, const ReportOptions& options, const Progress& progress) {
  check_options(options);
  const EvaluatorPlanes planes = prepare(input.tile);
  const Scenes scenes = make_scenes(input, options);
  const Scene& scene = scenes.main;
  Report result;
  result.tile_px = planes.size;
  result.reduction = scene.tile.factor;
  result.seam_reduction = scenes.seams().tile.factor;
  result.options = options;
  result.patch_count = input.tile.patches ? input.tile.patches->partition.count() : 0;
  result.content_count = input.tile.contents ? input.tile.contents->content_count : 0;

  // The tile by itself.
  const SeamMeasure seam = measure_seam(input.exemplar.empty() ? input.tile.base : input.exemplar);
  result.maps = map_reports(input.tile.maps);
  result.floor = fidelity_floor(scene.luv);
  result.suitability = suitability(input.contrast, find_lattice(scene.luv));
  result.pictures = bundle_pictures(input.tile, planes, input.exemplar, input.spectra);
  report_progress(progress, 0.1);

  // Renderings of the bundle and of the baselines, and what needs none.
  Measuring(scenes, options, result, progress).run(result.content_count > 0);
  for (MeasureRow& row : result.methods) {
    row[Measure::tile_x] = Measured::of(seam.x.ratio);
    row[Measure::tile_y] = Measured::of(seam.y.ratio);
  }
  if (result.content_count > 0)
    add_prediction(scene, input.pairs, result.methods[static_cast<size_t>(Method::bundle)]);
  else
    undefine_missing(kNoContents, result.methods[static_cast<size_t>(Method::bundle)]);
  if (input.noise) add_noise(*input.noise, result.methods[static_cast<size_t>(Method::bundle)]);
  add_cost(planes, result.methods);
  judge_all(seam, scenes.seams().tile.soft_border_px, input.noise.has_value(), result);
  return result;
}

}  // namespace texbake
