// bundle.json: the manifest of a bundle, written from and read into the bundle in memory. Pixels stay in the payloads.
#pragma once

#include <string>
#include <vector>

#include "formats/asset.h"
#include "formats/bundle.h"
#include "formats/exr_planes.h"
#include "formats/issues.h"

namespace texbake {

inline constexpr const char* kManifestName = "bundle.json";

/// Where a plane lies and what it must hold.
struct PlaneRef {
  std::string key;  ///< as ScalePlane::key
  std::string file;
  PlaneShape shape;
  std::string pixel_hash;
};

/// The planes of one scale.
using PlaneRefs = std::vector<PlaneRef>;

/// The planes of the noises, in their two files; empty without noise.
struct NoiseRefs {
  PlaneRefs spectra;
  PlaneRefs tiles;
};

/// The hash that names the payload file of `refs`: SHA-256 of one line for each part, in the order of the file,
///   PART WIDTH HEIGHT TYPE CHANNEL,CHANNEL,... PIXELHASH\n
std::string content_hash(const PlaneRefs& refs);
/// NAME-<12 digits of the content hash>.exr
std::string payload_name(const std::string& scale_name, const PlaneRefs& refs);

/// Where all planes of a bundle lie.
struct BundleRefs {
  std::vector<PlaneRefs> scales;
  NoiseRefs noise;
};
/// Hashes every plane and names the files.
BundleRefs plane_refs(const Bundle& bundle);

/// The members `scales` and `noise` (null without noise).
struct StateJson {
  Json scales;
  Json noise;
};
StateJson state_json(const Bundle& bundle, const BundleRefs& refs);

Json manifest_json(const Bundle& bundle, const StateJson& state);

/// A manifest read back: the bundle without pixels, and where they are.
struct Manifest {
  Bundle bundle;
  std::vector<V2i> sizes;               ///< of each scale
  std::vector<size_t> fragment_counts;  ///< of each scale; the tables wait for their planes
  std::vector<PlaneRefs> refs;          ///< of each scale
  NoiseRefs noise_refs;
};

/// Checks versions, then the schema, then what the schema cannot say. A scale with errors has no refs.
Manifest parse_manifest(const Json& json, Semantics semantics, IssueLog& log);

}  // namespace texbake
