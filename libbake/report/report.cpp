#include "libbake/report/report.h"

#include <algorithm>

#include "libbake/color/luv.h"
#include "libbake/color/seam_measure.h"
#include "libbake/content/choice_figures.h"
#include "libbake/quality/low_pass.h"
#include "libbake/report/cost.h"
#include "libbake/report/reduced_tile.h"
#include "libbake/report/rendering_measures.h"

namespace texbake {
namespace {

constexpr const char* kNoContents = "the bundle has no contents yet: run \"texbake select-contents\"";
constexpr int kMaxSeamTexels = 1 << 22;  // of the rendering in which seams are counted

const char* title_of(Method method) {
  switch (method) {
    case Method::periodic:
      return "Periodic tiling";
    case Method::wang:
      return "Wang tiles, 2 × 2 colours";
    case Method::hex:
      return "Hex tiling";
    default:
      return "This bundle";
  }
}

// The measured tile and what is drawn from it.
struct Scene {
  ReducedTile tile;
  EvaluatorPlanes planes;
  Image<V3f> exemplar;   // what all methods start from
  Image<V3f> luv;        // the same in CIELUV
  Image<V3f> base_luv;   // what contents exchange; the exemplar, or its structure
  V2i tiles{0, 0};       // of a rendering
  V2i seam_tiles{0, 0};  // of the one in which seams are counted

  V2i size() const { return planes.size; }
};

Scene make_scene(const ReportInput& input, const ReportOptions& options) {
  Scene scene;
  scene.tile = reduced_tile(input.tile, reduction_to(input.tile, options.side_px));
  scene.planes = prepare(scene.tile.input());
  scene.base_luv = luv_from_linear(scene.tile.base);
  scene.exemplar = input.exemplar.empty() ? scene.tile.base.clone() : reduce(input.exemplar, scene.tile.factor);
  scene.luv = luv_from_linear(scene.exemplar);
  scene.tiles = {options.tiles, options.tiles};
  int seam_tiles = std::min(options.tiles, 3);
  while (seam_tiles > 2 && static_cast<int64_t>(scene.luv.size()) * seam_tiles * seam_tiles > kMaxSeamTexels)
    --seam_tiles;
  scene.seam_tiles = {seam_tiles, seam_tiles};
  return scene;
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

void measure_method_seams(const Scene& scene, Method method, uint32_t seed, MeasureRow& row) {
  switch (method) {
    case Method::periodic:
      return measure_seams(scene.luv, periodic_sources(scene.size(), scene.seam_tiles), Adjacency::plane, row);
    case Method::wang:
      return measure_seams(scene.luv, wang_sources(scene.luv, scene.seam_tiles, seed), Adjacency::torus, row);
    case Method::hex:
      for (const Measure measure :
           {Measure::seam_auc, Measure::seam_tail, Measure::seam_auc_all, Measure::seam_tail_all, Measure::seam_run})
        row[measure] = Measured::undefined("every texel blends three readings: there is no seam");
      return;
    default:
      return measure_seams(scene.luv, bundle_sources(scene.planes, scene.seam_tiles, seed), Adjacency::torus, row);
  }
}

// Draws, measures and, once, pictures every method.
class Measuring {
 public:
  Measuring(const Scene& scene, const ReportOptions& options, Report& report, const Progress& progress)
      : scene_(scene), options_(options), report_(report), progress_(progress) {}

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
        texbake::report(progress_, 0.1 + 0.9 * done_);
      }
      report_.methods[static_cast<size_t>(method)] = over_seeds(rows);
    }
  }

 private:
  MeasureRow measured(Method method, uint32_t seed) {
    MeasureRow row;
    const Image<V3f> rendering = rendering_luv(scene_, method, seed);
    measure_rendering(scene_.luv, rendering, seed + 1, row);
    measure_method_seams(scene_, method, seed, row);
    if (seed == 0) add_pictures(method, rendering);
    return row;
  }

  void add_pictures(Method method, const Image<V3f>& rendering) {
    for (ReportPicture& picture : rendering_pictures(title_of(method), rendering, scene_.size()))
      report_.pictures.push_back(std::move(picture));
    if (method != Method::bundle) return;
    report_.pictures.push_back(seam_picture(scene_.luv, bundle_sources(scene_.planes, {2, 2}, 0)));
    report_.pictures.push_back(repetition_picture(rendering, scene_.size()));
  }

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

// Every judged measure. An edge of the pattern that runs along the wrap is doubtful at worst.
void judge_all(const SeamMeasure& seam, const ReportInput& input, Report& report) {
  const MeasureRow& row = report.of(Method::bundle);
  const int soft_border_px = input.tile.soft_border_px;
  std::vector<Verdict> verdicts;
  for (const MeasureKind& kind : measure_kinds()) {
    const auto limits = limits_of(kind.measure, std::max(report.content_count, 1), soft_border_px);
    const bool absent = is_noise(kind.measure) && !input.noise;
    if (!limits || absent) continue;
    Verdict verdict = judge(*limits, row[kind.measure]);
    const bool true_edge =
        (kind.measure == Measure::tile_x && seam.x.tiles()) || (kind.measure == Measure::tile_y && seam.y.tiles());
    if (true_edge) verdict = std::min(verdict, Verdict::warn);
    report.judgements.push_back({kind.measure, *limits, verdict});
    verdicts.push_back(verdict);
  }
  report.verdict = worst(verdicts);
}

}  // namespace

Report report(const ReportInput& input, const ReportOptions& options, const Progress& progress) {
  check_options(options);
  const EvaluatorPlanes planes = prepare(input.tile);
  const Scene scene = make_scene(input, options);
  Report result;
  result.tile_px = planes.size;
  result.reduction = scene.tile.factor;
  result.options = options;
  result.patch_count = input.tile.patches ? input.tile.patches->partition.count() : 0;
  result.content_count = input.tile.contents ? input.tile.contents->content_count : 0;

  // The tile by itself.
  const SeamMeasure seam = measure_seam(input.exemplar.empty() ? input.tile.base : input.exemplar);
  result.floor = fidelity_floor(scene.luv);
  result.suitability = suitability(input.contrast, find_lattice(scene.luv));
  result.pictures = bundle_pictures(input.tile, planes, input.exemplar, input.spectra);
  texbake::report(progress, 0.1);

  // Renderings of the bundle and of the baselines, and what needs none.
  Measuring(scene, options, result, progress).run(result.content_count > 0);
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
  judge_all(seam, input, result);
  return result;
}

}  // namespace texbake
