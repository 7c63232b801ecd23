#include "libbake/content/far_view.h"

#include <algorithm>
#include <cassert>

#include "libbake/base/gaussian.h"
#include "libbake/base/mean.h"
#include "libbake/base/parallel.h"
#include "libbake/content/shown_source.h"

namespace texbake {
namespace {

constexpr int kCells = 32;         // along the shorter side: two for the narrowest σ, which is all that B leaves
constexpr int kPiecesPerCell = 8;  // along each axis
constexpr double kSigmas[] = {1.0 / 16, 1.0 / 8};  // by FarBlur, in shorter sides

int area_px(const CellGrid& grid, V2i cell) {
  const V2i extent = grid.first_px(cell + V2i(1, 1)) - grid.first_px(cell);
  return extent.x * extent.y;
}

// The mean of the texels of a cell.
V3f cell_mean(ImageView<const V3f> luv, V2i cell, const CellGrid& grid) {
  const V2i begin = grid.first_px(cell), end = grid.first_px(cell + V2i(1, 1));
  V3f sum(0);
  for (int y = begin.y; y < end.y; ++y)
    for (int x = begin.x; x < end.x; ++x) sum += luv(x, y);
  return sum / static_cast<float>(area_px(grid, cell));
}

// The Gaussian applied twice on a circle of `cells`.
std::vector<float> twice_folded(double sigma, int cells) {
  const std::vector<float> kernel = gaussian_kernel(sigma);
  const int radius = static_cast<int>(kernel.size()) / 2;
  std::vector<double> once(static_cast<size_t>(cells), 0.0), twice(static_cast<size_t>(cells), 0.0);
  for (int d = -radius; d <= radius; ++d)
    once[static_cast<size_t>(wrap(d, cells))] += static_cast<double>(kernel[static_cast<size_t>(d + radius)]);
  for (int a = 0; a < cells; ++a)
    for (int b = 0; b < cells; ++b)
      twice[static_cast<size_t>((a + b) % cells)] += once[static_cast<size_t>(a)] * once[static_cast<size_t>(b)];
  return {twice.begin(), twice.end()};
}

}  // namespace

FarField& FarField::operator+=(const FarField& other) {
  assert(first == other.first && extent == other.extent);
  for (size_t i = 0; i < colors.size(); ++i) colors[i] += other.colors[i];
  return *this;
}

FarField& FarField::operator*=(float factor) {
  for (V3f& c : colors) c *= factor;
  return *this;
}

double dot(const FarField& a, const FarField& b) {
  assert(a.first == b.first && a.extent == b.extent);
  double sum = 0.0;
  for (size_t i = 0; i < a.colors.size(); ++i) sum += static_cast<double>(a.colors[i].dot(b.colors[i]));
  return sum;
}

FarView::FarView(ImageView<const V3f> base_luv, const Partition& patches)
    : partition_(patches),
      grid_(CellGrid::of({base_luv.width(), base_luv.height()}, kCells)),
      pieces_(CellGrid::of({base_luv.width(), base_luv.height()}, kCells * kPiecesPerCell)),
      piece_mean_(pieces_.cells.x, pieces_.cells.y),
      patches_(patches.centers.size()) {
  const V3f mean = mean_of(base_luv);
  parallel_for(0, pieces_.cells.y, [&](int y) {
    for (int x = 0; x < pieces_.cells.x; ++x) piece_mean_(x, y) = cell_mean(base_luv, {x, y}, pieces_) - mean;
  });
  find_pieces(patches);
  FarField tile = blank();
  for (uint32_t patch = 0; patch < patches_.size(); ++patch) add(shown(patch, Content{}), tile);
  for (const FarBlur blur : {FarBlur::far, FarBlur::farther}) {
    Blur& made = blurs_[static_cast<size_t>(blur)];
    const double sigma_cells = kSigmas[static_cast<size_t>(blur)] * std::min(grid_.cells.x, grid_.cells.y);
    made.kernel_x = twice_folded(sigma_cells, grid_.cells.x);
    made.kernel_y = twice_folded(sigma_cells, grid_.cells.y);
    made.tile_energy = energy(tile, blur);
  }
}

void FarView::find_pieces(const Partition& patches) {
  // Where each patch lies, in steps from the cell of its center.
  std::vector<V2i> low(patches_.size(), grid_.cells), high(patches_.size(), V2i(0) - grid_.cells);
  const auto step_to = [&](uint32_t patch, V2i p) {
    return shortest(grid_.cell_of(p) - grid_.cell_of(patches.centers[patch]), grid_.cells);
  };
  const auto for_all_pieces = [&](const auto& body) {
    for (int y = 0; y < pieces_.cells.y; ++y)
      for (int x = 0; x < pieces_.cells.x; ++x) {
        const V2i p = pieces_.middle_px({x, y});
        body(V2i(x, y), p, patches.idx(p.x, p.y));
      }
  };
  for_all_pieces([&](V2i, V2i p, uint32_t patch) {
    const V2i step = step_to(patch, p);
    low[patch] = {std::min(low[patch].x, step.x), std::min(low[patch].y, step.y)};
    high[patch] = {std::max(high[patch].x, step.x), std::max(high[patch].y, step.y)};
  });
  for (size_t i = 0; i < patches_.size(); ++i) {
    FarField& rectangle = patches_[i].rectangle;
    rectangle.first = wrap(grid_.cell_of(patches.centers[i]) + low[i], grid_.cells);
    rectangle.extent = {std::max(0, high[i].x - low[i].x + 1), std::max(0, high[i].y - low[i].y + 1)};
    rectangle.colors.assign(static_cast<size_t>(rectangle.extent.x * rectangle.extent.y), V3f(0));
  }
  const auto tile_area = static_cast<double>(patches.idx.size());
  for_all_pieces([&](V2i piece, V2i p, uint32_t patch) {
    PatchCells& of_patch = patches_[patch];
    const V2i at = step_to(patch, p) - low[patch];
    const auto area = static_cast<double>(area_px(pieces_, piece));
    of_patch.pieces.push_back({p, static_cast<size_t>(at.y * of_patch.rectangle.extent.x + at.x),
                               static_cast<float>(area / area_px(grid_, grid_.cell_of(p)))});
    of_patch.share += area / tile_area;
  });
}

FarField FarView::shown(uint32_t patch, const Content& content) const {
  FarField field = patches_[patch].rectangle;
  for (const Piece& piece : patches_[patch].pieces) {
    const V2i source = pieces_.cell_of(shown_source(partition_, patch, piece.middle_px, content));
    field.colors[piece.cell] += piece_mean_(source.x, source.y) * piece.weight;
  }
  return field;
}

FarField FarView::blank() const {
  return {{0, 0}, grid_.cells, std::vector<V3f>(static_cast<size_t>(grid_.cells.x * grid_.cells.y), V3f(0))};
}

void FarView::add(const FarField& part, FarField& whole) const {
  assert(whole.extent == grid_.cells);
  for (int y = 0; y < part.extent.y; ++y)
    for (int x = 0; x < part.extent.x; ++x) {
      const V2i cell = wrap(part.first + V2i(x, y), grid_.cells);
      whole.colors[static_cast<size_t>(cell.y * grid_.cells.x + cell.x)] +=
          part.colors[static_cast<size_t>(y * part.extent.x + x)];
    }
}

FarField FarView::blurred_twice(const FarField& field, const FarField& where, FarBlur blur) const {
  const Blur& twice = blurs_[static_cast<size_t>(blur)];
  // Along x, for every row of the field at every column asked for; then along y.
  FarField rows{{where.first.x, field.first.y}, {where.extent.x, field.extent.y}, {}};
  rows.colors.resize(static_cast<size_t>(rows.extent.x * rows.extent.y));
  for (int y = 0; y < rows.extent.y; ++y)
    for (int x = 0; x < rows.extent.x; ++x) {
      V3f sum(0);
      int d = wrap(rows.first.x + x - field.first.x, grid_.cells.x);
      for (int i = 0; i < field.extent.x; ++i, d = d == 0 ? grid_.cells.x - 1 : d - 1)
        sum += field.colors[static_cast<size_t>(y * field.extent.x + i)] * twice.kernel_x[static_cast<size_t>(d)];
      rows.colors[static_cast<size_t>(y * rows.extent.x + x)] = sum;
    }
  FarField result{where.first, where.extent, std::vector<V3f>(where.colors.size(), V3f(0))};
  for (int y = 0; y < result.extent.y; ++y) {
    int d = wrap(result.first.y + y - rows.first.y, grid_.cells.y);
    for (int j = 0; j < rows.extent.y; ++j, d = d == 0 ? grid_.cells.y - 1 : d - 1)
      for (int x = 0; x < result.extent.x; ++x)
        result.colors[static_cast<size_t>(y * result.extent.x + x)] +=
            rows.colors[static_cast<size_t>(j * rows.extent.x + x)] * twice.kernel_y[static_cast<size_t>(d)];
  }
  return result;
}

double FarView::energy(const FarField& field, FarBlur blur) const {
  return dot(field, blurred_twice(field, field, blur));
}

}  // namespace texbake
