#include "libbake/content/far_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libbake/base/gaussian.h"
#include "libbake/content/choice_figures.h"
#include "libbake/content/shown_source.h"
#include "tests/libbake/content/content_twin.h"

namespace texbake {
namespace {

constexpr int kFarSize = 256;
constexpr int kCell = 8;  // 32 cells along a side, of eight pieces each: a piece is a texel
constexpr int kCells = kFarSize / kCell;
constexpr double kSigma = kCells / 16.0;

Image<V3f> grain_on_a_wave() {
  Image<V3f> image(kFarSize, kFarSize);
  Random random(3);
  for (V3f& c : image) c = V3f(40.0f + 20.0f * random.uniform(), 10.0f * random.uniform(), 0.0f);
  for (int y = 0; y < kFarSize; ++y)
    for (int x = 0; x < kFarSize; ++x)
      image(x, y).z = 10.0f * static_cast<float>(std::sin(2.0 * M_PI * (x + 2 * y) / kFarSize));
  return image;
}

Partition some_patches(int count) { return twin::partition(twin::random_patches(kFarSize, kFarSize, count, 5), count); }

// The obvious way: the picture less the tile's mean, its cells' means, blurred.
Image<V3f> seen_from_afar(const Image<V3f>& picture, const Image<V3f>& tile) {
  double mean[3] = {};
  for (const V3f& c : tile)
    for (int i = 0; i < 3; ++i) mean[i] += static_cast<double>(c[i]) / static_cast<double>(tile.size());
  const V3f m(static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2]));
  Image<V3f> cells(kCells, kCells, V3f(0));
  for (int y = 0; y < kFarSize; ++y)
    for (int x = 0; x < kFarSize; ++x) cells(x / kCell, y / kCell) += (picture(x, y) - m) / float(kCell * kCell);
  return gaussian_blur(cells, kSigma, Wrap::repeat);
}

double energy(const Image<V3f>& picture) {
  double sum = 0.0;
  for (const V3f& c : picture) sum += static_cast<double>(c.length2());
  return sum;
}

// What the tile shows where every patch P has the content contents[P].
Image<V3f> picture_of(const Image<V3f>& tile, const Partition& patches, const std::vector<Content>& contents) {
  Image<V3f> picture(kFarSize, kFarSize);
  for (int y = 0; y < kFarSize; ++y)
    for (int x = 0; x < kFarSize; ++x) {
      const uint32_t patch = patches.idx(x, y);
      const V2i source = shown_source(patches, patch, {x, y}, contents[patch]);
      picture(x, y) = tile(source.x, source.y);
    }
  return picture;
}

TEST(FarView, SeesWhatTheObviousPictureShows) {
  const Image<V3f> tile = grain_on_a_wave();
  const Partition patches = some_patches(7);
  const FarView view(tile, patches);
  std::vector<Content> contents;
  FarField whole = view.blank();
  double share = 0.0;
  for (uint32_t patch = 0; patch < 7; ++patch) {
    contents.push_back(make_content({static_cast<int>(37 * patch), -static_cast<int>(11 * patch)}, 0, 1.0f));
    view.add(view.shown(patch, contents.back()), whole);
    share += view.share_of(patch);
  }
  EXPECT_NEAR(share, 1.0, 1e-9);
  const double expected = energy(seen_from_afar(picture_of(tile, patches, contents), tile));
  EXPECT_NEAR(view.energy(whole), expected, 1e-4 * expected);  // float sums
  const double own = energy(seen_from_afar(tile, tile));
  EXPECT_NEAR(view.tile_energy(), own, 1e-4 * own);
}

TEST(FarView, BlursTwiceAcrossTheBordersOfTheTile) {
  const Image<V3f> tile = grain_on_a_wave();
  const Partition patches = some_patches(1);
  const FarView view(tile, patches);
  FarField whole = view.blank();
  view.add(view.shown(0, Content{}), whole);
  Image<V3f> cells(kCells, kCells);
  std::copy(whole.colors.begin(), whole.colors.end(), cells.begin());
  const Image<V3f> twice = gaussian_blur(gaussian_blur(cells, kSigma, Wrap::repeat), kSigma, Wrap::repeat);

  FarField part{{kCells - 3, kCells - 2}, {7, 5}, std::vector<V3f>(35)};
  part = view.blurred_twice(whole, part);
  for (int y = 0; y < part.extent.y; ++y)
    for (int x = 0; x < part.extent.x; ++x) {
      const V2i at = wrap(part.first + V2i(x, y), {kCells, kCells});
      const V3f found = part.colors[static_cast<size_t>(y * part.extent.x + x)];
      EXPECT_LT((found - twice(at.x, at.y)).length(), 1e-4f) << x << ' ' << y;  // float sums of values up to 10
    }
}

TEST(FarView, KeepsALongWaveAndDropsAShortOne) {
  const auto energy_of = [](double length_px, FarBlur blur) {
    Image<V3f> image(kFarSize, kFarSize);
    for (int y = 0; y < kFarSize; ++y)
      for (int x = 0; x < kFarSize; ++x)
        image(x, y) = V3f(50.0f + 10.0f * static_cast<float>(std::cos(2.0 * M_PI * x / length_px)), 0, 0);
    const Partition patches = some_patches(1);
    return FarView(image, patches).tile_energy(blur) / (kCells * kCells);
  };
  // A Gaussian of σ = 16 px leaves exp(−2π²σ²/λ²) of a wave's amplitude: 0.926 at 256 px, 0.0072 at 32 px. The mean
  // of its square is half the amplitude's. 3 %: cells of 8 px and a kernel cut at 3 σ.
  EXPECT_NEAR(energy_of(256, FarBlur::far), 0.5 * std::pow(10 * 0.926, 2), 0.03 * 43);
  EXPECT_LT(energy_of(32, FarBlur::far), 0.5 * std::pow(10 * 0.01, 2));
  // σ = 32 px: 0.735.
  EXPECT_NEAR(energy_of(256, FarBlur::farther), 0.5 * std::pow(10 * 0.735, 2), 0.03 * 27);
}

TEST(FarView, ForetellsTheRepetitionOfAllPicturesThatCanBeDrawn) {
  // Three patches of two contents: eight pictures, all as probable. G is what their mean keeps of their energy. Patches
  // wrap around the tile, so that the part of a patch seen beyond the border is its own: as FarView counts.
  const Image<V3f> tile = grain_on_a_wave();
  const Partition patches = some_patches(3);
  const ContentTable table = twin::table(3, {V2i(0, 0), V2i(90, 40)});
  Image<V3f> mean(kCells, kCells, V3f(0));
  double all = 0.0;
  for (uint32_t draw = 0; draw < 8; ++draw) {
    std::vector<Content> contents;
    for (uint32_t patch = 0; patch < 3; ++patch)
      contents.push_back(table.of(static_cast<int>(patch))[draw >> patch & 1u]);
    const Image<V3f> seen = seen_from_afar(picture_of(tile, patches, contents), tile);
    for (size_t i = 0; i < mean.size(); ++i) mean.data()[i] += seen.data()[i] / 8.0f;
    all += energy(seen) / 8.0;
  }
  EXPECT_NEAR(choice_figures(table, tile, patches).repetition_far, energy(mean) / all, 1e-3);  // float sums
}

TEST(FarView, HasAtMostAbout32CellsAlongTheShorterSide) {
  const auto cells = [](int width, int height) {
    const Partition patches = twin::partition(Image<uint32_t>(width, height), 1);
    return FarView(Image<V3f>(width, height), patches).blank().extent;
  };
  EXPECT_EQ(cells(512, 256), V2i(64, 32));
  EXPECT_EQ(cells(300, 211), V2i(45, 32));  // 32 · 300 / 211 = 45.497
  EXPECT_EQ(cells(20, 15), V2i(20, 15));
}

}  // namespace
}  // namespace texbake
