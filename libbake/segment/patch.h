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
                            .help = "target number of patches",
                            .auto_help = "16; fewer if there are few fragments"});
    visit(self.seed, Field{.name = "seed", .min = 0, .max = 4294967295.0, .help = "random seed of the circle packing"});
  }
};

struct PatchMap {
  Partition partition;
};

/// 16 patches, fewer where there are less than four fragments for each, but not below nine, nor above one for each.
PatchOptions resolve(const PatchOptions& options, const FragmentMap& fragments);

/// `base` is the picture that was fragmented, linear Rec.709. Packs circles on the torus, the first over the corner of
/// the tile, and clusters the fragments that lie in them, so that patches are connected, of similar area and under half
/// the tile on each axis; then moves single fragments across their borders, towards equal areas and to where the
/// picture steps. Patches are numbered by their first texel in row order. There are more than asked for where no
/// packing of several tried keeps so few under half the tile: few patches, large fragments, or a very long tile. Throws
/// Error(infeasible) when there are fewer fragments than patches, and for fewer than five patches, which cannot all be
/// under half the tile.
PatchMap patch(const FragmentMap& fragments, ImageView<const V3f> base, const PatchOptions& options = {},
               const Progress& progress = {});

/// How even the patches are, and how many hide the borders of the tile.
struct PatchQuality {
  double area_variation = 0;  ///< standard deviation of the areas divided by their mean
  uint32_t min_area_px = 0;
  uint32_t max_area_px = 0;
  int across_border = 0;          ///< patches with texels on both sides of a border of the tile
  bool is_across_corner = false;  ///< one patch holds all four texels around the corner
  double border_delta_e = 0;      ///< mean step of the picture across the borders of patches
  double fragment_delta_e = 0;    ///< the same over all borders of fragments: what chance would give
};
PatchQuality patch_quality(const PatchMap& patches, const FragmentMap& fragments, ImageView<const V3f> base);

}  // namespace texbake
