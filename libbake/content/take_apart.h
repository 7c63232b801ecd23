// Takes the best of many translations that are far enough from each other, without sorting all of them: only what
// stands near a translation that is taken is looked at again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "libbake/content/cell_grid.h"

namespace texbake {

/// Whether two translations differ by at least `separation_px` along some axis of the torus (Chebyshev distance).
inline bool far_enough(V2i a, V2i b, V2i size, int separation_px) {
  const V2i d = shortest(a - b, size);
  return std::max(std::abs(d.x), std::abs(d.y)) >= separation_px;
}

/// Items 0 … count−1 with translations of 0 … size−1, of which the best is taken again and again, and all that are not
/// far enough from it leave.
/// `TranslationOf` gives the translation of an item, `Before` orders items strictly.
template <class TranslationOf, class Before>
class TakeApart {
 public:
  TakeApart(uint32_t count, V2i size, int separation_px, const TranslationOf& translation_of, const Before& before)
      : grid_{size, {cells_along(size.x, separation_px), cells_along(size.y, separation_px)}},
        separation_px_(separation_px),
        translation_of_(translation_of),
        before_(before),
        items_(count),
        cells_(static_cast<size_t>(grid_.cells.x * grid_.cells.y)) {
    // Sort the items by their cells.
    std::vector<uint32_t> column_cells, row_cells;  // divisions would take most of the time
    for (int x = 0; x < size.x; ++x) column_cells.push_back(static_cast<uint32_t>(grid_.cell_of({x, 0}).x));
    for (int y = 0; y < size.y; ++y) row_cells.push_back(static_cast<uint32_t>(cell_idx({0, grid_.cell_of({0, y}).y})));
    const auto cell_of = [&](uint32_t item) {
      const V2i t = translation_of_(item);
      return row_cells[static_cast<size_t>(t.y)] + column_cells[static_cast<size_t>(t.x)];
    };
    std::vector<uint32_t> begins(cells_.size() + 1, 0);
    for (uint32_t i = 0; i < count; ++i) ++begins[cell_of(i) + 1];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    for (size_t c = 0; c < cells_.size(); ++c) cells_[c] = {begins[c], begins[c + 1], kNone};
    for (uint32_t i = 0; i < count; ++i) items_[begins[cell_of(i)]++] = i;
    for (Cell& cell : cells_) keep(cell, [](uint32_t) { return true; });
  }

  /// Removes what is not far enough from `t`.
  void leave_out(V2i t) {
    const V2i size = grid_.size_px;
    const auto is_far = [&](uint32_t item) {  // far_enough without divisions
      const V2i p = translation_of_(item);
      const int dx = std::abs(p.x - t.x), dy = std::abs(p.y - t.y);
      return std::max(std::min(dx, size.x - dx), std::min(dy, size.y - dy)) >= separation_px_;
    };
    const Range xs = cells_near(t.x, size.x, grid_.cells.x), ys = cells_near(t.y, size.y, grid_.cells.y);
    for (int y = 0; y < ys.count; ++y)
      for (int x = 0; x < xs.count; ++x)
        keep(cells_[cell_idx({wrap(xs.first + x, grid_.cells.x), wrap(ys.first + y, grid_.cells.y)})], is_far);
  }

  /// The best item that is left; what is not far enough from it leaves, it too. kNone when none is left.
  uint32_t take() {
    uint32_t best = kNone;
    for (const Cell& cell : cells_)
      if (cell.best != kNone && (best == kNone || before_(cell.best, best))) best = cell.best;
    if (best != kNone) leave_out(translation_of_(best));
    return best;
  }

  static constexpr uint32_t kNone = UINT32_MAX;

 private:
  struct Cell {
    uint32_t begin = 0, end = 0;  // of `items_`
    uint32_t best = kNone;
  };
  struct Range {
    int first, count;
  };

  // Half a separation wide, so that most cells near a translation leave as a whole.
  static int cells_along(int size, int separation_px) {
    constexpr int kMostCells = 64;
    return std::clamp(2 * size / separation_px, 1, std::min(size, kMostCells));
  }
  size_t cell_idx(V2i cell) const { return static_cast<size_t>(cell.y * grid_.cells.x + cell.x); }

  // The cells along one axis in which something may be less than the separation away from `t`.
  Range cells_near(int t, int size, int cells) const {
    const int64_t reach = separation_px_ - 1, widest = size / cells + 1;
    if (2 * (reach + widest) >= size) return {0, cells};
    const int first = wrap(t - static_cast<int>(reach), size) * cells / size;
    const int last = wrap(t + static_cast<int>(reach), size) * cells / size;
    return {first, wrap(last - first, cells) + 1};
  }

  template <class Stays>
  void keep(Cell& cell, const Stays& stays) {
    cell.best = kNone;
    uint32_t end = cell.begin;
    for (uint32_t i = cell.begin; i < cell.end; ++i) {
      const uint32_t item = items_[i];
      if (!stays(item)) continue;
      items_[end++] = item;
      if (cell.best == kNone || before_(item, cell.best)) cell.best = item;
    }
    cell.end = end;
  }

  CellGrid grid_;
  int separation_px_;
  const TranslationOf& translation_of_;
  const Before& before_;
  std::vector<uint32_t> items_;  // by cell
  std::vector<Cell> cells_;
};

}  // namespace texbake
