// The tiny bundles of tests/golden/bundles: random tiles that have, together, everything that is drawn.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "formats/bundle.h"
#include "libbake/base/half.h"
#include "libbake/base/random.h"
#include "tests/libbake/draw/small_tile.h"

namespace texbake {

/// Cells of `cell` texels, moved so that some lie across the borders of the tile.
inline Partition cells(V2i size, V2i cell) {
  Image<uint32_t> idx(size.x, size.y);
  const int across = size.x / cell.x;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      idx(x, y) = static_cast<uint32_t>(wrap(y + cell.y - 2, size.y) / cell.y * across + wrap(x + 2, size.x) / cell.x);
  return unwrap(std::move(idx));
}

/// One of the noises that are drawn: it returns after `period` values, so that its file is small.
inline Noise golden_noise(Random& random, float strength, int period) {
  constexpr int kSide = 512;
  Noise noise;
  noise.basis.axis = {V3f(0.6f, 0.8f, 0), V3f(-0.8f, 0.6f, 0), V3f(0, 0, 1)};
  for (NoiseChannel& channel : noise.channels) {
    channel.spectrum = Image<float>(4, 4);
    channel.spectrum(1, 0) = channel.spectrum(3, 0) = strength * 0.25f;
    channel.equalization.values.assign(Equalization::kEntries, 0.0f);
  }
  std::vector<V3f> values(static_cast<size_t>(period));
  for (V3f& value : values)
    value = half_exact((V3f(random.uniform(), random.uniform(), random.uniform()) - V3f(0.5f)) * strength);
  noise.tile = Image<V3f>(kSide, kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) noise.tile(x, y) = values[static_cast<size_t>(x % period)];
  return noise;
}

inline void add_golden_noise(Bundle& bundle, NoiseSpace space, uint64_t seed) {
  Random random(seed, 21);
  Scale& scale = bundle.scales.back();
  scale.structure = scale.exemplar.clone();
  scale.masks = random_masks(scale.size(), 2, seed);
  NoiseModel model;
  model.space = space;
  model.lattice = {512 * 512, 163841};
  for (const int period : {8, 1}) model.noises.push_back(golden_noise(random, 0.5f, period));
  bundle.noise = std::move(model);
}

inline PrincipalVariation golden_colors(V2i size, uint64_t seed) {
  Random random(seed, 9);
  PrincipalVariation colors;
  colors.palette.classes = {{{20, 5, -3}, {0.6f, 0, 0.8f}}, {{70, 10, 12.5f}, {1, 0, 0}}};
  colors.index = Image<uint8_t>(size.x, size.y);
  colors.variation = Image<float>(size.x, size.y);
  for (uint8_t& k : colors.index) k = static_cast<uint8_t>(random.below(2));
  for (float& v : colors.variation) v = half_exact(static_cast<float>(random.below(4)) * 7.7f - 12.3f);
  return colors;
}

/// The fragments of `partition`, with their mean colors.
inline FragmentMap golden_fragments(Partition partition, const Image<V3f>& base) {
  FragmentMap map{std::move(partition), {}};
  std::vector<Imath::V3d> sums(map.partition.centers.size(), Imath::V3d(0));
  for (size_t i = 0; i < base.size(); ++i) sums[map.partition.idx.data()[i]] += Imath::V3d(base.data()[i]);
  for (size_t i = 0; i < sums.size(); ++i)
    map.fragments.push_back({static_cast<uint32_t>(i % 2), V3f(sums[i] / double{1.0 * map.partition.areas_px[i]})});
  return map;
}

inline Map golden_map(const std::string& name, const std::string& convention, V2i size, uint64_t seed) {
  Random random(seed, 31);
  Map map;
  map.name = name;
  map.convention = convention;
  map.channels = convention.empty() ? 1 : 3;
  for (int c = 0; c < map.channels; ++c) {
    map.planes[c] = Image<float>(size.x, size.y);
    for (float& value : map.planes[c])
      value = half_exact(name == "normal" && c < 2 ? random.uniform() * 2 - 1 : random.uniform());
  }
  return map;
}

/// A scale with `count` contents for each patch. Patches are of any shape where `cell` is 0, else of 2 × 2 cells.
inline Scale golden_scale(V2i size, int count, Contents kind, uint64_t seed, V2i cell = V2i(0)) {
  Scale scale;
  const Image<V3f> drawn = random_base({4, 4}, seed);  // few colors, so that the file is small
  Random random(seed, 51);
  scale.exemplar = Image<V3f>(size.x, size.y);
  for (V3f& color : scale.exemplar) color = half_exact(drawn.data()[random.below(16)] * 0.25f);
  scale.colors = golden_colors(size, seed);
  scale.patches = cell.x == 0 ? random_patches(size, seed) : PatchMap{cells(size, cell * 2)};
  scale.fragments = golden_fragments(
      cell.x == 0 ? unwrap(Image<uint32_t>(scale.patches->partition.idx.clone())) : cells(size, cell), scale.exemplar);
  scale.contents = random_contents(*scale.patches, size, count, kind, seed);
  for (Content& content : scale.contents->contents) content.translation = shortest(content.translation, size);
  return scale;
}

inline Image<float> golden_height(V2i size, uint64_t seed) {
  Random random(seed, 41);
  Image<float> height(size.x, size.y);
  for (float& h : height) h = static_cast<float>(random.below(257)) / 256;
  height(0, 0) = 0;
  height(1, 0) = 1;
  return height;
}

inline Bundle one_scale(Scale scale) {
  Bundle bundle;
  bundle.scales.push_back(std::move(scale));
  return bundle;
}

/// Coarse to fine; names follow from the number.
inline Bundle golden_stack(std::vector<Scale> scales, const std::vector<ScaleTransfer>& transfers) {
  const char* const kNames[] = {"coarse", "middle", "fine"};
  Bundle bundle;
  for (size_t s = 0; s < scales.size(); ++s) {
    scales[s].name = kNames[s + 3 - scales.size()];
    if (s > 0) scales[s].transfer = transfers[s - 1];
    bundle.scales.push_back(std::move(scales[s]));
  }
  return bundle;
}

/// With their names.
inline std::vector<std::pair<std::string, Bundle>> golden_bundles() {
  std::vector<std::pair<std::string, Bundle>> all;
  const auto add = [&](const char* name, Bundle bundle) -> Bundle& {
    return all.emplace_back(name, std::move(bundle)).second;
  };
  add("hard", one_scale(golden_scale({32, 24}, 5, Contents::moved, 201)));
  add("soft", one_scale(golden_scale({32, 32}, 4, Contents::turned, 202))).scales[0].soft_border_px = 4;
  add("turned", one_scale(golden_scale({24, 32}, 4, Contents::turned, 203)));
  Scale& maps = add("maps", one_scale(golden_scale({24, 16}, 3, Contents::turned, 204))).scales[0];
  maps.maps.push_back(golden_map("normal", "opengl", {24, 16}, 1));
  maps.maps.push_back(golden_map("bent", "directx", {24, 16}, 2));
  maps.maps.push_back(golden_map("rough", "", {24, 16}, 3));
  maps.height = golden_height({24, 16}, 204);
  add_golden_noise(add("noise_root", one_scale(golden_scale({24, 16}, 2, Contents::turned, 205))), NoiseSpace::root,
                   205);
  add_golden_noise(add("noise_linear", one_scale(golden_scale({16, 24}, 2, Contents::turned, 206))), NoiseSpace::linear,
                   206);
  Bundle& noise_soft = add("noise_soft", one_scale(golden_scale({24, 24}, 2, Contents::turned, 207)));
  noise_soft.scales[0].soft_border_px = 3;
  add_golden_noise(noise_soft, NoiseSpace::root, 207);
  add("odd", one_scale(golden_scale({30, 21}, 4, Contents::turned, 208)));
  Scale& palette = add("palette", one_scale(golden_scale({32, 24}, 3, Contents::moved, 209))).scales[0];
  palette.stores_exemplar = false;
  palette.exemplar = palette_exemplar(*palette.colors);
  palette.fragments = golden_fragments(std::move(palette.fragments->partition), palette.exemplar);
  const auto scale = [](V2i size, Contents kind, uint64_t seed) { return golden_scale(size, 2, kind, seed, {4, 4}); };
  std::vector<Scale> two, three, rock;
  two.push_back(scale({32, 32}, Contents::turned, 210));
  two.push_back(scale({32, 32}, Contents::turned, 211));
  add("two", golden_stack(std::move(two), {{.ratio = 5,
                                            .detail_mean = DetailMean::local,
                                            .weights = {0.5f, 1},
                                            .coarse_weights = {1, 0.25f},
                                            .detail_gains = {0.5f, 1.5f}}}));
  three.push_back(scale({24, 24}, Contents::moved, 212));
  three.push_back(scale({24, 24}, Contents::turned, 213));
  three.push_back(scale({24, 24}, Contents::moved, 214));
  add("three", golden_stack(std::move(three),
                            {{.ratio = 3, .mode = TransferMode::texel}, {.ratio = 4, .mode = TransferMode::bilinear}}));
  rock.push_back(scale({24, 24}, Contents::turned, 215));
  rock.push_back(scale({24, 24}, Contents::turned, 216));
  rock[0].height = golden_height({24, 24}, 215);
  rock[0].soft_border_px = 2;
  rock[1].soft_border_px = 2;
  Bundle& stack = add("rock", golden_stack(std::move(rock), {{.ratio = 6}}));
  add_golden_noise(stack, NoiseSpace::root, 216);
  return all;
}

}  // namespace texbake
