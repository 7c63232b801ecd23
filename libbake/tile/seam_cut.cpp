#include "libbake/tile/seam_cut.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace texbake {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What a cut before column x costs in row y: the pair (x − 1, y), (x, y).
double crossing_cost(ImageView<const float> mismatch, int x, int y) {
  return double{mismatch(x - 1, y)} + double{mismatch(x, y)};
}

// Columns, both ends included.
struct Span {
  int least;
  int greatest;
};

// The columns a cut may take in each row.
struct Corridor {
  std::vector<int> least;
  std::vector<int> greatest;
  Span operator[](int y) const { return {least[y], greatest[y]}; }
};

// Dynamic programming down the rows, inside a corridor.
class RowByRow {
 public:
  explicit RowByRow(ImageView<const float> mismatch)
      : mismatch_(mismatch),
        from_(mismatch.width(), mismatch.height() + 1),
        cost_(static_cast<size_t>(mismatch.width())),
        before_(cost_),
        moves_(cost_.size() + 1) {}

  SeamCut open_cut(const Corridor& corridor) {
    start(corridor[0]);
    for (int y = 1; y < mismatch_.height(); ++y) step(y - 1, corridor[y - 1], y, corridor[y], y);
    const Span last = corridor[mismatch_.height() - 1];
    const auto best = std::min_element(cost_.begin() + last.least, cost_.begin() + last.greatest + 1);
    return trace(static_cast<int>(best - cost_.begin()), mismatch_.height() - 1);
  }

  // The cheapest closed cut that passes row 0 at `column`.
  SeamCut closed_cut(const Corridor& corridor, int column) {
    const int rows = mismatch_.height();
    const Span home{column, column};
    start(home);
    for (int y = 1; y < rows; ++y) step(y - 1, y == 1 ? home : corridor[y - 1], y, corridor[y], y);
    // Back to row 0, whose own crossing was paid at the start.
    step(rows - 1, rows == 1 ? home : corridor[rows - 1], 0, home, rows);
    cost_[column] -= crossing_cost(mismatch_, column, 0);
    return trace(column, rows);
  }

 private:
  void start(Span span) {
    for (int x = span.least; x <= span.greatest; ++x) cost_[x] = crossing_cost(mismatch_, x, 0);
  }

  // From the columns `old` of row y to the columns `now` of row `next`, which is step `row` of the path. A move
  // between two columns costs the pairs above each other on its way: the difference of running sums, so that one sweep
  // from each side finds the best column to come from.
  void step(int y, Span old, int next, Span now, int row) {
    const Span both{std::min(old.least, now.least), std::max(old.greatest, now.greatest)};
    before_.swap(cost_);
    moves_[both.least] = 0;
    for (int x = both.least; x < both.greatest; ++x)
      moves_[x + 1] = moves_[x] + (double{mismatch_(x, y)} + double{mismatch_(x, next)});

    double best = kInfinity;
    int best_x = old.least;
    for (int x = both.least; x <= now.greatest; ++x) {
      if (x >= old.least && x <= old.greatest && before_[x] - moves_[x] < best) best = before_[x] - moves_[best_x = x];
      if (x >= now.least) cost_[x] = best + moves_[x], from_(x, row) = best_x;
    }
    best = kInfinity;
    for (int x = both.greatest; x >= now.least; --x) {
      if (x >= old.least && x <= old.greatest && before_[x] + moves_[x] < best) best = before_[x] + moves_[best_x = x];
      if (x <= now.greatest && best - moves_[x] < cost_[x]) cost_[x] = best - moves_[x], from_(x, row) = best_x;
    }
    for (int x = now.least; x <= now.greatest; ++x) cost_[x] += crossing_cost(mismatch_, x, next);
  }

  SeamCut trace(int column, int last_row) const {
    SeamCut cut;
    cut.cost = cost_[column];
    cut.column.resize(static_cast<size_t>(mismatch_.height()));
    for (int row = last_row; row >= 0; --row) {
      if (row < mismatch_.height()) cut.column[row] = column;
      if (row > 0) column = from_(column, row);
    }
    return cut;
  }

  ImageView<const float> mismatch_;
  Image<int> from_;  // column in the row before, for each column and row
  std::vector<double> cost_;
  std::vector<double> before_;
  std::vector<double> moves_;
};

// Cheapest closed cuts that pass row 0 at different columns need not cross: the one through the middle column
// bounds those on either side.
void best_closed_cut(RowByRow& search, const Corridor& corridor, SeamCut& best) {
  const int least = corridor.least[0], greatest = corridor.greatest[0];
  if (least > greatest) return;
  const int middle = least + (greatest - least) / 2;
  const SeamCut cut = search.closed_cut(corridor, middle);
  if (cut.cost < best.cost) best = cut;

  Corridor left{corridor.least, cut.column}, right{cut.column, corridor.greatest};
  left.greatest[0] = middle - 1;
  right.least[0] = middle + 1;
  best_closed_cut(search, left, best);
  best_closed_cut(search, right, best);
}

}  // namespace

SeamCut minimum_cut(ImageView<const float> mismatch, CutEnds ends) {
  assert(mismatch.width() >= 2 && mismatch.height() >= 1);
  const auto rows = static_cast<size_t>(mismatch.height());
  const Corridor whole{std::vector<int>(rows, 1), std::vector<int>(rows, mismatch.width() - 1)};
  RowByRow search(mismatch);
  if (ends == CutEnds::open) return search.open_cut(whole);
  SeamCut best{{}, kInfinity};
  best_closed_cut(search, whole, best);
  return best;
}

double cut_cost(ImageView<const float> mismatch, const std::vector<int>& column, CutEnds ends) {
  double cost = 0;
  const int rows = mismatch.height();
  for (int y = 0; y < rows; ++y) {
    cost += crossing_cost(mismatch, column[y], y);
    if (y + 1 == rows && ends == CutEnds::open) break;
    const int next = (y + 1) % rows;
    const auto [low, high] = std::minmax(column[y], column[next]);
    for (int x = low; x < high; ++x) cost += double{mismatch(x, y)} + double{mismatch(x, next)};
  }
  return cost;
}

}  // namespace texbake
