// Reads the golden evaluation vectors, as README.md beside this file specifies them.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "libbake/draw/frame.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "libbake/reference/semantics.h"

namespace texbake {

struct GoldenPoint {
  TileOffset x, y;
  uint32_t seed = 0;
  PixelDecision decision;
  V3f nearest{0}, bilinear{0};
  uint32_t step_256 = 0;  ///< of the trilinear filter; 0 where there is none, and in stacks
  int level_256 = 0;
  V3f trilinear{0};

  /// A window whose one pixel has its center at the point.
  Window window(Filter filter) const {
    Window window;
    window.origin_x = x;
    window.origin_y = y;
    window.step_256 = 1;
    window.width = window.height = 1;
    window.seed = seed;
    window.filter = filter;
    return window;
  }

  /// One whose one pixel, as large as the trilinear filter's, has its center there.
  Window trilinear_window(V2i tile_size) const {
    Window window = this->window(Filter::trilinear);
    window.step_256 = step_256;
    window.origin_x = before(x, tile_size.x);
    window.origin_y = before(y, tile_size.y);
    return window;
  }

 private:
  TileOffset before(const TileOffset& at, int side) const {
    const TileOffset moved = tile_offset(0, int64_t{at.offset_256} - step_256 / 2, side);
    return {at.tile + moved.tile, moved.offset_256};
  }
};

struct Golden {
  int semantics = 0;
  EvaluatorPlanes planes;
  std::vector<GoldenPoint> points;
};

inline const char* const kGoldenNames[] = {"plain",        "moved",  "turned",      "noise",
                                           "noise_linear", "levels", "noise_levels"};

inline V3f golden_color(const nlohmann::json& json) {
  return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

inline PatchMap golden_patches(const nlohmann::json& json, V2i size) {
  PatchMap patches;
  Partition& partition = patches.partition;
  partition.idx = Image<uint32_t>(size.x, size.y);
  partition.owner = Image<OwnerOffset>(size.x, size.y);
  for (size_t i = 0; i < partition.idx.size(); ++i) {
    partition.idx.data()[i] = json.at("patch_idx").at(i);
    partition.owner.data()[i] = {json.at("owner_x").at(i), json.at("owner_y").at(i)};
  }
  for (const auto& c : json.at("centers")) partition.centers.emplace_back(c.at(0).get<int>(), c.at(1).get<int>());
  return patches;
}

inline ContentTable golden_contents(const nlohmann::json& json, int patch_count) {
  ContentTable table{patch_count, json.at("content_count"), {}};
  for (const auto& row : json.at("contents")) {
    Content content;
    content.translation = {row.at(0).get<int>(), row.at(1).get<int>()};
    content.scale = row.at(2).get<float>() / 65536.0f;
    content.a = row.at(3);
    content.b = row.at(4);
    table.contents.push_back(content);
  }
  return table;
}

struct GoldenNoise {
  std::vector<Image<float>> masks;
  std::vector<Image<V3f>> noises;
  int step = 0;
  NoiseSpace space = NoiseSpace::root;
};

/// Masks and noises; none in a file without them.
inline GoldenNoise golden_noise(const nlohmann::json& json, V2i size) {
  GoldenNoise golden;
  if (!json.contains("noise_step")) return golden;
  const int side = json.at("noise_side");
  golden.step = json.at("noise_step");
  golden.space = enum_value<NoiseSpace>(json.at("noise_space").get<std::string>()).value();
  for (size_t k = 0; k < json.at("noises").size(); ++k) {
    Image<float>& mask = golden.masks.emplace_back(size.x, size.y);
    for (size_t i = 0; i < mask.size(); ++i) mask.data()[i] = json.at("masks").at(k).at(i).get<float>() / 2048.0f;
    Image<V3f>& noise = golden.noises.emplace_back(side, side);
    for (size_t i = 0; i < noise.size(); ++i) noise.data()[i] = golden_color(json.at("noises").at(k).at(i));
  }
  return golden;
}

inline GoldenPoint golden_point(const nlohmann::json& json) {
  GoldenPoint point;
  point.x = {json.at("tile").at(0), json.at("offset_256").at(0)};
  point.y = {json.at("tile").at(1), json.at("offset_256").at(1)};
  point.seed = json.at("seed");
  point.decision = {json.at("patch"), json.at("content"), json.at("source").at(0), json.at("source").at(1)};
  point.nearest = golden_color(json.at("nearest"));
  point.bilinear = golden_color(json.at("bilinear"));
  if (json.contains("trilinear")) {
    point.step_256 = json.value("step_256", 0u);
    point.level_256 = json.at("level_256");
    point.trilinear = golden_color(json.at("trilinear"));
  }
  return point;
}

/// tests/golden/NAME.json; TEXBAKE_GOLDEN names the folder.
inline Golden read_golden(const std::string& name) {
  std::ifstream file(TEXBAKE_GOLDEN "/" + name + ".json");
  const nlohmann::json json = nlohmann::json::parse(file);
  const V2i size(json.at("size").at(0).get<int>(), json.at("size").at(1).get<int>());
  Image<V3f> base(size.x, size.y);
  for (size_t i = 0; i < base.size(); ++i) base.data()[i] = golden_color(json.at("base").at(i));
  const auto [masks, noises, step, space] = golden_noise(json, size);
  const PatchMap patches = golden_patches(json, size);
  const ContentTable contents = golden_contents(json, patches.partition.count());

  Golden golden;
  golden.semantics = json.at("semantics");
  EvaluatorInput input;
  input.base = base;
  input.patches = &patches;
  input.contents = &contents;
  if (!masks.empty())
    input.noise = NoiseInput{{masks.begin(), masks.end()}, {noises.begin(), noises.end()}, step, space};
  golden.planes = prepare(input);
  for (const auto& point : json.at("points")) golden.points.push_back(golden_point(point));
  return golden;
}

}  // namespace texbake
