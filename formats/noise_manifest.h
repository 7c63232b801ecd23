// The member `noise` of the manifest, written and read back.
#pragma once

#include "formats/plane_refs.h"

namespace texbake {

/// The planes of the noises, in their two files; empty without noise.
struct NoiseRefs {
  PlaneRefs spectra;
  PlaneRefs tiles;
};

/// The planes of the spectra and of the tiles, hashed and with the names of their files.
NoiseRefs noise_refs(const NoiseModel& noise);

Json noise_json(const NoiseModel& noise, const NoiseRefs& refs);

/// Reads the member `noise`, whose shape the schema has vouched for; `mask_count` is that of the finest scale. Images
/// and histograms wait for their planes. The refs are empty after an error.
void read_noise(const Json& json, size_t mask_count, NoiseModel& model, NoiseRefs& refs, IssueLog& log);

}  // namespace texbake
