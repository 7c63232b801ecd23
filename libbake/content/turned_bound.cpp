#include "libbake/content/turned_bound.h"

#include <algorithm>

#include "libbake/base/fft.h"
#include "libbake/base/parallel.h"

namespace texbake {
namespace {

constexpr int kMostCells = 256;  // along the longer side

CellGrid grid_of(V2i size) {
  const int side = std::max(size.x, size.y);
  const auto cells = [&](int n) { return side <= kMostCells ? n : std::max((n * kMostCells + side / 2) / side, 1); };
  return {size, {cells(size.x), cells(size.y)}};
}

// What part of each cell's texels is of a class.
Image<float> class_shares(ImageView<const uint8_t> classes, const CellGrid& grid, int class_idx) {
  Image<float> counts(grid.cells.x, grid.cells.y), all(grid.cells.x, grid.cells.y);
  for (int y = 0; y < classes.height(); ++y)
    for (int x = 0; x < classes.width(); ++x) {
      const V2i cell = grid.cell_of({x, y});
      counts(cell.x, cell.y) += classes(x, y) == class_idx ? 1.0f : 0.0f;
      all(cell.x, cell.y) += 1.0f;
    }
  for (size_t i = 0; i < counts.size(); ++i) counts.data()[i] /= all.data()[i];
  return counts;
}

}  // namespace

TurnedBound::TurnedBound(ImageView<const uint8_t> classes, const ClassDistances& distances)
    : grid_(grid_of({classes.width(), classes.height()})),
      distances_(distances),
      shares_(static_cast<size_t>(distances.class_count)) {
  parallel_for(0, distances.class_count, [&](int class_idx) {
    shares_[static_cast<size_t>(class_idx)] = fft<float>(class_shares(classes, grid_, class_idx));
  });
}

// What a texel of the class costs at each offset from the center, by the border texels that are turned there.
Image<float> TurnedBound::weights(std::span<const BorderTexel> border, const Content& turn, int class_idx) const {
  Image<float> weights(grid_.cells.x, grid_.cells.y);
  const auto nearest_cell = [](int px, int cells, int size) {
    const int twice = 2 * px * cells + size;
    return wrap(twice >= 0 ? twice / (2 * size) : -((-twice + 2 * size - 1) / (2 * size)), cells);
  };
  for (const BorderTexel& texel : border) {
    const V2i u = source_offset(turn, texel.offset);
    const int delta = distances_.at(texel.class_idx, class_idx);
    weights(nearest_cell(u.x, grid_.cells.x, grid_.size_px.x), nearest_cell(u.y, grid_.cells.y, grid_.size_px.y)) +=
        static_cast<float>(delta * delta);
  }
  return weights;
}

std::array<Image<float>, 2> TurnedBound::bounds(std::span<const BorderTexel> border, const Content& turn) const {
  // Half a turn more negates the offsets: the spectrum of the weights is conjugated.
  Spectrum turned(grid_.cells.x, grid_.cells.y), half_turned(grid_.cells.x, grid_.cells.y);
  for (int class_idx = 0; class_idx < distances_.class_count; ++class_idx) {
    const Spectrum weighted = fft<float>(weights(border, turn, class_idx));
    const Spectrum& share = shares_[static_cast<size_t>(class_idx)];
    for (size_t i = 0; i < share.size(); ++i) {
      const float a = weighted.data()[i].real(), b = weighted.data()[i].imag();
      const float c = share.data()[i].real(), d = share.data()[i].imag();
      const float ac = a * c, bd = b * d, ad = a * d, bc = b * c;
      turned.data()[i] += std::complex<float>(ac + bd, ad - bc);
      half_turned.data()[i] += std::complex<float>(ac - bd, ad + bc);
    }
  }
  return {inverse_fft_real<float>(turned), inverse_fft_real<float>(half_turned)};
}

}  // namespace texbake
