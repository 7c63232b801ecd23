// Makes a tile of an exemplar: takes it as it is, or closes it along cuts of least error. One plan serves all maps.
// Based on: Efros and Freeman 2001, §2.1, with a second, closed cut; Kwatra et al. 2003, §3, for the cost of a seam.
#pragma once

#include <optional>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/base/options.h"
#include "libbake/base/torus.h"
#include "libbake/tile/seam_measure.h"

namespace texbake {

enum class Periodic {
  automatic,  ///< make, on the axes that do not tile
  assume,     ///< the exemplar tiles already
  make,       ///< close both axes
};
template <>
struct EnumNames<Periodic> {
  static constexpr std::pair<Periodic, std::string_view> values[] = {
      {Periodic::automatic, "auto"}, {Periodic::assume, "assume"}, {Periodic::make, "make"}};
};

inline constexpr int kMinExemplarSide = 32;

struct PeriodicOptions {
  Periodic periodic = Periodic::automatic;
  int multiple = 64;
  std::optional<int> overlap_px;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.periodic,
          Field{.name = "periodic",
                .help =
                    "assume: use the exemplar as a tile; make: close it into one; auto: make if its wrap seam shows"});
    visit(self.multiple,
          Field{.name = "multiple",
                .unit = "px",
                .min = 1,
                .max = 4096,
                .help = "the tile's width and height are multiples of this; mip levels need powers of two"});
    visit(self.overlap_px, Field{.name = "overlap",
                                 .unit = "px",
                                 .min = 4,
                                 .max = 8192,
                                 .help = "width of the strips in which the cuts run",
                                 .auto_help = "what remains of the exemplar beside the tile that closes best"});
  }
};

/// How one axis of the tile comes from the source.
struct AxisPlan {
  bool cut = false;  ///< closed along a cut, else taken as it is
  int begin = 0;     ///< first source texel
  int length = 0;    ///< texels before resampling: the period in the source
  int overlap = 0;   ///< the cut runs in texels begin … begin + overlap − 1, which meet those `length` further on
  int size = 0;      ///< texels of the tile; resampled where it is not `length`
};

/// Everything that the maps of a material need to follow the color into its tile.
struct TilePlan {
  V2i source_size{0};
  AxisPlan x, y;
  std::vector<int> cut_x;  ///< for each row begin … of the y axis, y.length + y.overlap of them; empty without a cut
  std::vector<int> cut_y;  ///< for each of x.length columns; empty without a cut
  SeamMeasure before;      ///< of the source
  SeamMeasure after;       ///< of the tile at its straight border, which the cuts leave
  /// Mean CIELUV difference of neighbors that a cut brought together / that of neighbors in the tile; 1 is ideal,
  /// leaves and pebbles reach 1.4-1.8 without being seen. 1 without a cut.
  double cut_ratio = 1;

  V2i size() const { return {x.size, y.size}; }
  bool is_cut() const { return x.cut || y.cut; }
  bool is_resampled() const { return x.size != x.length || y.size != y.length; }
  V2i tile_from_source() const { return {x.begin, y.begin}; }
  /// The source texel that tile texel p shows before resampling, p in (0, 0) … (x.length − 1, y.length − 1). Near the
  /// cuts its shade may have been leveled (seam_join.h).
  V2i source_place(V2i p) const;
};

/// `source` is linear Rec.709. An axis that is cut becomes a multiple of `multiple` within what the source has; another
/// size is chosen, and resampled to a multiple, only where a pattern repeats with it and closes much better. An axis
/// that is not cut is resampled to the nearest multiple. Neither stretches by more than 10 %: where the exemplar is too
/// small for that, `multiple` is halved as often as needed. The same bits for every number of threads.
///
/// Throws Error(bad_data) below kMinExemplarSide, Error(usage) for options out of range, Error(infeasible) when
/// `overlap_px` leaves less than half of the source.
TilePlan plan_tile(ImageView<const V3f> source, const PeriodicOptions& options = {});

/// The tile of one map of the material. A map of another size than the source is resampled to it first.
Image<V3f> apply(const TilePlan& plan, ImageView<const V3f> map);
Image<float> apply(const TilePlan& plan, ImageView<const float> map);
/// The same for vectors: where the plan cuts, or it or the map's size resamples, they are made unit vectors again.
Image<V3f> apply_to_normals(const TilePlan& plan, ImageView<const V3f> normals);

}  // namespace texbake
