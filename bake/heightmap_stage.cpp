#include "bake/heightmap_stage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bake/option_json.h"
#include "bake/provenance.h"
#include "bake/running_stage.h"
#include "bake/stage_parts.h"
#include "libbake/height/shading.h"

namespace texbake {
namespace {

/// The photograph's size, as convert has recorded it.
V2i source_size(const Bundle& bundle, V2i tile) {
  const Stage* convert = find_stage(bundle, "convert");
  const Json size = convert ? convert->figures.value("sourceSize", Json()) : Json();
  if (!size.is_array() || size.size() != 2 || !size[0].is_number_integer() || !size[1].is_number_integer()) return tile;
  return {size[0].get<int>(), size[1].get<int>()};
}

int scaled(int texel, int from, int to) {
  return texel < 0 ? texel : static_cast<int>((2 * int64_t{texel} + 1) * to / (2 * int64_t{from}));
}

void check_picture_size(const ClickFile& file, V2i expected, const char* what) {
  if (file.picture_size && *file.picture_size != expected)
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: expected {} x {} texels, the size of the {}, found {} x {}", file.name, expected.x,
                            expected.y, what, file.picture_size->x, file.picture_size->y));
}

Json figures_of(const Heightmap& map, size_t clicks, const std::optional<Image<float>>& replaced) {
  const auto [least, most] = std::minmax_element(map.height_01.begin(), map.height_01.end());
  Json figures = {{"clicks", clicks},
                  {"clicksUsed", map.clicks_used},
                  {"classesWithoutClick", map.classes_without_click},
                  {"leastHeight", *least},
                  {"mostHeight", *most}};
  if (replaced) figures["correlationWithReplaced"] = correlation(map.height_01, *replaced);
  return figures;
}

void tell(const Heightmap& map, size_t clicks, Listener& listener) {
  if (!map.classes_without_click.empty())
    listener.warning(
        fmt::format("no click lies on color class {}: its heights were taken from all clicks, by appearance; \"texbake "
                    "render --show index\" shows where that class is",
                    fmt::join(map.classes_without_click, ", ")));
  if (static_cast<size_t>(map.clicks_used) < clicks)
    listener.note(fmt::format(
        "{} of {} clicks were used, those whose surroundings differ most; a larger --max-representatives keeps more",
        map.clicks_used, clicks));
}

void replace_source(Bundle& bundle, const ClickFile& file) {
  std::erase_if(bundle.sources, [](const SourceFile& source) { return source.role == kClicksRole; });
  bundle.sources.push_back({kClicksRole, file.name, file.sha256, file.size_bytes});
}

}  // namespace

std::vector<HeightClick> clicks_on_tile(const ClickFile& file, const Bundle& bundle, ClickSpace space) {
  const Scale& scale = bundle.scales.front();
  std::vector<HeightClick> clicks = file.clicks;
  if (space == ClickSpace::tile) {
    check_picture_size(file, scale.size(), "tile");
    return clicks;
  }
  const V2i source = source_size(bundle, scale.size());
  check_picture_size(file, source, "source");
  for (HeightClick& click : clicks) {
    if (scale.tile_from_source)
      click.texel -= *scale.tile_from_source;
    else
      click.texel = {scaled(click.texel.x, source.x, scale.width()),
                     scaled(click.texel.y, source.y, scale.height_px())};
  }
  return clicks;
}

void run_heightmap(Bundle& bundle, const ClickFile& file, ClickSpace space, const HeightmapOptions& options,
                   Listener& listener) {
  Scale& scale = only_scale(bundle);
  const PrincipalVariation& colors = required(scale.colors, "a palette", "convert");
  const std::vector<HeightClick> clicks = clicks_on_tile(file, bundle, space);
  RunningStage stage(bundle, "heightmap", listener);
  Heightmap map = heightmap(colors, scale.base(), clicks, options, stage.progress());
  stage.replace();
  replace_source(bundle, file);
  const Json figures = figures_of(map, clicks.size(), scale.height);
  tell(map, clicks.size(), listener);
  scale.height = std::move(map.height_01);
  Json parameters = parameters_of(options, resolve(options));
  parameters["source-coordinates"] = space == ClickSpace::source;
  stage.finish(parameters, figures);
}

}  // namespace texbake
