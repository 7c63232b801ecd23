// The infinite texture as it looks from afar, from its contents alone: what the balanced choice weighs.
// Based on: quality measures of repetition. A picture low-passed by B has the energy |B f|² = ⟨f, B² f⟩, so that what a
// patch shows need be known inside the patch only, and what it adds to its surroundings follows.
#pragma once

#include <vector>

#include "libbake/base/image.h"
#include "libbake/content/cell_grid.h"
#include "libbake/content/content.h"
#include "libbake/segment/partition.h"

namespace texbake {

/// Colours of a rectangle of cells on the torus, row by row.
struct FarField {
  V2i first{0, 0};  ///< cell, 0 … cells−1
  V2i extent{0, 0};
  std::vector<V3f> colors;

  FarField& operator+=(const FarField& other);  ///< of the same rectangle
  FarField& operator*=(float factor);
};

/// Σ over the cells of a · b; both of the same rectangle.
double dot(const FarField& a, const FarField& b);

/// The tile on a grid of about 32 cells along its shorter side, seen through a Gaussian B.
class FarView {
 public:
  static constexpr double kFar = 1.0 / 16;     ///< σ of the measures of repetition, in shorter sides
  static constexpr double kFarther = 1.0 / 8;  ///< of the measure of the largest shapes

  /// `base_luv` is the base in CIELUV; `patches` is borrowed. `sigma` is at least 1/16: cells are 1/32.
  FarView(ImageView<const V3f> base_luv, const Partition& patches, double sigma = kFar);

  /// What `patch` shows with `content`, less the tile's mean colour: for each cell near the patch the sum over what the
  /// patch covers of it, divided by the cell's area.
  FarField shown(uint32_t patch, const Content& content) const;
  /// Of the area of the tile.
  double share_of(uint32_t patch) const { return patches_[patch].share; }

  FarField blank() const;                                                      ///< all cells of the tile, 0
  void add(const FarField& part, FarField& whole) const;                       ///< to a field of all cells
  FarField blurred_twice(const FarField& field, const FarField& where) const;  ///< B² of it, at the cells of `where`
  double energy(const FarField& field) const;                                  ///< |B f|², summed over the cells
  /// That of the tile as it is, less its mean.
  double tile_energy() const { return tile_energy_; }

 private:
  // A small piece of the tile, inside one patch and one cell.
  struct Piece {
    V2i middle_px;
    size_t cell;   // in the patch's rectangle
    float weight;  // of the cell's area
  };
  struct PatchCells {
    FarField rectangle;  // colours 0
    std::vector<Piece> pieces;
    double share = 0;
  };

  void find_pieces(const Partition& patches);

  const Partition& partition_;
  CellGrid grid_;                           // what is seen
  CellGrid pieces_;                         // what is gathered: eight pieces along a cell
  Image<V3f> piece_mean_;                   // less the tile's mean
  std::vector<float> kernel_x_, kernel_y_;  // B², folded onto the torus
  std::vector<PatchCells> patches_;
  double tile_energy_ = 0;
};

}  // namespace texbake
