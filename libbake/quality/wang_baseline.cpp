// Each side of a tile shows the exemplar around a place that belongs to the side's color, so that two tiles continue
// each other where their colors agree. Inside, the four sides' pictures meet along the half diagonals:
//
//      N N N        a half diagonal is cut along the path of least error in a band around it
//    W \ N / E
//    W   X   E
//    W / S \ E
//      S S S
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/base/random.h"
#include "libbake/color/luv.h"
#include "libbake/quality/baselines.h"

namespace texbake {
namespace {

enum Side { kNorth, kEast, kSouth, kWest };

// The places of the exemplar that the sides' colors show: [0 or 1] for west/east sides, and for north/south sides.
struct Places {
  std::array<V2i, 2> vertical_side;
  std::array<V2i, 2> horizontal_side;
};

struct SideColors {
  int north, east, south, west;  ///< 0 or 1 each
};

// Where the picture of one side is read for the tile's texel p.
V2i source_of(Side side, V2i p, const SideColors& colors, const Places& places, V2i size) {
  switch (side) {
    case kNorth:
      return wrap(places.horizontal_side[static_cast<size_t>(colors.north)] + p, size);
    case kSouth:
      return wrap(places.horizontal_side[static_cast<size_t>(colors.south)] + p - V2i(0, size.y), size);
    case kWest:
      return wrap(places.vertical_side[static_cast<size_t>(colors.west)] + p, size);
    default:
      return wrap(places.vertical_side[static_cast<size_t>(colors.east)] + p - V2i(size.x, 0), size);
  }
}

// The cut along one half diagonal. Step a = 0 … n/2−1 goes from the corner to the center; at each step the cut stands
// `offset` texels to the side of the diagonal, along the tile's long way for tiles that are not square.
template <class Error>
std::vector<int> least_error_offsets(int steps, int reach, const Error& error) {
  const int width = 2 * reach + 1;
  std::vector<double> cost(static_cast<size_t>(width), INFINITY);
  cost[static_cast<size_t>(reach)] = 0.0;
  std::vector<std::vector<int8_t>> from(static_cast<size_t>(steps), std::vector<int8_t>(static_cast<size_t>(width)));
  for (int a = 0; a < steps; ++a) {
    std::vector<double> next(static_cast<size_t>(width), INFINITY);
    const int open = std::min({a, steps - 1 - a, reach});  // the cut starts in the corner and ends in the center
    for (int u = -open; u <= open; ++u) {
      const auto i = static_cast<size_t>(u + reach);
      int best = 0;
      for (const int step : {-1, 1})
        if (u + step >= -reach && u + step <= reach &&
            cost[static_cast<size_t>(u + step + reach)] < cost[static_cast<size_t>(u + best + reach)])
          best = step;
      next[i] = cost[static_cast<size_t>(u + best + reach)] + error(a, u);
      from[static_cast<size_t>(a)][i] = static_cast<int8_t>(best);
    }
    cost = std::move(next);
  }
  std::vector<int> offsets(static_cast<size_t>(steps));
  int u = 0;
  for (int a = steps - 1; a >= 0; --a) {
    offsets[static_cast<size_t>(a)] = u;
    u += from[static_cast<size_t>(a)][static_cast<size_t>(u + reach)];
  }
  return offsets;
}

// One tile: the sources of its four pictures, joined.
Image<V2i> make_tile(ImageView<const V3f> luv, const SideColors& colors, const Places& places) {
  const V2i size(luv.width(), luv.height());
  const int steps = size.y / 2;
  const auto error_between = [&](Side a, Side b, V2i p) {
    const V2i pa = source_of(a, p, colors, places, size);
    const V2i pb = source_of(b, p, colors, places, size);
    return static_cast<double>((luv(pa.x, pa.y) - luv(pb.x, pb.y)).length2());
  };
  // x of the left and of the right cut in row y: the diagonal plus the offset.
  const auto diagonal = [&](int a) { return static_cast<int>((a + 0.5) * size.x / (2.0 * steps)); };
  const auto cut = [&](bool right, bool lower) {
    const auto texel = [&, right, lower](int a, int u) {
      const int x = std::clamp(diagonal(a) + u, 0, size.x - 1);
      return V2i(right ? size.x - 1 - x : x, lower ? size.y - 1 - a : a);
    };
    const auto error = [&](int a, int u) {
      return error_between(right ? kEast : kWest, lower ? kSouth : kNorth, texel(a, u));
    };
    std::vector<int> columns = least_error_offsets(steps, std::max(size.x / 8, 1), error);
    for (int a = 0; a < steps; ++a) columns[static_cast<size_t>(a)] = texel(a, columns[static_cast<size_t>(a)]).x;
    return columns;
  };
  const std::vector<int> cuts[2][2] = {{cut(false, false), cut(true, false)}, {cut(false, true), cut(true, true)}};

  Image<V2i> tile(size.x, size.y);
  for (int y = 0; y < size.y; ++y) {
    const int lower = y >= size.y - steps ? 1 : 0;
    const auto a = static_cast<size_t>(std::min(lower ? size.y - 1 - y : y, steps - 1));
    for (int x = 0; x < size.x; ++x) {
      Side side = lower ? kSouth : kNorth;
      if (x < cuts[lower][0][a])
        side = kWest;
      else if (x > cuts[lower][1][a])
        side = kEast;
      tile(x, y) = source_of(side, {x, y}, colors, places, size);
    }
  }
  return tile;
}

}  // namespace

WangTiling::WangTiling(ImageView<const V3f> exemplar_luv, V2i tiles, uint32_t seed)
    : size_(exemplar_luv.width(), exemplar_luv.height()), tile_idx_(tiles.x, tiles.y) {
  Random random(seed);
  const auto place = [&] {
    const auto x = static_cast<int>(random.below(static_cast<uint32_t>(size_.x)));
    return V2i(x, static_cast<int>(random.below(static_cast<uint32_t>(size_.y))));
  };
  Places places;
  for (V2i& p : places.vertical_side) p = place();
  for (V2i& p : places.horizontal_side) p = place();

  // A color for every side of the grid of tiles, on the torus of the picture.
  Image<uint8_t> west_colors(tiles.x, tiles.y);
  Image<uint8_t> north_colors(tiles.x, tiles.y);
  for (uint8_t& color : west_colors) color = static_cast<uint8_t>(random.below(2));
  for (uint8_t& color : north_colors) color = static_cast<uint8_t>(random.below(2));

  // Make each of the 16 tiles when it is first needed.
  for (int j = 0; j < tiles.y; ++j)
    for (int i = 0; i < tiles.x; ++i) {
      const SideColors colors{north_colors(i, j), west_colors(wrap(i + 1, tiles.x), j),
                              north_colors(i, wrap(j + 1, tiles.y)), west_colors(i, j)};
      tile_idx_(i, j) = static_cast<uint8_t>(colors.north * 8 + colors.east * 4 + colors.south * 2 + colors.west);
      Image<V2i>& tile = sources_[tile_idx_(i, j)];
      if (tile.empty()) tile = make_tile(exemplar_luv, colors, places);
    }
}

Image<V3f> wang_baseline(ImageView<const V3f> exemplar, V2i tiles, uint32_t seed) {
  const WangTiling tiling(luv_from_linear(exemplar), tiles, seed);
  Image<V3f> picture(tiling.size_px().x, tiling.size_px().y);
  parallel_for(0, picture.height(), [&](int y) {
    for (int x = 0; x < picture.width(); ++x) {
      const V2i source = tiling.source(x, y);
      picture(x, y) = exemplar(source.x, source.y);
    }
  });
  return picture;
}

}  // namespace texbake
