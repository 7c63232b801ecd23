#include "libbake/report/report_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libbake/color/luv.h"
#include "libbake/content/shown_source.h"
#include "libbake/draw/show.h"
#include "libbake/draw/window_rows.h"
#include "libbake/quality/low_pass.h"
#include "libbake/quality/repetition.h"

namespace texbake {
namespace {

constexpr int kWindowPx = 384;  // near pictures
constexpr int kFarPx = 384;     // longest side of a rendering seen from afar
constexpr int kPartPx = 512;    // longest side of a drawing of the tile
constexpr int kLargePx = 1024;  // longest side of the large window
constexpr int kLargeTiles = 4;
constexpr int kContentPx = 160;  // longest side of one content of a patch
constexpr int kMaxContents = 8;

// The least factor that divides both sides and leaves none above `largest`; rows and columns beyond are left out where
// nothing divides.
Image<V3f> at_most(ImageView<const V3f> image, int largest) {
  const int factor = (std::max(image.width(), image.height()) + largest - 1) / largest;
  return reduce(image, std::max(factor, 1));
}

Image<V3f> crop(ImageView<const V3f> image, V2i from, V2i size) {
  Image<V3f> part(size.x, size.y);
  for (int y = 0; y < size.y; ++y) std::copy_n(image.row(from.y + y) + from.x, size.x, part.row(y));
  return part;
}

// A window drawn by strips and reduced as it is drawn.
Image<V3f> reduced_window(const EvaluatorPlanes& planes, V2i size, int factor) {
  Window window;
  window.width = size.x / factor * factor;
  window.height = size.y / factor * factor;
  window.filter = Filter::nearest;
  Image<V3f> picture(window.width / factor, window.height / factor);
  for (int y = 0; y < picture.height(); ++y) {
    const Image<V3f> row = reduce(render_rows(planes, window, y * factor, (y + 1) * factor), factor);
    std::copy(row.begin(), row.end(), picture.row(y));
  }
  return picture;
}

ReportPicture shown(const EvaluatorPlanes& planes, Show show, V2i tiles, const std::string& caption,
                    PictureGroup group = PictureGroup::parts) {
  Window window;
  const int longest = std::max(planes.size.x * tiles.x, planes.size.y * tiles.y);
  const int step = std::max((longest + kPartPx - 1) / kPartPx, 1);
  window.step_256 = static_cast<uint32_t>(step) * 256;
  window.width = planes.size.x * tiles.x / step;
  window.height = planes.size.y * tiles.y / step;
  window.filter = Filter::nearest;
  const bool is_drawing = group == PictureGroup::parts;
  return {group, caption, show_rows(planes, window, show, 0, window.height), is_drawing};
}

// One patch filled with each of its contents, what surrounds it dimmed: side by side.
ReportPicture contents_picture(const EvaluatorInput& tile) {
  const Partition& patches = tile.patches->partition;
  const auto largest = std::max_element(patches.areas_px.begin(), patches.areas_px.end());
  const auto patch = static_cast<int>(largest - patches.areas_px.begin());
  const int count = std::min(tile.contents->content_count, kMaxContents);
  const V2i size(tile.base.width(), tile.base.height());
  // A square around the center that holds every patch of usual shape.
  const int half = std::min({static_cast<int>(std::sqrt(static_cast<double>(*largest))), size.x / 2, size.y / 2});
  const int step = std::max((2 * half + kContentPx - 1) / kContentPx, 1);
  const int side = std::max(2 * half / step, 1);
  Image<V3f> strip(count * side + (count - 1) * 4, side, V3f(1.0f));
  const V2i center = patches.centers[static_cast<size_t>(patch)];
  for (int c = 0; c < count; ++c) {
    const Content& content = tile.contents->at(patch, c);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const V2i p = wrap(center + V2i(x * step - half, y * step - half), size);
        const bool inside = patches.idx(p.x, p.y) == static_cast<uint32_t>(patch);
        const V2i source = inside ? shown_source(patches, static_cast<uint32_t>(patch), p, content) : p;
        strip(c * (side + 4) + x, y) = tile.base(source.x, source.y) * (inside ? 1.0f : 0.25f);
      }
  }
  return {PictureGroup::parts,
          fmt::format("What may fill patch {}, the largest: its own content and {} more; its neighbors are dimmed",
                      patch, tile.contents->content_count - 1),
          std::move(strip), false};
}

// A spectrum in gray, DC in the middle.
ReportPicture spectrum_picture(ImageView<const float> spectrum, size_t number) {
  const V2i size(spectrum.width(), spectrum.height());
  const float largest = std::max(*std::max_element(spectrum.begin(), spectrum.end()), 1e-20f);
  Image<V3f> picture(size.x, size.y);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      picture(x, y) = V3f(std::sqrt(spectrum((x + size.x / 2) % size.x, (y + size.y / 2) % size.y) / largest));
  return {PictureGroup::layers, fmt::format("Spectrum of noise {}, its first channel", number), std::move(picture),
          true};
}

void add_layers(const EvaluatorPlanes& planes, const std::vector<ImageView<const float>>& spectra,
                std::vector<ReportPicture>& pictures) {
  if (planes.noise_step == 0) return;
  pictures.push_back(shown(planes, Show::structure, {1, 1}, "The structure only", PictureGroup::layers));
  pictures.push_back(shown(planes, Show::noise, {1, 1}, "The noise only, around middle gray", PictureGroup::layers));
  pictures.push_back(shown(planes, Show::masks, {1, 1}, "Masks: where each noise occurs", PictureGroup::layers));
  for (size_t i = 0; i < spectra.size(); ++i) pictures.push_back(spectrum_picture(spectra[i], i));
}

}  // namespace

std::vector<ReportPicture> bundle_pictures(const EvaluatorInput& tile, const EvaluatorPlanes& planes,
                                           ImageView<const V3f> exemplar,
                                           const std::vector<ImageView<const float>>& spectra) {
  std::vector<ReportPicture> pictures;
  pictures.push_back({PictureGroup::overview,
                      fmt::format("The exemplar's tile, {} × {} texels", planes.size.x, planes.size.y),
                      at_most(exemplar.empty() ? tile.base : exemplar, kPartPx), false});
  const V2i large(planes.size.x * kLargeTiles, planes.size.y * kLargeTiles);
  const int factor = std::max((std::max(large.x, large.y) + kLargePx - 1) / kLargePx, 1);
  pictures.push_back(
      {PictureGroup::overview,
       fmt::format("{} × {} texels of the infinite texture: {} × {} tiles", large.x, large.y, kLargeTiles, kLargeTiles),
       reduced_window(planes, large, factor), false});
  if (!planes.dominant.empty())
    pictures.push_back(shown(planes, Show::index, {1, 1}, "Palette: the class of each texel"));
  if (!planes.fragment_idx.empty()) pictures.push_back(shown(planes, Show::fragments, {1, 1}, "Fragments"));
  if (tile.patches) pictures.push_back(shown(planes, Show::patches, {1, 1}, "Patches"));
  if (tile.patches && tile.contents) {
    pictures.push_back(
        shown(planes, Show::contents, {3, 3}, "Contents of 3 × 3 tiles; gray marks the patch's own content"));
    pictures.push_back(contents_picture(tile));
  }
  add_layers(planes, spectra, pictures);
  return pictures;
}

std::vector<ReportPicture> rendering_pictures(std::string_view name, ImageView<const V3f> rendering_luv, V2i tile) {
  const V2i size(std::min(rendering_luv.width(), kWindowPx), std::min(rendering_luv.height(), kWindowPx));
  // Where four tiles meet, in the middle of the window.
  const V2i from(std::clamp(tile.x - size.x / 2, 0, rendering_luv.width() - size.x),
                 std::clamp(tile.y - size.y / 2, 0, rendering_luv.height() - size.y));
  std::vector<ReportPicture> pictures;
  pictures.push_back({PictureGroup::near, std::string(name), linear_from_luv(crop(rendering_luv, from, size)), false});
  pictures.push_back({PictureGroup::far, std::string(name), linear_from_luv(at_most(rendering_luv, kFarPx)), false});
  return pictures;
}

ReportPicture seam_picture(ImageView<const V3f> tile_luv, const RenderingSources& sources) {
  const Image<SeamTexel> seams =
      seam_texels(tile_luv, sources.source, {sources.shape, Adjacency::torus, sources.shown});
  const V2i size(std::min(seams.width(), 2 * kWindowPx), std::min(seams.height(), 2 * kWindowPx));
  Image<V3f> picture(size.x, size.y);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const V2i source = sources.source(x, y);
      const float lightness = tile_luv(source.x, source.y).x / 100.0f;
      picture(x, y) = V3f(lightness * lightness);
      if (seams(x, y) == SeamTexel::hidden) picture(x, y) = V3f(0.02f, 0.25f, 1.0f);
      if (seams(x, y) == SeamTexel::visible) picture(x, y) = V3f(1.0f, 0.03f, 0.02f);
    }
  return {PictureGroup::seams, "Seams over the grayed texture: blue where they are hidden, red where they stand out",
          std::move(picture), false};
}

ReportPicture repetition_picture(ImageView<const V3f> rendering_luv, V2i tile) {
  const Image<float> map = repetition_map(rendering_luv, tile);
  const int factor = std::max((std::max(map.width(), map.height()) + kPartPx - 1) / kPartPx, 1);
  Image<V3f> picture(map.width() / factor, map.height() / factor);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      // Black, red, yellow, white.
      const float share = 3.0f * map(x * factor, y * factor);
      picture(x, y) = V3f(std::clamp(share, 0.0f, 1.0f), std::clamp(share - 1.0f, 0.0f, 1.0f),
                          std::clamp(share - 2.0f, 0.0f, 1.0f));
    }
  return {PictureGroup::seams,
          "Repetition over the tile: black where what is shown changes from tile to tile, white where it is always the "
          "same",
          std::move(picture), false};
}

}  // namespace texbake
