#include "libbake/noise/decompose.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "libbake/base/error.h"
#include "libbake/base/half.h"
#include "libbake/noise/structure.h"
#include "tests/libbake/noise/synthetic_field.h"

namespace texbake {
namespace {

/// A disc of ring noise on a ground of blob noise, their levels 0.1 apart, and what is known of it.
struct Field {
  explicit Field(int size) : exemplar(size, size), structure(size, size), disc(size, size) {
    constexpr double kDeviation = 0.063;
    const Image<float> ring = synthetic_noise(ring_power, size, kDeviation * kDeviation, 1);
    const Image<float> blob = synthetic_noise(blob_power, size, kDeviation * kDeviation, 2);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const int dx = x - size / 2;
        const int dy = y - size / 2;
        disc(x, y) = dx * dx + dy * dy < size * size / 7 ? 1 : 0;
        structure(x, y) = disc(x, y) ? 0.55f : 0.45f;
        exemplar(x, y) = half_exact(V3f(structure(x, y) + (disc(x, y) ? ring(x, y) : blob(x, y))));
      }
  }
  Image<V3f> exemplar;
  Image<float> structure;
  Image<uint8_t> disc;
};

/// Texels within `reach` of one on the other side.
bool near_border(const Image<uint8_t>& disc, int x, int y, int reach) {
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx)
      if (dx * dx + dy * dy <= reach * reach &&
          disc(wrap(x + dx, disc.width()), wrap(y + dy, disc.height())) != disc(x, y))
        return true;
  return false;
}

DecomposeOptions at(int local_size, int noises = 2) {
  DecomposeOptions options;
  options.space = NoiseSpace::linear;  // of the known fields
  options.noises = noises;
  options.local_size = local_size;
  options.second_pass = SecondPass::never;
  return options;
}

constexpr int kSize = 512;

/// Large spectra average most, small ones tell exactly where one noise ends.
const Decomposition& split() {
  static const Decomposition found = [] {
    DecomposeOptions options = at(16);
    options.mask_size = 2;
    return decompose(Field(kSize).exemplar, options);
  }();
  return found;
}

TEST(Decompose, FindsKnownRegions) {
  const Field field(kSize);
  const Decomposition& found = split();
  // The disc is brighter: dark noise comes first.
  int right = 0;
  int at_border = 0;
  int right_at_border = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const int good = (found.masks[1](x, y) > 0.5f) == (field.disc(x, y) == 1) ? 1 : 0;
      right += good;
      if (near_border(field.disc, x, y, 4)) {
        ++at_border;
        right_at_border += good;
      }
    }
  EXPECT_GE(right / double(kSize * kSize), 0.96);
  EXPECT_GE(right_at_border / double(at_border), 0.80);
}

TEST(Decompose, FindsKnownStructure) {
  const Field field(kSize);
  const Image<V3f>& structure = split().structure;
  double squares = 0.0;
  for (size_t i = 0; i < structure.size(); ++i) {
    const double error = double(structure.data()[i].x) - double(field.structure.data()[i]);
    squares += error * error;
  }
  EXPECT_LE(std::sqrt(squares / double(structure.size())), 0.025);  // the exemplar's own is 0.063
}

TEST(Decompose, MasksMayHaveASizeOfTheirOwn) {
  const Field field(64);
  DecomposeOptions options = at(8);
  options.mask_size = 2;
  const Decomposition mixed = decompose(field.exemplar, options);
  EXPECT_TRUE(mixed.structure == decompose(field.exemplar, at(8)).structure);
  EXPECT_TRUE(mixed.masks[0] == decompose(field.exemplar, at(2)).masks[0]);
}

TEST(Decompose, StructureIsHalfExactAndNoiseIsTheRest) {
  const Field field(64);
  const Decomposition found = decompose(field.exemplar, at(4));
  const Image<V3f> noise = noise_layer(field.exemplar, found.structure, NoiseSpace::linear);
  for (size_t i = 0; i < noise.size(); ++i) {
    EXPECT_EQ(half_exact(found.structure.data()[i]), found.structure.data()[i]);
    EXPECT_EQ(half_exact(found.structure.data()[i] + noise.data()[i]), field.exemplar.data()[i]);
  }
}

TEST(Decompose, InTheRootItFindsWhatItFindsInLight) {
  // The square of a picture in the root is the picture in light, but for half floats: of the pictures 2^-11, of the
  // structure 2^-12 of the root.
  const Field field(64);
  const Decomposition in_light = decompose(field.exemplar, at(4));
  DecomposeOptions options = at(4);
  options.space = NoiseSpace::root;
  const Decomposition in_root = decompose(to_light(field.exemplar, NoiseSpace::root), options);
  const Image<V3f> structure = in_noise_space(in_root.structure, NoiseSpace::root);
  for (size_t i = 0; i < structure.size(); ++i)
    EXPECT_NEAR(structure.data()[i].x, in_light.structure.data()[i].x, 0x1p-11f);
  EXPECT_NEAR(in_root.noise_share, in_light.noise_share, 1e-3);
  EXPECT_TRUE(in_root.masks[0] == in_light.masks[0]);
}

TEST(Decompose, ChoosesASizeAndTriesThemAll) {
  const Field field(64);
  DecomposeOptions options;
  options.noises = 2;
  const Decomposition found = decompose(field.exemplar, options);
  ASSERT_EQ(found.tested.size(), 4u);
  EXPECT_EQ(found.local_size.local_size, choose_local_size(found.tested).local_size);
  EXPECT_FALSE(found.local_size.reason.empty());
}

TEST(Decompose, SharpBordersCostOneMask) {
  const Field field(64);
  DecomposeOptions options = at(4);
  options.sharp_border_px = 2;
  const Decomposition found = decompose(field.exemplar, options);
  ASSERT_EQ(found.masks.size(), 3u);
  for (size_t i = 0; i < found.structure.size(); ++i)
    if (found.masks[2].data()[i] == 1.0f) {
      EXPECT_EQ(found.structure.data()[i], field.exemplar.data()[i]);
    }
  options.noises = kMaxNoises;
  EXPECT_THROW(decompose(field.exemplar, options), Error);
}

/// Wavy lines: coherent, and far from Gaussian.
Image<V3f> wavy_lines() {
  const Image<float> bend = synthetic_noise(blob_power, 96, 16.0, 5);
  Image<V3f> lines(96, 96);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x)
      lines(x, y) = half_exact(V3f(wrap(static_cast<int>(std::lround(float(x) + bend(x, y))), 16) < 2 ? 0.2f : 0.6f));
  return lines;
}

TEST(Decompose, TheToleranceIsHalvedWhereLinesWouldBeTakenForGrain) {
  EXPECT_EQ(split().sigma, 0.01f) << "Gaussian";
  DecomposeOptions options = at(4, 1);
  const Decomposition lines = decompose(wavy_lines(), options);
  EXPECT_EQ(lines.sigma, 0.005f);
  options.sigma = 0.01f;
  const Decomposition asked = decompose(wavy_lines(), options);
  EXPECT_EQ(asked.sigma, 0.01f);
  EXPECT_LT(lines.noise_share, asked.noise_share);
  EXPECT_LT(lines.result.coherence_drop, asked.result.coherence_drop);
}

TEST(Decompose, ASecondPassRunsWhereLinesWereTakenForGrain) {
  const Image<V3f> lines = wavy_lines();
  DecomposeOptions options;
  options.noises = 1;
  options.local_size = 8;
  const Decomposition once = decompose(lines, at(8, 1));
  const Decomposition twice = decompose(lines, options);
  EXPECT_FALSE(once.second_pass);
  ASSERT_GT(once.result.coherence_drop, kStructureInNoise);
  EXPECT_FALSE(once.warnings.empty());
  EXPECT_TRUE(twice.second_pass);
  EXPECT_LT(twice.noise_share, once.noise_share);
}

TEST(Decompose, DoesNotDependOnThreads) {
  const Field field(64);
  const Decomposition many = decompose(field.exemplar, at(4, 3));
  tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Decomposition single = decompose(field.exemplar, at(4, 3));
  EXPECT_TRUE(many.structure == single.structure);
  for (size_t k = 0; k < 3; ++k) EXPECT_TRUE(many.masks[k] == single.masks[k]);
}

TEST(Decompose, RefusesWhatItCannotSplit) {
  const auto kind = [](const Image<V3f>& exemplar, const DecomposeOptions& options) {
    try {
      decompose(exemplar, options);
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::limit;
  };
  EXPECT_EQ(kind(Image<V3f>(64, 64, V3f(0.5f)), {}), ErrorKind::infeasible);  // constant
  EXPECT_EQ(kind(Field(24).exemplar, at(16)), ErrorKind::infeasible);         // smaller than two windows
  EXPECT_EQ(kind(Field(64).exemplar, at(5)), ErrorKind::usage);
  EXPECT_EQ(kind(Field(64).exemplar, at(4, 9)), ErrorKind::usage);
  // A checkerboard has one local spectrum everywhere.
  Image<V3f> board(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) board(x, y) = V3f((x + y) % 2 == 0 ? 0.25f : 0.75f);
  EXPECT_EQ(kind(board, at(4, 2)), ErrorKind::infeasible);
}

}  // namespace
}  // namespace texbake
