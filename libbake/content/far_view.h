// The infinite texture as it looks from afar, from its contents alone: what the balanced choice weighs.
// Based on: quality measures of repetition. A picture low-passed by B has the energy |B f|² = ⟨f, B² f⟩, so that what a
// patch shows need be known inside the patch only, and what it adds to its surroundings follows.
#pragma once

#include <array>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/content/cell_grid.h"
#include "libbake/content/content.h"
#include "libbake/segment/partition.h"

namespace texbake {

/// Colors of a rectangle of cells on the torus, row by row.
struct FarField {
  V2i first{0, 0};  ///< cell, 0 … cells−1
  V2i extent{0, 0};
  std::vector<V3f> colors;

  FarField& operator+=(const FarField& other);  ///< of the same rectangle
  FarField& operator*=(float factor);
};

/// Σ over the cells of a · b; both of the same rectangle.
double dot(const FarField& a, const FarField& b);

/// The Gaussian B through which the tile is seen; its σ is a part of the shorter side.
enum class FarBlur {
  far,      ///< 1/16: of the measures of repetition
  farther,  ///< 1/8: of the measure of the largest shapes
};

/// The tile on a grid of about 32 cells along its shorter side, seen through Gaussians.
class FarView {
 public:
  /// `base_luv` is the base in CIELUV; `patches` is borrowed.
  FarView(ImageView<const V3f> base_luv, const Partition& patches);

  /// What `patch` shows with `content`, less the tile's mean color: for each cell near the patch the sum over what the
  /// patch covers of it, divided by the cell's area.
  FarField shown(uint32_t patch, const Content& content) const;
  /// Of the area of the tile.
  double share_of(uint32_t patch) const { return patches_[patch].share; }

  FarField blank() const;                                 ///< all cells of the tile, 0
  void add(const FarField& part, FarField& whole) const;  ///< to a field of all cells
  /// B² of it, at the cells of `where`.
  FarField blurred_twice(const FarField& field, const FarField& where, FarBlur blur = FarBlur::far) const;
  double energy(const FarField& field, FarBlur blur = FarBlur::far) const;  ///< |B f|², summed over the cells
  /// That of the tile as it is, less its mean.
  double tile_energy(FarBlur blur = FarBlur::far) const { return blurs_[static_cast<size_t>(blur)].tile_energy; }

 private:
  // A small piece of the tile, inside one patch and one cell.
  struct Piece {
    V2i middle_px;
    size_t cell;   // in the patch's rectangle
    float weight;  // of the cell's area
  };
  struct PatchCells {
    FarField rectangle;  // colors 0
    std::vector<Piece> pieces;
    double share = 0;
  };

  struct Blur {
    std::vector<float> kernel_x, kernel_y;  // B², folded onto the torus
    double tile_energy = 0;
  };

  void find_pieces(const Partition& patches);

  const Partition& partition_;
  CellGrid grid_;          // what is seen
  CellGrid pieces_;        // what is gathered: eight pieces along a cell
  Image<V3f> piece_mean_;  // less the tile's mean
  std::vector<PatchCells> patches_;
  std::array<Blur, 2> blurs_;  // by FarBlur
};

}  // namespace texbake
