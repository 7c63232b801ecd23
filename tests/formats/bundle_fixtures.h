// A small bundle with everything in it, and the tools to spoil it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "formats/bundle_io.h"
#include "formats/history.h"
#include "formats/json_text.h"
#include "formats/planes.h"
#include "libbake/base/half.h"
#include "libbake/base/random.h"

namespace texbake {

/// A folder of its own, removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int count = 0;
    const bool has_memory = std::filesystem::is_directory("/dev/shm");  // thousands of synchronized files, at once
    path_ = std::filesystem::path(has_memory ? "/dev/shm" : testing::TempDir()) /
            ("texbake-bundle-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string file_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Names and bytes of all files in a folder.
inline std::map<std::string, std::string> folder_contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files[entry.path().filename().string()] = entry.is_directory() ? "folder" : file_text(entry.path());
  return files;
}

/// Squares of `side` texels, moved by (3, 5) so that some lie across the borders of the tile.
inline Partition squares(int size, int side) {
  Image<uint32_t> idx(size, size);
  const int across = size / side;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      idx(x, y) = static_cast<uint32_t>(wrap(y + 5, size) / side * across + wrap(x + 3, size) / side);
  return unwrap(std::move(idx));
}

inline PrincipalVariation three_classes(int size, Random& random) {
  PrincipalVariation colors;
  colors.palette.classes = {
      {{20, 5, -3}, {0.6f, 0.0f, 0.8f}}, {{50, 10, 12.5f}, {1, 0, 0}}, {{80, 0.1f, 0}, {0, 0.8f, -0.6f}}};
  colors.index = Image<uint8_t>(size, size);
  colors.variation = Image<float>(size, size);
  for (uint8_t& k : colors.index) k = static_cast<uint8_t>(random.below(3));
  for (float& v : colors.variation) v = half_exact(random.uniform() * 10 - 5);
  return colors;
}

inline FragmentMap square_fragments(const Image<V3f>& base, Random& random) {
  FragmentMap map{squares(base.width(), base.width() / 8), {}};
  std::vector<Imath::V3d> sums(map.partition.centers.size(), Imath::V3d(0));
  for (size_t i = 0; i < base.size(); ++i) sums[map.partition.idx.data()[i]] += Imath::V3d(base.data()[i]);
  for (size_t i = 0; i < sums.size(); ++i)
    map.fragments.push_back({random.below(3), V3f(sums[i] / double{1.0 * map.partition.areas_px[i]})});
  return map;
}

inline ContentTable some_contents(int patches, int size, Random& random) {
  ContentTable table{patches, 3, {}};
  for (int i = 0; i < patches * 3; ++i) {
    Content content;
    if (i % 3 != 0) {
      content.translation =
          shortest({static_cast<int>(random.below(static_cast<uint32_t>(size))), i % 7}, {size, size});
      content.impact = random.uniform() * 1000;
    }
    table.contents.push_back(content);
  }
  return table;
}

inline Map map_of(const std::string& name, int channels, int bits, int size, Random& random) {
  Map map;
  map.name = name;
  map.channels = channels;
  map.source_bits = bits;
  if (name == "normal") map.convention = "opengl";
  for (int c = 0; c < channels; ++c) {
    map.planes[c] = Image<float>(size, size);
    for (float& value : map.planes[c]) value = bits <= 8 ? half_exact(random.uniform()) : random.uniform();
  }
  return map;
}

/// Two masks: halves of the tile, with a blend between.
inline std::vector<Image<float>> two_masks(int size) {
  std::vector<Image<float>> masks;
  masks.emplace_back(size, size, 0.25f);
  masks.emplace_back(size, size, 0.75f);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size - 3; ++x) {
      masks[0](x, y) = x < size / 2 ? 1.0f : 0.0f;
      masks[1](x, y) = 1.0f - masks[0](x, y);
    }
  return masks;
}

/// A structure from which the exemplar differs by `strength` at most.
inline Image<V3f> structure_near(const Image<V3f>& exemplar, float strength, Random& random) {
  Image<V3f> structure = exemplar.clone();
  for (V3f& color : structure) color = half_exact(color * (1.0f - strength * random.uniform()));
  return structure;
}

/// Two noises whose spectra have the power of exemplar − structure, equal in all channels, and tiles of that variance.
inline NoiseModel two_noises(const Image<V3f>& exemplar, const Image<V3f>& structure, Random& random) {
  double power = 0;
  for (size_t i = 0; i < exemplar.size(); ++i)
    power += static_cast<double>((exemplar.data()[i] - structure.data()[i]).length2()) / 2;  // less the mean
  power /= static_cast<double>(exemplar.size());
  const auto deviation = static_cast<float>(std::sqrt(power / 3));
  NoiseModel model;
  model.space = NoiseSpace::linear;
  model.lattice = {512 * 512, 12345};
  for (const int size : {8, 16}) {
    Noise& noise = model.noises.emplace_back();
    noise.basis.axis = {V3f(0.6f, 0.8f, 0), V3f(-0.8f, 0.6f, 0), V3f(0, 0, 1)};
    for (NoiseChannel& channel : noise.channels) {
      channel.spectrum = Image<float>(size, size);
      channel.spectrum(1, 2) = channel.spectrum(size - 1, size - 2) = deviation / std::sqrt(2.0f);
      for (int i = 0; i < Equalization::kEntries; ++i) channel.equalization.values.push_back(random.uniform());
      channel.lobes = {{{.power = 0.5, .center_x_cpp = 0.25, .center_y_cpp = -0.125, .l_xx = 3}}, 0.125};
    }
    noise.tile = Image<V3f>(512, 512);  // a chessboard, which is quickly written
    for (int y = 0; y < 512; ++y)
      for (int x = 0; x < 512; ++x)
        noise.tile(x, y) = half_exact(V3f((x / size + y / size) % 2 == 0 ? deviation : -deviation));
  }
  return model;
}

inline Scale scale_with_everything(int size = 64, const std::string& name = "fine") {
  Random random(static_cast<uint64_t>(size));
  Scale scale;
  scale.name = name;
  scale.exemplar = Image<V3f>(size, size);
  for (V3f& color : scale.exemplar) color = half_exact(V3f(random.uniform(), random.uniform(), random.uniform() * 2));
  scale.structure = structure_near(scale.exemplar, 0.5f, random);
  scale.masks = two_masks(size);
  scale.colors = three_classes(size, random);
  scale.fragments = square_fragments(*scale.structure, random);
  scale.patches = PatchMap{squares(size, size / 4)};
  scale.contents = some_contents(16, size, random);
  scale.height = Image<float>(size, size);
  for (float& height : *scale.height) height = random.uniform();
  scale.maps.push_back(map_of("normal", 3, 8, size, random));
  scale.maps.push_back(map_of("roughness", 1, 16, size, random));
  scale.tile_from_source = V2i(12, -7);
  return scale;
}

/// A bundle that verify finds nothing wrong with. `mark` changes one texel: a bundle of other content.
inline Bundle bundle_with_everything(float mark = 0.5f, int size = 64) {
  Bundle bundle;
  bundle.scales.push_back(scale_with_everything(size));
  bundle.scales[0].height->operator()(0, 0) = mark;
  Random random(7);
  bundle.noise = two_noises(bundle.scales[0].exemplar, *bundle.scales[0].structure, random);
  bundle.sources = {{"color", "rock.jpg", std::string(64, 'a'), 12345}};
  bundle.extras["note"] = "for tests";
  const auto record = [&](const char* verb, Json figures) {
    record_stage(bundle, {.verb = verb, .parameters = {{"seed", 1}, {"min-area", 8.5}}, .figures = std::move(figures)});
  };
  record("convert", {{"meanDeltaE", 1.25}});
  record("decompose", {{"noiseShare", 0.5}});
  record("estimate-psd", Json::object());
  record("fragment", {{"count", 64}});
  record("patch", {{"count", 16}, {"minArea", size * size / 16}});
  record("select-contents", {{"worstImpact", 1000.0}});
  return bundle;
}

inline void expect_equal(const Partition& a, const Partition& b) {
  EXPECT_TRUE(a.idx == b.idx);
  EXPECT_TRUE(a.owner == b.owner);
  EXPECT_TRUE(a.centers == b.centers);
  EXPECT_EQ(a.areas_px, b.areas_px);
}

inline void expect_equal(const PrincipalVariation& a, const PrincipalVariation& b) {
  EXPECT_TRUE(a.index == b.index);
  EXPECT_TRUE(a.variation == b.variation);
  ASSERT_EQ(a.palette.classes.size(), b.palette.classes.size());
  for (size_t k = 0; k < a.palette.classes.size(); ++k) {
    EXPECT_EQ(a.palette.classes[k].dominant, b.palette.classes[k].dominant);
    EXPECT_EQ(a.palette.classes[k].variation, b.palette.classes[k].variation);
  }
}

inline void expect_equal(const FragmentMap& a, const FragmentMap& b) {
  expect_equal(a.partition, b.partition);
  ASSERT_EQ(a.fragments.size(), b.fragments.size());
  for (size_t i = 0; i < a.fragments.size(); ++i) {
    EXPECT_EQ(a.fragments[i].class_idx, b.fragments[i].class_idx);
    EXPECT_EQ(a.fragments[i].mean_color, b.fragments[i].mean_color);
  }
}

inline void expect_equal(const Scale& a, const Scale& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_TRUE(a.exemplar == b.exemplar);
  EXPECT_EQ(a.stores_exemplar, b.stores_exemplar);
  EXPECT_TRUE(a.structure == b.structure);
  EXPECT_TRUE(a.masks == b.masks);
  EXPECT_TRUE(a.height == b.height);
  EXPECT_EQ(a.tile_from_source, b.tile_from_source);
  EXPECT_TRUE(a.transfer == b.transfer);
  ASSERT_EQ(a.colors.has_value(), b.colors.has_value());
  ASSERT_EQ(a.fragments.has_value(), b.fragments.has_value());
  ASSERT_EQ(a.patches.has_value(), b.patches.has_value());
  ASSERT_EQ(a.contents.has_value(), b.contents.has_value());
  if (a.colors) expect_equal(*a.colors, *b.colors);
  if (a.fragments) expect_equal(*a.fragments, *b.fragments);
  if (a.patches) expect_equal(a.patches->partition, b.patches->partition);
  if (a.contents) {
    EXPECT_EQ(a.contents->patch_count, b.contents->patch_count);
    EXPECT_EQ(a.contents->content_count, b.contents->content_count);
    EXPECT_EQ(a.contents->contents, b.contents->contents);
  }
  ASSERT_EQ(a.maps.size(), b.maps.size());
  for (size_t i = 0; i < a.maps.size(); ++i) {
    EXPECT_EQ(a.maps[i].name, b.maps[i].name);
    EXPECT_EQ(a.maps[i].source_bits, b.maps[i].source_bits);
    EXPECT_EQ(a.maps[i].is_float, b.maps[i].is_float);
    EXPECT_EQ(a.maps[i].convention, b.maps[i].convention);
    ASSERT_EQ(a.maps[i].channels, b.maps[i].channels);
    for (int c = 0; c < a.maps[i].channels; ++c) EXPECT_TRUE(a.maps[i].planes[c] == b.maps[i].planes[c]);
  }
}

inline void expect_equal(const NoiseChannel& a, const NoiseChannel& b) {
  EXPECT_TRUE(a.spectrum == b.spectrum);
  EXPECT_EQ(a.equalization.values, b.equalization.values);
  EXPECT_EQ(a.lobes.error, b.lobes.error);
  ASSERT_EQ(a.lobes.lobes.size(), b.lobes.lobes.size());
  for (size_t i = 0; i < a.lobes.lobes.size(); ++i) {
    const Lobe &one = a.lobes.lobes[i], &other = b.lobes.lobes[i];
    EXPECT_EQ(one.power, other.power);
    EXPECT_EQ(one.center_x_cpp, other.center_x_cpp);
    EXPECT_EQ(one.center_y_cpp, other.center_y_cpp);
    EXPECT_EQ(one.l_xx, other.l_xx);
    EXPECT_EQ(one.l_xy, other.l_xy);
    EXPECT_EQ(one.l_yy, other.l_yy);
  }
}

inline void expect_equal(const NoiseModel& a, const NoiseModel& b) {
  ASSERT_EQ(a.noises.size(), b.noises.size());
  EXPECT_EQ(a.lattice.count, b.lattice.count);
  EXPECT_EQ(a.lattice.row_step, b.lattice.row_step);
  EXPECT_EQ(a.space, b.space);
  for (size_t k = 0; k < a.noises.size(); ++k) {
    EXPECT_EQ(a.noises[k].basis.mean, b.noises[k].basis.mean);
    EXPECT_EQ(a.noises[k].basis.axis, b.noises[k].basis.axis);
    EXPECT_TRUE(a.noises[k].tile == b.noises[k].tile);
    for (size_t c = 0; c < 3; ++c) expect_equal(a.noises[k].channels[c], b.noises[k].channels[c]);
  }
}

inline void expect_equal(const Bundle& a, const Bundle& b) {
  ASSERT_EQ(a.noise.has_value(), b.noise.has_value());
  if (a.noise) expect_equal(*a.noise, *b.noise);
  ASSERT_EQ(a.scales.size(), b.scales.size());
  for (size_t i = 0; i < a.scales.size(); ++i) expect_equal(a.scales[i], b.scales[i]);
  ASSERT_EQ(a.sources.size(), b.sources.size());
  for (size_t i = 0; i < a.sources.size(); ++i) {
    EXPECT_EQ(a.sources[i].role, b.sources[i].role);
    EXPECT_EQ(a.sources[i].name, b.sources[i].name);
    EXPECT_EQ(a.sources[i].sha256, b.sources[i].sha256);
    EXPECT_EQ(a.sources[i].size_bytes, b.sources[i].size_bytes);
    EXPECT_EQ(a.sources[i].scale, b.sources[i].scale);
  }
  ASSERT_EQ(a.stages.size(), b.stages.size());
  for (size_t i = 0; i < a.stages.size(); ++i) {
    EXPECT_EQ(a.stages[i].verb, b.stages[i].verb);
    EXPECT_EQ(a.stages[i].version, b.stages[i].version);
    EXPECT_EQ(a.stages[i].parameters, b.stages[i].parameters);
    EXPECT_EQ(a.stages[i].figures, b.stages[i].figures);
    EXPECT_EQ(a.stages[i].input, b.stages[i].input);
    EXPECT_EQ(a.stages[i].output, b.stages[i].output);
    EXPECT_EQ(a.stages[i].scale, b.stages[i].scale);
  }
  EXPECT_EQ(a.extensions, b.extensions);
  EXPECT_EQ(a.extras, b.extras);
  EXPECT_EQ(a.unknown, b.unknown);
}

/// The payload whose name begins with `stem`.
inline std::filesystem::path payload_of(const std::filesystem::path& bundle, const std::string& stem = "fine-") {
  for (const auto& entry : std::filesystem::directory_iterator(bundle))
    if (entry.path().extension() == ".exr" && entry.path().filename().string().starts_with(stem)) return entry.path();
  return {};
}

}  // namespace texbake
