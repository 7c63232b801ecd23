// How far levels of detail are from the box means of the infinite texture: those of this library beside two that other
// implementations draw.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "libbake/base/parallel.h"
#include "libbake/base/torus.h"
#include "libbake/planes/program_of.h"

namespace texbake {

/// Differences of blocks from the box means of their texels, over all blocks and color channels, in units of the
/// values.
struct LevelError {
  double signed_mean = 0;  ///< below 0: darker
  double mean = 0;         ///< of magnitudes
  double worst = 0;
};

struct LevelBias {
  int level = 1;
  LevelError unbiased;   ///< shares of patches, as add_levels makes them
  LevelError cheap;      ///< box means of the tile, read where the content of a block's center says
  LevelError truncated;  ///< box means of box means, each rounded down to a 255th, as 8-bit mip chains are made
};

namespace level_bias {

using glsl::Program;
using glsl::Texel;
using glsl::vec4;
using Imath::V3d;

inline V3d color_of(const vec4& v) { return {double{v.x}, double{v.y}, double{v.z}}; }

/// Means of 2 × 2 neighbors; an odd last row or column is left out.
inline Image<Imath::V3d> halved(const Image<Imath::V3d>& finer) {
  Image<Imath::V3d> coarser(finer.width() / 2, finer.height() / 2);
  for (int y = 0; y < coarser.height(); ++y)
    for (int x = 0; x < coarser.width(); ++x)
      coarser(x, y) =
          (finer(2 * x, 2 * y) + finer(2 * x + 1, 2 * y) + finer(2 * x, 2 * y + 1) + finer(2 * x + 1, 2 * y + 1)) *
          0.25;
  return coarser;
}

/// Levels at which both sides are halved, as mip chains are.
inline int halvings_of(V2i size) {
  int count = 0;
  while ((size.x | size.y) % (2 << count) == 0) ++count;
  return count;
}

constexpr double kCodes = 255;

/// In codes, so that a whole number of them stays one.
inline void truncate(Image<V3d>& codes) {
  for (V3d& c : codes)
    for (int channel = 0; channel < 3; ++channel) c[channel] = std::floor(c[channel]);
}

/// Sums of differences, added in a fixed order.
struct Sums {
  double signed_sum = 0, sum = 0, worst = 0;
  uint64_t count = 0;

  void add(const V3d& found, const V3d& truth) {
    for (int c = 0; c < 3; ++c) {
      const double d = found[c] - truth[c];
      signed_sum += d;
      sum += std::abs(d);
      worst = std::max(worst, std::abs(d));
      ++count;
    }
  }
  LevelError error() const {
    const auto n = static_cast<double>(count);
    return {signed_sum / n, sum / n, worst};
  }
};

struct LevelSums {
  Sums unbiased, cheap, truncated;
};

/// One plane of the planes, read as the text reads it.
class Reader {
 public:
  Reader(const EvaluatorPlanes& planes, const Plane& plane, uint32_t seed)
      : planes_(planes),
        program_(program_of(planes, seed)),
        texels_(sampler_of(plane.texels)),
        levels_(sampler_of(plane.level_values)),
        kind_(plane_kind(plane.kind)) {
    mips_.push_back(Image<V3d>(planes.size.x, planes.size.y));
    for (size_t i = 0; i < mips_[0].size(); ++i) mips_[0].data()[i] = color_of(plane.texels.data()[i]);
    for (int level = 1; level <= halvings_of(planes.size); ++level) mips_.push_back(halved(mips_.back()));
  }

  V3d block(const Texel& block, int level) {
    return color_of(program_.block_value(texels_, kind_, levels_, block, program_.grid_of(level)));
  }

  /// The tile's own box mean, between the four nearest, where the content of the block's center is taken from.
  V3d cheap(const Texel& block, int level) {
    const int half = (1 << level) / 2;
    const glsl::Source source =
        program_.texel_source({block.tile, {(block.p.x << level) + half, (block.p.y << level) + half}});
    const Image<V3d>& mip = mips_[static_cast<size_t>(level)];
    const double side = 1 << level;
    const double u = source.nearest.x / side - 0.5, v = source.nearest.y / side - 0.5;
    const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
    const auto at = [&](int i, int j) { return mip(wrap(x + i, mip.width()), wrap(y + j, mip.height())); };
    const auto lerp = [](const V3d& a, const V3d& b, double w) { return a + (b - a) * w; };
    return lerp(lerp(at(0, 0), at(1, 0), u - x), lerp(at(0, 1), at(1, 1), u - x), v - y);
  }

  /// Box means of one repetition, level by level.
  void add(glsl::uvec2 tile, std::vector<LevelSums>& sums) {
    Image<V3d> truth(planes_.size.x, planes_.size.y);
    parallel_for(0, truth.height(), [&](int y) {
      Reader row(*this);
      for (int x = 0; x < truth.width(); ++x) truth(x, y) = row.block({tile, {x, y}}, 0);
    });
    Image<V3d> codes = truth.clone();
    for (V3d& c : codes) c *= kCodes;
    truncate(codes);
    for (int level = 1; level <= halvings_of(planes_.size); ++level) {
      truth = halved(truth);
      codes = halved(codes);
      truncate(codes);
      LevelSums& sum = sums[static_cast<size_t>(level - 1)];
      for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x) {
          const Texel at{tile, {x, y}};
          sum.unbiased.add(block(at, level), truth(x, y));
          sum.cheap.add(cheap(at, level), truth(x, y));
          sum.truncated.add(codes(x, y) / kCodes, truth(x, y));
        }
    }
  }

 private:
  Reader(const Reader& other)
      : planes_(other.planes_),
        program_(other.program_),
        texels_(other.texels_),
        levels_(other.levels_),
        kind_(other.kind_) {}

  const EvaluatorPlanes& planes_;
  Program program_;
  glsl::sampler2D texels_, levels_;
  int kind_;
  std::vector<Image<V3d>> mips_;
};

}  // namespace level_bias

/// Levels 1 … of `plane`, whose levels were added, while both sides are halved, over `repetitions` × `repetitions` of
/// the tile.
inline std::vector<LevelBias> level_biases(const EvaluatorPlanes& planes, const Plane& plane, uint32_t seed,
                                           int repetitions) {
  std::vector<level_bias::LevelSums> sums(static_cast<size_t>(level_bias::halvings_of(planes.size)));
  level_bias::Reader reader(planes, plane, seed);
  for (uint32_t y = 0; y < static_cast<uint32_t>(repetitions); ++y)
    for (uint32_t x = 0; x < static_cast<uint32_t>(repetitions); ++x) reader.add({x, y}, sums);
  std::vector<LevelBias> biases;
  for (const level_bias::LevelSums& sum : sums)
    biases.push_back(
        {static_cast<int>(biases.size()) + 1, sum.unbiased.error(), sum.cheap.error(), sum.truncated.error()});
  return biases;
}

}  // namespace texbake
