// The slow painter of several scales: paints each forward by itself, and adds the coarse color at the center of each
// fine fragment (CE13, eq. 5); blocks of texels by definition; and rays that meet the relief of the coarsest scale. For
// colors that are passed by fragment.
#pragma once

#include <algorithm>
#include <deque>

#include "level_painter.h"
#include "libbake/color/luv.h"
#include "libbake/planes/local_mean.h"
#include "small_stack.h"

namespace texbake {

class StackPainter {
 public:
  /// Scales draw with seeds of their own.
  StackPainter(const SmallStack& stack, uint32_t seed) {
    auto transfer = stack.transfers.begin();
    for (const ScaleTile& tile : stack.tiles) {
      const auto further = static_cast<uint64_t>(stack.tiles.size() - 1 - scales_.size());
      scales_.emplace_back(tile, *transfer++, static_cast<uint32_t>(uint64_t{seed} + further * 2654435769));
    }
    // The share of a color that is given is the finer scale's to say.
    for (size_t s = 0; s + 1 < scales_.size(); ++s) scales_[s].giving = scales_[s + 1].transfer.coarse_weights;
  }

  int finest() const { return static_cast<int>(scales_.size()) - 1; }

  /// What a texel of a scale shows: its own color, less the mean of its scale, and the coarse color where the center
  /// of its fragment lies, as far as the one takes and the other gives it. `variation` is the share that is left of its
  /// own.
  V3f texel(int scale, int64_t x, int64_t y, float variation) const {
    const ScaleData& data = scales_[static_cast<size_t>(scale)];
    const std::vector<Entry> entries = entries_at(data, x, y);
    if (entries.size() == 1 || scale == 0) return stacked(scale, x, y, variation).color;
    // On a soft border every patch takes the colors of its own fragment, by its weight.
    V3f taken(0);
    for (const Entry& entry : entries) {
      const Piece piece = piece_of(data, x, y, entry);
      const Passed coarse = stacked(scale - 1, Painter::floor_div(piece.center.x, data.transfer.ratio),
                                    Painter::floor_div(piece.center.y, data.transfer.ratio), 1);
      const float share = static_cast<float>(double{entry.weight} * double{piece.taking});
      taken += (coarse.color - mean_of(data, piece.middle, variation)) * (coarse.giving * share);
    }
    return shared(data, x, y, entries, variation) + taken;
  }

  V3f bilinear(int scale, int64_t x_256, int64_t y_256, float variation) const {
    return between(x_256, y_256, 256, [&](int64_t x, int64_t y) { return texel(scale, x, y, variation); });
  }

  /// The finest scale, faded into the next coarser one at the same point, in 1/256 of its texels rounded down.
  V3f faded(int64_t x_256, int64_t y_256, float fading, float variation) const {
    const V3f near = bilinear(finest(), x_256, y_256, variation);
    const int ratio = scales_.back().transfer.ratio;
    const V3f far = bilinear(finest() - 1, Painter::floor_div(x_256, ratio), Painter::floor_div(y_256, ratio), 1);
    return fading == 1 ? far : near + (far - near) * fading;
  }

  /// The finest scale between two of its levels of detail; above level 0 where borders are hard.
  V3f trilinear(int64_t x_256, int64_t y_256, int level_256, float variation) const {
    const auto at_level = [&](int level) {
      return between(x_256, y_256, int64_t{256} << level,
                     [&](int64_t x, int64_t y) { return block(x, y, level, variation); });
    };
    const V3f finer = at_level(level_256 / 256);
    if (level_256 % 256 == 0) return finer;
    return finer + (at_level(level_256 / 256 + 1) - finer) * (static_cast<float>(level_256 % 256) / 256);
  }

  /// Block (x, y) of the finest scale: of its own colors the mean, patch by patch; and of the coarse ones what its
  /// fragments take, each by its share of the block.
  V3f block(int64_t x, int64_t y, int level, float variation) const {
    const int side = 1 << level;
    if (level == 0) return texel(finest(), x, y, variation);
    const ScaleData& scale = scales_.back();
    const V3f own = scale.whole.block(x, y, level), dominant = scale.dominant.shares(x, y, side);
    V3f taken(0);
    for (const std::vector<V2i>& patch : scale.whole.patches_of(x, y, side)) {
      V3f sum(0);
      for (const Piece& piece : pieces(x * side, y * side, patch)) {
        const Passed coarse = stacked(finest() - 1, Painter::floor_div(piece.center.x, scale.transfer.ratio),
                                      Painter::floor_div(piece.center.y, scale.transfer.ratio), 1);
        const float share = static_cast<float>(double{piece.taking} * piece.texels / side / side);
        sum += (coarse.color - mean_of(scale, piece.middle, variation)) * (coarse.giving * share);
      }
      taken += sum;
    }
    const V3f kept = variation == 1 ? own : variation == 0 ? dominant : dominant + (own - dominant) * variation;
    return kept + taken;
  }

  /// The mean that the evaluator prepares: how it is blurred is no part of what is painted.
  static Image<V3f> smooth(const Image<V3f>& base, int border_px) {
    Image<glsl::vec4> texels(base.width(), base.height(), {0, 0, 0, 0});
    for (size_t i = 0; i < base.size(); ++i)
      texels.data()[i] = {base.data()[i].x, base.data()[i].y, base.data()[i].z, 0};
    Image<V3f> mean(base.width(), base.height());
    const Image<glsl::vec4> blurred = local_mean(texels, border_px);
    for (size_t i = 0; i < mean.size(); ++i)
      mean.data()[i] = {blurred.data()[i].x, blurred.data()[i].y, blurred.data()[i].z};
    return mean;
  }

 private:
  struct ScaleData {
    const ScaleTile& tile;
    const ScaleTransfer& transfer;
    std::vector<V3f> dominants;
    SmallTile gained_tile, dominant_tile;
    Painter painter;
    LevelPainter whole, dominant;
    V3f mean_of_dominants{0};
    Image<V3f> mean_base;  ///< with its gains; of the noises their means
    V3f mean_of_all{0};
    Image<V3f> smooth_whole{}, smooth_dominant{};  ///< without detail, where borders are soft
    std::vector<float> giving = {};

    ScaleData(const ScaleTile& t, const ScaleTransfer& how, uint32_t seed)
        : tile(t),
          transfer(how),
          dominants(dominants_of(t)),
          gained_tile(with_base(t.tile, gained(t, how, dominants, t.tile.base))),
          dominant_tile(with_base(t.tile, dominant_base(t, dominants))),
          painter(t.tile, seed),
          whole(gained_tile, seed, gains(t, how), &t.tile),
          dominant(dominant_tile, seed),
          mean_of_dominants(mean(dominant_tile.base)),
          mean_base(gained(t, how, dominants, with_noise_means(t.tile))),
          mean_of_all(mean(mean_base)) {
      gained_tile.masks = copies(t.tile.masks);
      gained_tile.noises = copies(t.tile.noises);
      gained_tile.noise_step = t.tile.noise_step;
      gained_tile.noise_space = t.tile.noise_space;
      if (t.tile.soft_border_px == 0) return;
      smooth_whole = smooth(gained_tile.base, t.tile.soft_border_px);
      smooth_dominant = smooth(dominant_tile.base, t.tile.soft_border_px);
    }
    ScaleData(const ScaleData&) = delete;
  };

  /// A color, and the share of it that a finer scale gets.
  struct Passed {
    V3f color{0};
    float giving = 1;
  };

  /// A patch whose center lies in a repetition, and how much it counts at a texel.
  struct Entry {
    int patch;
    int64_t kx, ky;
    float weight;
  };

  /// The part of a block that one fragment has: its center in the infinite texture and in the tile, and its texels.
  struct Piece {
    Imath::Vec2<int64_t> center;
    V2i middle;
    float taking;
    int texels;
  };

  static float entry(const std::vector<float>& list, size_t i) { return list.empty() ? 1.0f : list[i]; }

  static std::vector<V3f> dominants_of(const ScaleTile& tile) {
    std::vector<V3f> colors;
    for (const ColorClass& c : tile.colors.palette.classes) colors.push_back(linear_from_luv(c.dominant));
    return colors;
  }
  static SmallTile with_base(const SmallTile& tile, Image<V3f> base) {
    return {std::move(base), {copy(tile.patches.partition)}, tile.contents};
  }
  static Partition copy(const Partition& p) { return {p.idx.clone(), p.owner.clone(), p.centers, p.areas_px}; }
  static V3f varied(const V3f& dominant, const V3f& color, float kept) {
    return kept == 1 ? color : dominant + (color - dominant) * kept;
  }
  template <class T>
  static std::vector<Image<T>> copies(const std::vector<Image<T>>& images) {
    std::vector<Image<T>> all;
    for (const Image<T>& image : images) all.push_back(image.clone());
    return all;
  }
  static Image<float> gains(const ScaleTile& t, const ScaleTransfer& how) {
    Image<float> gains(t.tile.base.width(), t.tile.base.height());
    for (size_t i = 0; i < gains.size(); ++i) gains.data()[i] = entry(how.detail_gains, t.colors.index.data()[i]);
    return gains;
  }
  static Image<V3f> with_noise_means(const SmallTile& tile) {
    Image<V3f> base = tile.base.clone();
    if (tile.noises.empty()) return base;
    const LevelPainter painter(tile, 0);
    for (size_t i = 0; i < base.size(); ++i) {
      Imath::V4f weights(0);
      for (size_t k = 0; k < tile.masks.size(); ++k) weights[static_cast<int>(k)] = tile.masks[k].data()[i];
      for (int c = 0; c < 3; ++c) {
        float& light = base.data()[i][c];
        light += static_cast<float>(painter.mean_change(static_cast<double>(light), c, weights));
      }
    }
    return base;
  }
  static Image<V3f> gained(const ScaleTile& t, const ScaleTransfer& how, const std::vector<V3f>& dominants,
                           const Image<V3f>& of) {
    Image<V3f> base = of.clone();
    for (size_t i = 0; i < base.size(); ++i) {
      const uint8_t k = t.colors.index.data()[i];
      base.data()[i] = varied(dominants[k], base.data()[i], entry(how.detail_gains, k));
    }
    return base;
  }
  static Image<V3f> dominant_base(const ScaleTile& t, const std::vector<V3f>& dominants) {
    Image<V3f> base(t.tile.base.width(), t.tile.base.height());
    for (size_t i = 0; i < base.size(); ++i) base.data()[i] = dominants[t.colors.index.data()[i]];
    return base;
  }
  /// Sums of so few floats are exact in double.
  static V3f mean(const Image<V3f>& base) {
    Imath::V3d sum(0);
    for (const V3f& color : base) sum += Imath::V3d(color);
    return V3f(sum / static_cast<double>(base.size()));
  }

  /// What the coarser color replaces where the texel `middle` of the tile shows.
  static V3f mean_of(const ScaleData& scale, V2i middle, float variation) {
    const V3f all = varied(scale.mean_of_dominants, scale.mean_of_all, variation);
    if (scale.transfer.detail_mean == DetailMean::tile) return all;
    const int ratio = scale.transfer.ratio;
    const V2i n = scale.tile.tile.size();
    Imath::V3d sum(0);
    for (int dy = 0; dy < ratio; ++dy)
      for (int dx = 0; dx < ratio; ++dx) {
        const V2i at = wrap(middle + V2i(dx - ratio / 2, dy - ratio / 2), n);
        sum += Imath::V3d(scale.mean_base(at.x, at.y));
      }
    return V3f(sum / (double{1} * ratio * ratio)) + (all - scale.mean_of_all);
  }

  /// The patches of a texel, its own first, then as the texels around bring them.
  static std::vector<Entry> entries_at(const ScaleData& scale, int64_t x, int64_t y) {
    const int border = std::max(scale.tile.tile.soft_border_px, 1);
    std::vector<Entry> entries = {owner_of(scale, x, y)};
    for (int dy = 1 - border; dy < border; ++dy)
      for (int dx = 1 - border; dx < border; ++dx) {
        const Entry near = owner_of(scale, x + dx, y + dy);
        const auto same = [&](const Entry& other) {
          return other.patch == near.patch && other.kx == near.kx && other.ky == near.ky;
        };
        const auto known = std::find_if(entries.begin(), entries.end(), same);
        Entry& entry = known == entries.end() ? entries.emplace_back(near) : *known;
        entry.weight += static_cast<float>((border - std::abs(dx)) * (border - std::abs(dy)));
      }
    for (Entry& entry : entries)
      entry.weight /= static_cast<float>(border * border) * static_cast<float>(border * border);
    return entries;
  }

  /// The patch of a texel, and the repetition of its center.
  static Entry owner_of(const ScaleData& scale, int64_t x, int64_t y) {
    const Partition& patches = scale.tile.tile.patches.partition;
    const V2i n = scale.tile.tile.size();
    const int64_t kx = Painter::floor_div(x, n.x), ky = Painter::floor_div(y, n.y);
    const V2i p(static_cast<int>(x - kx * n.x), static_cast<int>(y - ky * n.y));
    const OwnerOffset owner = patches.owner(p.x, p.y);
    return {static_cast<int>(patches.idx(p.x, p.y)), kx + owner.x, ky + owner.y, 0};
  }

  /// Sums of what patches show, by their weights, detail so much enlarged that it keeps its variance.
  static V3f shared(const ScaleData& scale, int64_t x, int64_t y, const std::vector<Entry>& entries, float variation) {
    float squares = 0;
    for (const Entry& entry : entries) squares += entry.weight * entry.weight;
    const auto contents = static_cast<float>(scale.tile.tile.contents.content_count);
    const float gain = 1 / std::sqrt(squares + (1 - squares) / (contents * contents));
    const auto sum_of = [&](const Image<V3f>& plane, const Image<V3f>& smooth) {
      V3f sum(0);
      for (const Entry& entry : entries) {
        const V3f mean = shown(scale, smooth, x, y, entry), all = shown(scale, plane, x, y, entry);
        sum += (mean + (all - mean) * gain) * entry.weight;
      }
      return sum;
    };
    V3f whole = sum_of(scale.gained_tile.base, scale.smooth_whole);
    scale.painter.add_noise(whole, gained_weights(scale, x, y), x, y);
    if (variation == 1) return whole;
    const V3f dominant = sum_of(scale.dominant_tile.base, scale.smooth_dominant);
    return variation == 0 ? dominant : dominant + (whole - dominant) * variation;
  }

  /// Of the noises at a texel, by its own patch: with its gain, in 1/2048.
  static Imath::V4f gained_weights(const ScaleData& scale, int64_t x, int64_t y) {
    const Painting own = scale.painter.paint(x, y, 1, 1);
    const V2i source = own.source(0, 0);
    const float gain = entry(scale.transfer.detail_gains, scale.tile.colors.index(source.x, source.y));
    Imath::V4f weights;
    for (int k = 0; k < 4; ++k) weights[k] = std::round(own.weights(0, 0)[k] * gain * 2048) / 2048;
    return weights;
  }

  static V2i way_from(const ScaleData& scale, int64_t x, int64_t y, const Entry& entry) {
    const V2i n = scale.tile.tile.size();
    const V2i c = scale.tile.tile.patches.partition.centers[static_cast<size_t>(entry.patch)];
    return {static_cast<int>(x - entry.kx * n.x - c.x), static_cast<int>(y - entry.ky * n.y - c.y)};
  }
  static const Content& content_of(const ScaleData& scale, const Entry& entry) {
    return scale.tile.tile.contents.at(entry.patch, scale.painter.content_of(entry.patch, entry.kx, entry.ky));
  }
  static V3f shown(const ScaleData& scale, const Image<V3f>& plane, int64_t x, int64_t y, const Entry& entry) {
    const V2i d = way_from(scale, x, y, entry);
    const V2i c = scale.tile.tile.patches.partition.centers[static_cast<size_t>(entry.patch)];
    return scale.painter.content_color(plane, content_of(scale, entry), c, d.x, d.y);
  }

  /// Where the fragment has its center that a patch shows at a texel: a turned content turns it back, by integers.
  static Piece piece_of(const ScaleData& scale, int64_t x, int64_t y, const Entry& entry) {
    const V2i n = scale.tile.tile.size(), d = way_from(scale, x, y, entry);
    const V2i c = scale.tile.tile.patches.partition.centers[static_cast<size_t>(entry.patch)];
    const Content& content = content_of(scale, entry);
    const V2i source = scale.painter.nearest_source(content, c, d.x, d.y);
    const Partition& fragments = scale.tile.fragments.partition;
    const uint32_t fragment = fragments.idx(source.x, source.y);
    const OwnerOffset owner = fragments.owner(source.x, source.y);
    const V2i way = fragments.centers[fragment] + V2i(owner.x * n.x, owner.y * n.y) - source;
    const uint32_t class_idx = scale.tile.fragments.fragments[fragment].class_idx;
    Piece piece{
        {x + way.x, y + way.y}, wrap(source + way, n), StackPainter::entry(scale.transfer.weights, class_idx), 1};
    if (content.a == 65536 && content.b == 0) return piece;

    const int64_t cx = entry.kx * n.x + c.x, cy = entry.ky * n.y + c.y;
    const int64_t a = content.a, b = content.b;
    const auto lambda = static_cast<int64_t>(content.scale * 65536);
    const int64_t ux = Painter::floor_div(a * d.x - b * d.y + 32768, 65536) + way.x;
    const int64_t uy = Painter::floor_div(b * d.x + a * d.y + 32768, 65536) + way.y;
    const int64_t square = Painter::floor_div((lambda / 2) * (lambda / 2), 32768);
    const int64_t back_a = Painter::floor_div(Painter::floor_div(a, 4) * square, 32768);
    const int64_t back_b = Painter::floor_div(Painter::floor_div(b, 4) * square, 32768);
    piece.center = {cx + Painter::floor_div(back_a * ux + back_b * uy + 8192, 16384),
                    cy + Painter::floor_div(back_a * uy - back_b * ux + 8192, 16384)};
    return piece;
  }

  Passed stacked(int finest, int64_t x, int64_t y, float variation) const {
    Passed passed;
    V3f mean(0);
    float weight = 1, share = variation;
    for (int s = finest; s >= 0; --s) {
      const ScaleData& scale = scales_[static_cast<size_t>(s)];
      const Painting own = scale.painter.paint(x, y, 1, 1);
      const V2i source = own.source(0, 0);
      const uint8_t k = scale.tile.colors.index(source.x, source.y);
      const std::vector<Entry> entries = entries_at(scale, x, y);
      const V3f color = entries.size() > 1 ? shared(scale, x, y, entries, share)
                                           : varied(scale.dominants[k], own.color(0, 0),
                                                    share * entry(scale.transfer.detail_gains, k));
      const float giving = entry(scale.giving, k);
      if (s == finest) {
        passed = {color, giving};
      } else {
        weight *= giving;
        passed.color += (color - mean) * weight;
      }
      if (s == 0) break;
      const Piece piece = piece_of(scale, x, y, entries[0]);
      weight *= piece.taking;
      mean = mean_of(scale, piece.middle, share);
      share = 1;
      x = Painter::floor_div(piece.center.x, scale.transfer.ratio);
      y = Painter::floor_div(piece.center.y, scale.transfer.ratio);
    }
    return passed;
  }

  /// The fragments that some texels of the finest scale show, each once, as the texels bring them.
  std::vector<Piece> pieces(int64_t left, int64_t top, const std::vector<V2i>& texels) const {
    std::vector<Piece> found;
    for (const V2i& p : texels) {
      const int64_t x = left + p.x, y = top + p.y;
      const Piece piece = piece_of(scales_.back(), x, y, owner_of(scales_.back(), x, y));
      const auto same = [&](const Piece& other) {
        return other.center == piece.center && other.middle == piece.middle;
      };
      const auto known = std::find_if(found.begin(), found.end(), same);
      if (known == found.end())
        found.push_back(piece);
      else
        ++known->texels;
    }
    return found;
  }

  /// Between the four blocks of a side around a point.
  template <class Block>
  static V3f between(int64_t x_256, int64_t y_256, int64_t side_256, const Block& block) {
    const int64_t u = x_256 - side_256 / 2, v = y_256 - side_256 / 2;
    const int64_t x = Painter::floor_div(u, side_256), y = Painter::floor_div(v, side_256);
    const auto weight = [&](int64_t rest) { return static_cast<double>(rest * 256 / side_256) / 256; };
    return Painter::blend(block(x, y), block(x + 1, y), block(x, y + 1), block(x + 1, y + 1), weight(u - x * side_256),
                          weight(v - y * side_256));
  }

  std::deque<ScaleData> scales_;  // coarse to fine; they refer to parts of themselves, and stay where they are
};

}  // namespace texbake
