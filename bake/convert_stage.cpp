#include "bake/convert_stage.h"

#include <fmt/format.h>

#include "bake/option_json.h"
#include "bake/running_stage.h"
#include "libbake/base/half.h"

namespace texbake {
namespace {

/// The exemplar, rounded to what the bundle stores, so that this stage and the next see the same values.
Image<V3f> half_exact_tile(const TilePlan& plan, const FlattenOptions& options, ImageView<const V3f> source) {
  Image<V3f> tile = flatten(apply(plan, source), options);
  for (V3f& texel : tile) texel = half_exact(texel);
  return tile;
}

std::string size_text(V2i size) { return fmt::format("{} x {}", size.x, size.y); }

std::string seam_text(const SeamMeasure& seam) { return fmt::format("{:.2f} / {:.2f}", seam.x.ratio, seam.y.ratio); }

/// What was done to make the picture a tile, and why.
void tell_of_tile(const TilePlan& plan, const std::string& name, Listener& listener) {
  if (plan.is_cut())
    listener.warning(fmt::format(
        "{}: does not tile: the step across its wrap seam is {} (x / y) times an ordinary step; closed along a "
        "minimum-error cut: {} of {} texels are kept, and the step is now {}",
        name, seam_text(plan.before), size_text(plan.size()), size_text(plan.source_size), seam_text(plan.after)));
  else if (!plan.before.tiles())
    listener.warning(
        fmt::format("{}: used as a tile, but the step across its wrap seam is {} (x / y) times an ordinary step and "
                    "may show; --periodic make closes it",
                    name, seam_text(plan.before)));
  if (plan.is_resampled())
    listener.note(fmt::format("{}: resampled to {} texels, a multiple for which mip levels exist (--multiple)", name,
                              size_text(plan.size())));
}

void warn_of_other_size(const std::string& map, const Picture& picture, const TilePlan& plan, Listener& listener) {
  const V2i size(picture.width(), picture.height());
  if (size != plan.source_size)
    listener.warning(fmt::format("map {}: {} texels, but the color has {}; resampled to the color's size", map,
                                 size_text(size), size_text(plan.source_size)));
}

/// Moves the maps into the scale, along the same cuts as the color: relief to its own plane, the others to the list.
void add_maps(Scale& scale, const ConvertRequest& request, const TilePlan& plan, Material& material,
              Listener& listener) {
  for (size_t i = 0; i < material.maps.size(); ++i) {
    const std::string& name = request.files.maps[i].name;
    Picture& picture = material.maps[i];
    warn_of_other_size(name, picture, plan, listener);
    if (name == kHeightMap && has_steps(picture))
      listener.warning(
          fmt::format("map {}: slopes of {} bits, whose {} levels may be seen as steps; a picture of 16 bits is better",
                      name, picture.source_bits, 1 << picture.source_bits));
    if (name == kHeightMap)
      scale.height = height_tile(plan, picture);
    else
      scale.maps.push_back(map_tile(plan, name, picture, request.import.normal_convention));
  }
}

void add_sources(Bundle& bundle, const ConvertRequest& request, const Material& material) {
  bundle.sources.push_back(source_of("color", material.color));
  for (size_t i = 0; i < material.maps.size(); ++i)
    bundle.sources.push_back(source_of(request.files.maps[i].name, material.maps[i]));
}

/// plan_tile, whose errors tell which picture they are about.
TilePlan named_plan(ImageView<const V3f> source, const ConvertRequest& request) {
  try {
    return plan_tile(source, request.periodic);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", request.files.color.file, error.what()));
  }
}

Json parameters_of(const ConvertRequest& asked, const ConvertRequest& effective) {
  Json parameters = Json::object();
  add_parameters(parameters, asked.import, effective.import);
  add_parameters(parameters, asked.periodic, effective.periodic);
  add_parameters(parameters, asked.flatten, effective.flatten);
  add_parameters(parameters, asked.convert, effective.convert);
  add_parameters(parameters, asked.storage, effective.storage);
  return parameters;
}

Json seam_json(const SeamMeasure& seam) { return {{"x", seam.x.ratio}, {"y", seam.y.ratio}}; }

/// For each axis the width of the strip in which the cut runs, 0 for an axis that is not cut.
Json cut_json(const TilePlan& plan) {
  return {{"x", plan.x.cut ? plan.x.overlap : 0}, {"y", plan.y.cut ? plan.y.overlap : 0}};
}

Json figures_of(const TilePlan& plan, const ColorError& error) {
  return {{"sourceSize", {plan.source_size.x, plan.source_size.y}},
          {"cutOverlap", cut_json(plan)},
          {"seamBefore", seam_json(plan.before)},
          {"seamAfter", seam_json(plan.after)},
          {"cutRatio", plan.cut_ratio},
          {"meanDeltaE", error.mean_delta_e},
          {"p99DeltaE", error.p99_delta_e}};
}

}  // namespace

Bundle run_convert(const ConvertRequest& request, Listener& listener) {
  for_each_options(request, [](const auto& options) { check_options(options); });
  Material material = read_material(request.files, request.import, listener);
  Bundle bundle;
  add_sources(bundle, request, material);
  RunningStage stage(bundle, "convert", listener);

  // A tile that closes, of the color and, along the same cuts, of every map.
  const Image<V3f> source = interleave(material.color.planes);
  const TilePlan plan = named_plan(source, request);
  tell_of_tile(plan, material.color.name, listener);
  Scale scale;
  scale.exemplar = half_exact_tile(plan, request.flatten, source);
  if (plan.is_cut()) scale.tile_from_source = plan.tile_from_source();
  add_maps(scale, request, plan, material, listener);

  // Palette, index and variation (CE13 §4).
  const ImageView<const float> height = scale.height ? scale.height->view() : ImageView<const float>();
  Conversion conversion = convert(scale.exemplar, height, request.convert, stage.progress());
  scale.colors = std::move(conversion.colors);
  scale.stores_exemplar = request.storage.color == ColorForm::full;
  if (!scale.stores_exemplar) scale.exemplar = palette_exemplar(*scale.colors);
  bundle.scales.push_back(std::move(scale));

  ConvertRequest effective = request;
  effective.convert = conversion.effective;
  stage.finish(parameters_of(request, effective), figures_of(plan, conversion.error));
  return bundle;
}

}  // namespace texbake
