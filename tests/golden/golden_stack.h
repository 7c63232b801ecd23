// Reads the golden evaluation vectors of a stack of scales, as README.md beside this file specifies them.
#pragma once

#include <optional>

#include "libbake/draw/relief_window.h"
#include "libbake/planes/stack_levels.h"
#include "tests/golden/golden.h"
#include "tests/libbake/draw/small_stack.h"

namespace texbake {

struct GoldenStackPoint {
  GoldenPoint near;  ///< of the finest scale; its trilinear filter has variation
  float fading = 0, variation = 1;
  V3f faded{0};
  Direction viewer;  ///< this and what follows: with relief
  TileOffset met_x, met_y;
  int light_4096 = 4096;
  V3f lit{0};

  ScaleView view(int finest) const { return {finest, 0, 1}; }
  ScaleView faded_view(int finest) const { return {finest, fading, variation}; }
  ScaleView leveled_view(int finest) const { return {finest, 0, variation, near.level_256}; }
  /// What a pixel that is lit has beside its place: decided_of of shaders/stack_relief.glsl.
  PixelDecision relief_decision(int finest) const {
    return {met_x.offset_256, met_y.offset_256 | 256u << 22, 1u << 16 | static_cast<uint32_t>(finest) << 24,
            static_cast<uint32_t>(light_4096 - 4096) * 2654435769u};
  }
};

struct GoldenStack {
  int semantics = 0;
  StackPlanes planes;
  std::optional<ReliefPlanes> relief;
  std::vector<GoldenStackPoint> points;
};

inline const char* const kGoldenStackNames[] = {"stack",        "stack_turned", "stack_three",     "stack_soft",
                                                "stack_relief", "stack_noise",  "stack_noise_soft"};

inline ScaleTile golden_scale(const nlohmann::json& json) {
  const V2i size(json.at("size").at(0).get<int>(), json.at("size").at(1).get<int>());
  ScaleTile scale;
  scale.tile.base = Image<V3f>(size.x, size.y);
  scale.colors.index = Image<uint8_t>(size.x, size.y);
  scale.colors.variation = Image<float>(size.x, size.y);
  Partition& fragments = scale.fragments.partition;
  fragments.idx = Image<uint32_t>(size.x, size.y);
  fragments.owner = Image<OwnerOffset>(size.x, size.y);
  for (size_t i = 0; i < fragments.idx.size(); ++i) {
    scale.tile.base.data()[i] = golden_color(json.at("base").at(i));
    scale.colors.index.data()[i] = json.at("class_idx").at(i);
    fragments.idx.data()[i] = json.at("fragment_idx").at(i);
    fragments.owner.data()[i] = {json.at("fragment_owner_x").at(i), json.at("fragment_owner_y").at(i)};
  }
  for (const auto& c : json.at("fragment_centers"))
    fragments.centers.emplace_back(c.at(0).get<int>(), c.at(1).get<int>());
  for (const auto& k : json.at("fragment_class")) scale.fragments.fragments.push_back({k.get<uint32_t>(), V3f(0)});
  for (const auto& luv : json.at("palette")) scale.colors.palette.classes.push_back({golden_color(luv), V3f(1, 0, 0)});
  scale.tile.soft_border_px = json.value("soft_border", 0);
  scale.tile.patches = golden_patches(json, size);
  scale.tile.contents = golden_contents(json, scale.tile.patches.partition.count());
  GoldenNoise noise = golden_noise(json, size);
  scale.tile.masks = std::move(noise.masks);
  scale.tile.noises = std::move(noise.noises);
  scale.tile.noise_step = noise.step;
  scale.tile.noise_space = noise.space;
  return scale;
}

inline ScaleTransfer golden_transfer(const nlohmann::json& json) {
  ScaleTransfer transfer{.ratio = json.at("ratio")};
  transfer.detail_mean = json.at("detail_mean") == "local" ? DetailMean::local : DetailMean::tile;
  transfer.weights = json.at("weights").get<std::vector<float>>();
  transfer.coarse_weights = json.at("coarse_weights").get<std::vector<float>>();
  transfer.detail_gains = json.at("detail_gains").get<std::vector<float>>();
  return transfer;
}

inline ReliefPlanes golden_relief(const nlohmann::json& json, const ScaleTile& coarsest) {
  const V2i size = coarsest.tile.size();
  Image<float> height(size.x, size.y), normal[3] = {{size.x, size.y}, {size.x, size.y}, {size.x, size.y}};
  for (size_t i = 0; i < height.size(); ++i) {
    height.data()[i] = json.at("height").at(i);
    for (size_t c = 0; c < 3; ++c) normal[c].data()[i] = json.at("normal").at(i).at(c);
  }
  EvaluatorInput input = coarsest.input();
  input.maps.push_back({"height", MapKind::height, {height}});
  input.maps.push_back({"normal", MapKind::normal_opengl, {normal[0], normal[1], normal[2]}});
  const auto& light = json.at("light");
  const ReliefOptions options{.depth_px = json.at("depth"),
                              .shade_by = ShadeBy::normal,
                              .ambient = light.at(2),
                              .linear_steps = json.at("steps").at(0),
                              .binary_steps = json.at("steps").at(1)};
  return relief_planes(input, options, {light.at(0), light.at(1), 1});
}

inline GoldenStackPoint golden_stack_point(const nlohmann::json& json) {
  GoldenStackPoint point;
  point.near = golden_point(json);
  point.fading = json.at("fading");
  point.variation = json.at("variation");
  point.faded = golden_color(json.at("faded"));
  if (!json.contains("lit")) return point;
  point.viewer = {-json.at("way").at(0).get<float>(), -json.at("way").at(1).get<float>(), 1};
  point.met_x = {json.at("met_tile").at(0), json.at("met_256").at(0)};
  point.met_y = {json.at("met_tile").at(1), json.at("met_256").at(1)};
  point.light_4096 = json.at("light_4096");
  point.lit = golden_color(json.at("lit"));
  return point;
}

/// tests/golden/NAME.json; TEXBAKE_GOLDEN names the folder.
inline GoldenStack read_golden_stack(const std::string& name) {
  std::ifstream file(TEXBAKE_GOLDEN "/" + name + ".json");
  const nlohmann::json json = nlohmann::json::parse(file);
  SmallStack stack;
  for (const auto& scale : json.at("scales"))
    stack.add(golden_scale(scale),
              scale.contains("transfer") ? golden_transfer(scale.at("transfer")) : ScaleTransfer());
  GoldenStack golden;
  golden.semantics = json.at("semantics");
  golden.planes = stack.planes();
  if (json.contains("relief")) golden.relief = golden_relief(json.at("relief"), stack.tiles.front());
  for (const auto& point : json.at("points")) golden.points.push_back(golden_stack_point(point));
  return golden;
}

}  // namespace texbake
