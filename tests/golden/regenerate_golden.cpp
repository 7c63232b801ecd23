// Writes the golden evaluation vectors, computed by the slow painter of the tests, never by the evaluator.
// usage: regenerate_golden FOLDER. A file of the same semantics that would change is left alone: exit 1.
#include <bit>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "libbake/color/luv.h"
#include "libbake/reference/semantics.h"
#include "tests/libbake/draw/relief_painter.h"

namespace texbake {
namespace {

/// Floats print in the fewest digits that give them back.
using Json =
    nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t, std::uint64_t, float>;

struct Point {
  int64_t x_256, y_256;  ///< from the infinite texture's origin
  uint32_t seed;
};

/// Points on centers, lines and corners of texels, at borders of the tile, and anywhere; near and far.
std::vector<Point> points_of(V2i n) {
  Random random(2024, 5);
  const int64_t kTiles[] = {0, 1, -1, 5, -7, int64_t{1} << 31, -(int64_t{1} << 31), (int64_t{1} << 32) - 1, 987654321};
  const auto coordinate = [&](int side) {
    const int64_t tile = kTiles[random.below(9)];
    const int64_t texel = random.below(3) == 0 ? static_cast<int64_t>(random.below(3)) - 1
                                               : static_cast<int64_t>(random.below(static_cast<uint32_t>(side)));
    const int64_t kFractions[] = {0, 127, 128, 129, 255, random.below(256)};
    return (tile * side + texel) * 256 + kFractions[random.below(6)];
  };
  std::vector<Point> points;
  for (int i = 0; i < 256; ++i) {
    const int64_t x = coordinate(n.x), y = coordinate(n.y);
    points.push_back({x, y, i % 3 == 0 ? 0u : random.next()});
  }
  return points;
}

Json color_json(const V3f& c) { return {c.x, c.y, c.z}; }

Json place_json(int64_t at_256, int side) {
  const int64_t tile = Painter::floor_div(at_256, int64_t{side} * 256);
  return {static_cast<uint32_t>(static_cast<uint64_t>(tile)), at_256 - tile * side * 256};
}

Json point_json(const SmallTile& tile, const Point& point) {
  const V2i n = tile.size();
  const int64_t left = (point.x_256 - 128) >> 8, top = (point.y_256 - 128) >> 8;
  const Painting near = Painter(tile, point.seed).paint(left, top, 2, 2);
  const int i = static_cast<int>((point.x_256 >> 8) - left), j = static_cast<int>((point.y_256 >> 8) - top);
  const double wx = static_cast<double>(point.x_256 - 128 - left * 256) / 256;
  const double wy = static_cast<double>(point.y_256 - 128 - top * 256) / 256;
  const Json x = place_json(point.x_256, n.x), y = place_json(point.y_256, n.y);
  const auto& color = near.color;
  return {{"tile", {x[0], y[0]}},
          {"offset_256", {x[1], y[1]}},
          {"seed", point.seed},
          {"patch", near.patch(i, j)},
          {"content", near.content(i, j)},
          {"source", {near.source(i, j).x, near.source(i, j).y}},
          {"nearest", color_json(color(i, j))},
          {"bilinear", color_json(Painter::blend(color(0, 0), color(1, 0), color(0, 1), color(1, 1), wx, wy))}};
}

/// Steps of pixels with whole and fractional levels, up to `levels`.
struct Step {
  uint32_t step_256;
  int level_256;
};
Step step_of(Random& random, int levels) {
  const uint32_t step_256 = random.below(4) == 0 ? 256u << random.below(static_cast<uint32_t>(levels) + 1)
                                                 : 256 + random.below((256u << levels) - 255);
  return {step_256, static_cast<int>(std::lround(256 * std::log2(step_256 / 256.0)))};
}

/// The points with the trilinear filter beside.
Json leveled_json(const SmallTile& tile, const Point& point, Random& random) {
  const Step step = step_of(random, std::countr_zero(static_cast<uint32_t>(tile.size().x | tile.size().y)));
  Json json = point_json(tile, point);
  json["step_256"] = step.step_256;
  json["level_256"] = step.level_256;
  json["trilinear"] = color_json(LevelPainter(tile, point.seed).trilinear(point.x_256, point.y_256, step.level_256));
  return json;
}

Json tile_json(const SmallTile& tile) {
  const Partition& partition = tile.patches.partition;
  Json json = {{"semantics", kSemantics}, {"size", {tile.size().x, tile.size().y}}};
  json["content_count"] = tile.contents.content_count;
  for (const V2i& c : partition.centers) json["centers"].push_back({c.x, c.y});
  for (const Content& c : tile.contents.contents) {
    const V2i t = wrap(c.translation, tile.size());
    json["contents"].push_back({t.x, t.y, static_cast<int>(c.scale * 65536), c.a, c.b});
  }
  for (const uint32_t idx : partition.idx) json["patch_idx"].push_back(idx);
  for (const OwnerOffset& owner : partition.owner) {
    json["owner_x"].push_back(owner.x);
    json["owner_y"].push_back(owner.y);
  }
  for (const V3f& c : tile.base) json["base"].push_back(color_json(c));
  if (tile.masks.empty()) return json;
  json["noise_side"] = tile.noises[0].width();
  json["noise_step"] = tile.noise_step;
  json["noise_space"] = enum_name(tile.noise_space);
  for (size_t k = 0; k < tile.masks.size(); ++k) {
    for (const float weight : tile.masks[k]) json["masks"][k].push_back(static_cast<int>(weight * 2048));
    for (const V3f& c : tile.noises[k]) json["noises"][k].push_back(color_json(c));
  }
  return json;
}

Json scale_json(const ScaleTile& scale, const ScaleTransfer* transfer) {
  Json json = tile_json(scale.tile);
  json.erase("semantics");
  const Partition& fragments = scale.fragments.partition;
  for (const V2i& c : fragments.centers) json["fragment_centers"].push_back({c.x, c.y});
  for (const Fragment& fragment : scale.fragments.fragments) json["fragment_class"].push_back(fragment.class_idx);
  for (const uint32_t idx : fragments.idx) json["fragment_idx"].push_back(idx);
  for (const OwnerOffset& owner : fragments.owner) {
    json["fragment_owner_x"].push_back(owner.x);
    json["fragment_owner_y"].push_back(owner.y);
  }
  for (const uint8_t k : scale.colors.index) json["class_idx"].push_back(k);
  for (const ColorClass& c : scale.colors.palette.classes) {
    json["palette"].push_back(color_json(c.dominant));
    json["dominants"].push_back(color_json(linear_from_luv(c.dominant)));
  }
  if (scale.tile.soft_border_px > 0) {
    json["soft_border"] = scale.tile.soft_border_px;
    for (const V3f& c : StackPainter::smooth(scale.tile.base, scale.tile.soft_border_px))
      json["soft_mean"].push_back(color_json(c));
  }
  if (!transfer) return json;
  json["transfer"] = {{"ratio", transfer->ratio},
                      {"detail_mean", std::string(enum_name(transfer->detail_mean))},
                      {"weights", transfer->weights},
                      {"coarse_weights", transfer->coarse_weights},
                      {"detail_gains", transfer->detail_gains}};
  return json;
}

Json relief_json(const SmallRelief& relief) {
  Json json = {{"depth", relief.depth_px},
               {"steps", {relief.steps, relief.refinements}},
               {"range", {relief.most(), relief.least(), relief.mean()}},
               {"light", {relief.light_x, relief.light_y, relief.ambient}}};
  for (const float h : relief.height) json["height"].push_back(h);
  for (const V3f& n : relief.normal) json["normal"].push_back(color_json(n));
  return json;
}

/// A point of the finest scale, with its colors near, faded into the coarser scale, and at a level of detail.
Json stack_point_json(const SmallStack& stack, const Point& point, Random& random) {
  const StackPainter painter(stack, point.seed);
  const int finest = painter.finest();
  const float fading = static_cast<float>(random.below(4) + 1) / 4.0f;
  const float variation = static_cast<float>(random.below(5)) / 4.0f;
  const bool is_soft = stack.tiles.back().tile.soft_border_px > 0;  // whose levels are not painted
  const int levels = is_soft ? 0 : std::bit_width(static_cast<uint32_t>(stack.transfers.back().ratio - 1));
  const auto level_256 = static_cast<int>(random.below(static_cast<uint32_t>(256 * levels) + 1));
  Json json = point_json(stack.tiles.back().tile, point);
  json["nearest"] = color_json(painter.texel(finest, point.x_256 >> 8, point.y_256 >> 8, 1));
  json["bilinear"] = color_json(painter.bilinear(finest, point.x_256, point.y_256, 1));
  json["fading"] = fading;
  json["variation"] = variation;
  json["faded"] = color_json(painter.faded(point.x_256, point.y_256, fading, variation));
  json["level_256"] = level_256;
  json["trilinear"] = color_json(painter.trilinear(point.x_256, point.y_256, level_256, variation));
  return json;
}

/// The place that a ray meets, and what it shows there.
void add_relief(Json& json, const SmallStack& stack, const SmallRelief& relief, const Point& point, Random& random) {
  // Slanting enough for all steps to be taken, in quarters.
  const auto part = [&] { return (static_cast<double>(random.below(9)) + 8) / 4 * (random.below(2) == 0 ? 1 : -1); };
  const Imath::V2d way(part(), part());
  const ReliefPainter::Met met = ReliefPainter(stack, relief, point.seed).met(point.x_256, point.y_256, way);
  const StackPainter painter(stack, point.seed);
  const V2i n = stack.tiles.back().tile.size();
  const Json x = place_json(met.x_256, n.x), y = place_json(met.y_256, n.y);
  json["way"] = {way.x, way.y};
  json["met_tile"] = {x[0], y[0]};
  json["met_256"] = {x[1], y[1]};
  json["light_4096"] = met.light_4096;
  json["lit"] = color_json(painter.bilinear(painter.finest(), met.x_256, met.y_256, 1) *
                           (static_cast<float>(met.light_4096) / 4096));
}

/// The texture of several scales is whole from repetition -2^31 to 2^31 - 1 of the finest.
bool is_whole(const Point& point, V2i n) {
  const auto inside = [](int64_t at_256, int side) {
    return std::abs(at_256) < (int64_t{1} << 31) * side * 256 - side * 256;
  };
  return inside(point.x_256, n.x) && inside(point.y_256, n.y);
}

std::string stack_text_of(const SmallStack& stack, const SmallRelief* relief = nullptr) {
  Random random(2026, 7), ways(2027, 8);
  std::string text = "{\n\"semantics\": " + std::to_string(kSemantics) + ",\n\"scales\": [\n";
  auto transfer = stack.transfers.begin();
  for (const ScaleTile& scale : stack.tiles) {
    text += scale_json(scale, &scale == &stack.tiles.front() ? nullptr : &*transfer).dump() +
            (&scale == &stack.tiles.back() ? "\n],\n" : ",\n");
    ++transfer;
  }
  if (relief) text += "\"relief\": " + relief_json(*relief).dump() + ",\n";
  text += "\"points\": [\n";
  std::vector<Point> points = points_of(stack.tiles.back().tile.size());
  std::erase_if(points, [&](const Point& point) { return !is_whole(point, stack.tiles.back().tile.size()); });
  for (const Point& point : points) {
    Json json = stack_point_json(stack, point, random);
    if (relief) add_relief(json, stack, *relief, point, ways);
    text += json.dump() + (&point == &points.back() ? "\n]\n}\n" : ",\n");
  }
  return text;
}

enum class Levels { without, with };

/// Members and points one to a line.
std::string text_of(const SmallTile& tile, Levels levels) {
  Random random(2025, 6);
  std::string text = "{\n";
  const Json members = tile_json(tile);
  for (const auto& [key, value] : members.items()) text += "\"" + key + "\": " + value.dump() + ",\n";
  text += "\"points\": [\n";
  const std::vector<Point> points = points_of(tile.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const Json json = levels == Levels::with ? leveled_json(tile, points[i], random) : point_json(tile, points[i]);
    text += json.dump() + (i + 1 < points.size() ? ",\n" : "\n");
  }
  return text + "]\n}\n";
}

bool write(const std::string& path, const std::string& text) {
  std::ifstream old(path, std::ios::binary);
  const std::string before((std::istreambuf_iterator<char>(old)), std::istreambuf_iterator<char>());
  if (before == text) return true;
  if (!before.empty() && Json::parse(before).at("semantics") == kSemantics) {
    std::fprintf(stderr,
                 "%s: would change within semantics %d. A change of meaning raises the number in semantics.h and "
                 "shaders/README.md; to add points, remove the file first.\n",
                 path.c_str(), kSemantics);
    return false;
  }
  std::ofstream file(path, std::ios::binary);
  return static_cast<bool>(file << text << std::flush);
}

/// Sixteenths, so that rays, light and what lies between texels are exact in float.
SmallRelief random_relief(V2i size, uint64_t seed) {
  Random random(seed, 11);
  SmallRelief relief{Image<float>(size.x, size.y), Image<V3f>(size.x, size.y), 4, 8, 6, -1, -0.5, 0.5};
  const auto sixteenths = [&](int most) {
    return static_cast<float>(random.below(static_cast<uint32_t>(most) + 1)) / 16;
  };
  for (float& h : relief.height) h = sixteenths(16);
  for (V3f& n : relief.normal) n = {sixteenths(16) - 0.5f, sixteenths(16) - 0.5f, sixteenths(8) + 0.5f};
  relief.height(0, 0) = 0;
  relief.height(1, 0) = 1;
  return relief;
}

bool write_stacks(const std::string& folder) {
  SmallStack two, turned, three, relief;
  two.add(random_scale({32, 16}, 3, Contents::turned, 106));
  two.add(random_scale({16, 32}, 3, Contents::moved, 107),
          {.ratio = 5, .weights = {0.5f, 1}, .coarse_weights = {1, 0.25f}});
  turned.add(random_scale({16, 16}, 3, Contents::turned, 108));
  turned.add(random_scale({32, 32}, 4, Contents::turned, 109), {.ratio = 6,
                                                                .detail_mean = DetailMean::local,
                                                                .weights = {0.75f, 0.5f},
                                                                .coarse_weights = {0.5f, 1},
                                                                .detail_gains = {0.5f, 1.5f}});
  three.add(random_scale({16, 16}, 2, Contents::moved, 110));
  three.add(random_scale({16, 16}, 3, Contents::turned, 111), {.ratio = 3, .coarse_weights = {1, 0.5f}});
  three.add(random_scale({16, 32}, 3, Contents::moved, 112),
            {.ratio = 8, .detail_mean = DetailMean::local, .weights = {1, 0.25f}, .detail_gains = {2, 1}});
  relief.add(random_scale({32, 16}, 3, Contents::moved, 113));
  relief.add(random_scale({16, 16}, 3, Contents::turned, 114), {.ratio = 5});
  const SmallRelief heights = random_relief({32, 16}, 115);
  SmallStack soft;
  soft.add(random_scale({16, 16}, 3, Contents::moved, 116));
  soft.add(random_scale({32, 32}, 4, Contents::turned, 117), {.ratio = 4, .weights = {0.5f, 1}});
  for (ScaleTile& scale : soft.tiles) scale.tile.soft_border_px = 2;
  SmallStack noise, soft_noise;
  noise.add(random_scale({16, 16}, 3, Contents::moved, 118));
  noise.add(random_scale({32, 32}, 3, Contents::turned, 119),
            {.ratio = 6, .detail_mean = DetailMean::local, .weights = {0.75f, 0.5f}, .detail_gains = {0.5f, 1.5f}});
  add_noise(noise.tiles.back().tile, 3, 32, 119);
  soft_noise.add(random_scale({16, 16}, 3, Contents::moved, 120));
  soft_noise.add(random_scale({16, 32}, 3, Contents::turned, 121), {.ratio = 4});
  add_noise(soft_noise.tiles.back().tile, 2, 16, 121, NoiseSpace::linear);
  for (ScaleTile& scale : soft_noise.tiles) scale.tile.soft_border_px = 2;
  const auto done = [&](const char* name, const std::string& text) { return write(folder + "/" + name, text); };
  bool all = done("stack.json", stack_text_of(two));
  all = done("stack_turned.json", stack_text_of(turned)) && all;
  all = done("stack_three.json", stack_text_of(three)) && all;
  all = done("stack_soft.json", stack_text_of(soft)) && all;
  all = done("stack_noise.json", stack_text_of(noise)) && all;
  all = done("stack_noise_soft.json", stack_text_of(soft_noise)) && all;
  return done("stack_relief.json", stack_text_of(relief, &heights)) && all;
}

/// All files; false where one was not written.
bool write_all(const std::string& folder) {
  const auto done = [&](const char* name, const SmallTile& tile, Levels levels) {
    return write(folder + "/" + name + ".json", text_of(tile, levels));
  };
  bool all = done("plain", random_tile({16, 16}, 1, Contents::moved, 101), Levels::without);
  all = done("moved", random_tile({32, 24}, 5, Contents::moved, 102), Levels::without) && all;
  all = done("turned", random_tile({24, 32}, 4, Contents::turned, 103), Levels::without) && all;
  SmallTile noise = random_tile({24, 20}, 4, Contents::turned, 104);
  add_noise(noise, 3, 16, 104);
  all = done("noise", noise, Levels::without) && all;
  noise.noise_space = NoiseSpace::linear;
  all = done("noise_linear", noise, Levels::without) && all;
  all = done("levels", random_tile({16, 32}, 3, Contents::turned, 104), Levels::with) && all;
  SmallTile noise_levels = random_tile({16, 32}, 3, Contents::turned, 105);
  add_noise(noise_levels, 2, 32, 105);
  all = done("noise_levels", noise_levels, Levels::with) && all;
  return write_stacks(folder) && all;
}

}  // namespace
}  // namespace texbake

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  return texbake::write_all(argv[1]) ? 0 : 1;
}
