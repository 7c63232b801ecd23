// Bundles on the disk. formats/README.md specifies the format.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "formats/bundle.h"
#include "formats/issues.h"
#include "formats/manifest.h"
#include "formats/safe_file.h"

namespace texbake {

/// A bundle as far as it can be read: what verify starts from.
struct LoadedBundle {
  Json manifest;
  std::vector<PlaneRefs> refs;
  std::vector<V2i> sizes;
  Bundle bundle;
  std::vector<std::set<std::string>> planes;  ///< for each scale, the keys of the planes that were read
  NoiseRefs noise_refs;
  std::set<std::string> noise_planes;  ///< the same for the noises
  bool is_whole(size_t scale) const { return !refs[scale].empty() && planes[scale].size() == refs[scale].size(); }
  bool has_whole_noise() const {
    return !noise_refs.spectra.empty() && noise_planes.size() == noise_refs.spectra.size() + noise_refs.tiles.size();
  }
};

/// Which planes are kept in memory; all are read, hashed and checked.
enum class KeptPlanes {
  all,
  judged,  ///< those that checks compare with each other: neither maps nor height
};

struct ReadOptions {
  Semantics semantics = Semantics::known;
  KeptPlanes kept = KeptPlanes::all;
  /// Called when scale `i` has been read, and may free what nobody asks for later: a bundle may be larger than memory.
  std::function<void(LoadedBundle& loaded, size_t i)> scale_read = {};
};

/// Reads and checks a bundle: versions, schema, hashes of all planes, ranges, counts. Throws Error of the first issue
/// (bad_data, unsupported, io). What costs more (connectivity, means, ...) is verify_bundle's.
Bundle read_bundle(const std::filesystem::path& path, const ReadOptions& options = {});

struct WriteOptions {
  StepHook hook;  ///< for tests: called before each step on the disk
};

/// Writes a bundle at any state of the chain. A new bundle appears as a whole; an existing one is replaced so that a
/// reader sees the old or the new one at any moment, also when the writer is killed. What killed writers left behind is
/// removed. Anything at `path` that is not a bundle is refused and stays as it is. Throws Error(io); Error(bad_data)
/// when the bundle does not follow the schema, such as a map name with a space.
void write_bundle(const Bundle& bundle, const std::filesystem::path& path, const WriteOptions& options = {});

/// Reads all that can be read and leaves what is wrong in `log`.
LoadedBundle load_bundle(const std::filesystem::path& path, const ReadOptions& options, IssueLog& log);

}  // namespace texbake
