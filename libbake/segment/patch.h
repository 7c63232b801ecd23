// Patches: unions of whole fragments, of similar area, whose contents are exchanged as one.
// Based on: Vanhoey et al. 2013, §5.2, patch map.
#pragma once

#include "libbake/segment/fragment.h"

namespace texbake {

struct PatchOptions {
  std::optional<int> count;
  uint32_t seed = 1;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.count, Field{.name = "count",
                            .unit = "patches",
                            .min = 1,
                            .max = 4096,
                            .help = "number of patches aimed at",
                            .auto_help = "16, fewer where fragments are few"});
    visit(self.seed, Field{.name = "seed", .min = 0, .max = 4294967295.0, .help = "of the circle packing"});
  }
};

struct PatchMap {
  Partition partition;
};

PatchOptions resolve(const PatchOptions& options, const FragmentMap& fragments);

/// Packs circles on the torus and clusters the fragments that lie in them, so that patches are connected, of similar
/// area, and some lie across the tile's borders and corner. Throws Error(infeasible) when there are fewer fragments
/// than patches, or when no partition with patches under half the tile on each axis exists.
PatchMap patch(const FragmentMap& fragments, const PatchOptions& options = {}, const Progress& progress = {});

}  // namespace texbake
