// The member `noise` of the manifest, written and read back.
#pragma once

#include "formats/manifest.h"

namespace texbake {

/// The planes of the spectra and of the tiles, hashed and with the names of their files.
NoiseRefs noise_refs(const NoiseModel& noise);

Json noise_json(const NoiseModel& noise, const NoiseRefs& refs);

/// Reads the member `noise`, whose shape the schema has vouched for; `mask_count` is that of the finest scale. Images
/// and histograms wait for their planes. The refs are empty after an error.
void read_noise(const Json& json, size_t mask_count, Manifest& manifest, IssueLog& log);

}  // namespace texbake
