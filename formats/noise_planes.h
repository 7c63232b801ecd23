// The planes of the noises: spectra and histograms in one file, tiles of values in another.
#pragma once

#include "formats/planes.h"
#include "libbake/noise/estimate_psd.h"

namespace texbake {

inline constexpr const char* kSpectraName = "spectra";  ///< stems of the two files
inline constexpr const char* kTilesName = "noise";
inline constexpr const char* kSpectrumKey = "spectrum.";  ///< before the number of a noise: key and part
inline constexpr const char* kTileKey = "tile.";
inline constexpr const char* kHistogramKey = "histogram";

/// spectrum.0 … and histogram, in the order of the file.
std::vector<ScalePlane> spectrum_planes(const NoiseModel& noise);
std::vector<ScalePlane> spectrum_planes(NoiseModel& noise);
/// tile.0 …
std::vector<ScalePlane> tile_planes(const NoiseModel& noise);
std::vector<ScalePlane> tile_planes(NoiseModel& noise);

/// The displayWindow of each file: the largest spectrum, the tile.
V2i spectra_size(const NoiseModel& noise);
V2i tiles_size(const NoiseModel& noise);

}  // namespace texbake
