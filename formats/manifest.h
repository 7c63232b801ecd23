// bundle.json: the manifest of a bundle, written from and read into the bundle in memory. Pixels stay in the payloads.
#pragma once

#include <string>
#include <vector>

#include "formats/asset.h"
#include "formats/bundle.h"
#include "formats/issues.h"
#include "formats/noise_manifest.h"
#include "formats/plane_refs.h"

namespace texbake {

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

/// Checks versions, then the schema, then what the schema cannot say. A scale with errors has no refs. What the bundle
/// keeps as it is, extras and the like, is taken out of `json`.
Manifest parse_manifest(Json& json, Semantics semantics, IssueLog& log);

}  // namespace texbake
