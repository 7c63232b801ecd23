#include "formats/noise_planes.h"

#include <algorithm>

namespace texbake {
namespace {

ScalePlane rgb_plane(const std::string& key, PixelType type, V2i size, ChannelRange range) {
  ScalePlane plane;
  plane.key = key;
  plane.ranges.assign(3, range);
  plane.shape = {key, {"R", "G", "B"}, type, size.x, size.y};
  return plane;
}

template <class NoiseT>
ScalePlane spectrum_plane(size_t k, NoiseT& noise) {
  const int size = noise.spectrum_size();
  ScalePlane plane = rgb_plane(kSpectrumKey + std::to_string(k), PixelType::float32, {size, size},
                               {0, kAnyFloat, IssueId::spectrum_range});
  plane.get_floats = [&noise](int c, int y, float* row) {
    const auto& spectrum = noise.channels[static_cast<size_t>(c)].spectrum;
    std::copy_n(spectrum.row(y), spectrum.width(), row);
  };
  if constexpr (writable<NoiseT>)
    plane.put_floats = [&noise](int c, int y, const float* row) {
      auto& spectrum = noise.channels[static_cast<size_t>(c)].spectrum;
      std::copy_n(row, spectrum.width(), spectrum.row(y));
    };
  return plane;
}

/// One row for each channel of each noise.
template <class ModelT>
ScalePlane histogram_plane(ModelT& model) {
  ScalePlane plane;
  plane.key = kHistogramKey;
  plane.ranges = {{-kAnyFloat, kAnyFloat, IssueId::not_finite}};
  plane.shape = {
      kHistogramKey, {"Y"}, PixelType::float32, Equalization::kEntries, static_cast<int>(3 * model.noises.size())};
  const auto values_of = [](auto& noises, int y) -> auto& {
    return noises[static_cast<size_t>(y / 3)].channels[static_cast<size_t>(y % 3)].equalization.values;
  };
  plane.get_floats = [&model, values_of](int, int y, float* row) {
    std::copy_n(values_of(model.noises, y).data(), Equalization::kEntries, row);
  };
  if constexpr (writable<ModelT>)
    plane.put_floats = [&model, values_of](int, int y, const float* row) {
      values_of(model.noises, y).assign(row, row + Equalization::kEntries);
    };
  return plane;
}

template <class NoiseT>
ScalePlane tile_plane(size_t k, NoiseT& noise) {
  auto& tile = noise.tile;
  ScalePlane plane = rgb_plane(kTileKey + std::to_string(k), PixelType::half, {tile.width(), tile.height()},
                               {-kAnyFloat, kAnyFloat, IssueId::not_finite});
  plane.get_floats = [&tile](int c, int y, float* row) {
    for (int x = 0; x < tile.width(); ++x) row[x] = tile.row(y)[x][c];
  };
  if constexpr (writable<NoiseT>)
    plane.put_floats = [&tile](int c, int y, const float* row) {
      for (int x = 0; x < tile.width(); ++x) tile.row(y)[x][c] = row[x];
    };
  return plane;
}

template <class ModelT>
std::vector<ScalePlane> list_spectra(ModelT& model) {
  std::vector<ScalePlane> planes;
  for (size_t k = 0; k < model.noises.size(); ++k) planes.push_back(spectrum_plane(k, model.noises[k]));
  planes.push_back(histogram_plane(model));
  return planes;
}

template <class ModelT>
std::vector<ScalePlane> list_tiles(ModelT& model) {
  std::vector<ScalePlane> planes;
  for (size_t k = 0; k < model.noises.size(); ++k) planes.push_back(tile_plane(k, model.noises[k]));
  return planes;
}

}  // namespace

std::vector<ScalePlane> spectrum_planes(const NoiseModel& noise) { return list_spectra(noise); }
std::vector<ScalePlane> spectrum_planes(NoiseModel& noise) { return list_spectra(noise); }
std::vector<ScalePlane> tile_planes(const NoiseModel& noise) { return list_tiles(noise); }
std::vector<ScalePlane> tile_planes(NoiseModel& noise) { return list_tiles(noise); }

V2i spectra_size(const NoiseModel& noise) {
  int side = 1;
  for (const Noise& one : noise.noises) side = std::max(side, one.spectrum_size());
  return {side, side};
}

V2i tiles_size(const NoiseModel& noise) {
  const Image<V3f>& tile = noise.noises.front().tile;
  return {tile.width(), tile.height()};
}

}  // namespace texbake
