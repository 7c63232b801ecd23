// Reads the golden evaluation vectors of a stack of scales, as README.md beside this file specifies them.
#pragma once

#include "libbake/eval/stack_levels.h"
#include "libbake/eval/stack_window.h"
#include "tests/golden/golden.h"
#include "tests/libbake/eval/small_stack.h"

namespace texbake {

struct GoldenStackPoint {
  GoldenPoint near;  ///< of the finest scale
  float fading = 0;
  V3f faded{0};

  ScaleView view() const { return {1, 0, 1}; }
  ScaleView faded_view() const { return {1, fading, 1}; }
};

struct GoldenStack {
  int semantics = 0;
  StackPlanes planes;
  std::vector<GoldenStackPoint> points;
};

inline const char* const kGoldenStackName = "stack";

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
  scale.tile.patches = golden_patches(json, size);
  scale.tile.contents = golden_contents(json, scale.tile.patches.partition.count());
  return scale;
}

/// tests/golden/stack.json; TEXBAKE_GOLDEN names the folder.
inline GoldenStack read_golden_stack() {
  std::ifstream file(TEXBAKE_GOLDEN "/" + std::string(kGoldenStackName) + ".json");
  const nlohmann::json json = nlohmann::json::parse(file);
  ScaleTransfer transfer{.ratio = json.at("ratio")};
  transfer.weights = json.at("weights").get<std::vector<float>>();
  transfer.coarse_weights = json.at("coarse_weights").get<std::vector<float>>();
  SmallStack stack;
  for (const auto& scale : json.at("scales")) {
    stack.add(golden_scale(scale), transfer);
    // Without gains the dominant colours of classes mean nothing.
    stack.tiles.back().colors.palette.classes.resize(
        (&scale == &json.at("scales").front() ? transfer.coarse_weights : transfer.weights).size());
  }
  GoldenStack golden;
  golden.semantics = json.at("semantics");
  golden.planes = stack.planes();
  add_levels(golden.planes, stack.scales());
  for (const auto& point : json.at("points"))
    golden.points.push_back({golden_point(point), point.at("fading"), golden_color(point.at("faded"))});
  return golden;
}

}  // namespace texbake
