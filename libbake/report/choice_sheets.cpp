#include "libbake/report/choice_sheets.h"

#include <fmt/format.h>

#include <algorithm>

#include "libbake/base/error.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/prepare.h"
#include "libbake/quality/low_pass.h"
#include "libbake/report/reduced_tile.h"

namespace texbake {
namespace {

constexpr int kConvertSide = 320;
constexpr int kFragmentSide = 512;
constexpr int kContentSide = 256;
constexpr int kTiles = 4;
constexpr int kRenderingSide = 384;

/// The tile with its classes at 1/factor of the size: the class in the middle of each block.
PrincipalVariation reduced_colors(const PrincipalVariation& colors, int factor) {
  PrincipalVariation reduced;
  reduced.palette = colors.palette;
  const int width = colors.index.width() / factor, height = colors.index.height() / factor;
  reduced.index = Image<uint8_t>(width, height);
  reduced.variation = Image<float>(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      reduced.index(x, y) = colors.index(x * factor + factor / 2, y * factor + factor / 2);
      reduced.variation(x, y) = colors.variation(x * factor + factor / 2, y * factor + factor / 2);
    }
  return reduced;
}

int reduction_of(ImageView<const V3f> tile, int side) { return reduction_to({tile.width(), tile.height()}, side); }

/// Two pictures beside each other.
Image<V3f> beside(ImageView<const V3f> left, ImageView<const V3f> right) {
  Image<V3f> both(left.width() + right.width(), left.height());
  for (int y = 0; y < both.height(); ++y) {
    std::copy_n(left.row(y), left.width(), both.row(y));
    std::copy_n(right.row(y), right.width(), both.row(y) + left.width());
  }
  return both;
}

SheetCell converted_cell(ImageView<const V3f> exemplar, const ConvertOptions& options, const char* how) {
  const Conversion found = convert(exemplar, {}, options);
  return {fmt::format("--classes {}{}\nerror {:.2f} Delta-E, 1 % above {:.1f}", found.colors.palette.classes.size(),
                      how, found.error.mean_delta_e, found.error.p99_delta_e),
          beside(decode_dominant(found.colors), decode(found.colors))};
}

/// Every fragment in its mean color, its border dark.
Image<V3f> drawn_fragments(const FragmentMap& map) {
  const Image<uint32_t>& idx = map.partition.idx;
  Image<V3f> picture(idx.width(), idx.height());
  for (int y = 0; y < idx.height(); ++y)
    for (int x = 0; x < idx.width(); ++x) {
      const uint32_t own = idx(x, y);
      const bool border = own != idx(wrap(x + 1, idx.width()), y) || own != idx(x, wrap(y + 1, idx.height()));
      picture(x, y) = border ? V3f(0.005f) : map.fragments[own].mean_color;
    }
  return picture;
}

FragmentOptions scaled(const FragmentOptions& options, float contrast, double size) {
  FragmentOptions other = options;
  *other.threshold *= contrast;
  *other.min_area_px = std::max(static_cast<int>(*options.min_area_px * size), 1);
  *other.max_area_px = std::max(static_cast<int>(*options.max_area_px * size), 4);
  return other;
}

Image<V3f> seen_from_afar(ImageView<const V3f> base, const PatchMap& patches, const ContentTable& contents) {
  EvaluatorInput input;
  input.base = base;
  input.patches = &patches;
  input.contents = &contents;
  const EvaluatorPlanes planes = prepare(input);
  Window window;
  window.width = planes.size.x * kTiles;
  window.height = planes.size.y * kTiles;
  window.filter = Filter::nearest;
  const Image<V3f> whole = render_rows(planes, window, 0, window.height);
  return reduce(whole, std::max((std::max(window.width, window.height) + kRenderingSide - 1) / kRenderingSide, 1));
}

}  // namespace

Sheet convert_sheet(ImageView<const V3f> exemplar, const ConvertOptions& options, const Progress& progress) {
  const Image<V3f> tile = reduce(exemplar, reduction_of(exemplar, kConvertSide));
  Sheet sheet{"convert: dominant colors only, and with their variation", 2, {}};
  sheet.cells.push_back({"the exemplar", beside(tile, tile)});
  ConvertOptions other = options;
  other.classes.reset();
  sheet.cells.push_back(converted_cell(tile, other, " (auto)"));
  constexpr int kCounts[] = {2, 3, 4, 6, 8, 12};
  for (const int count : kCounts) {
    other.classes = count;
    try {
      sheet.cells.push_back(converted_cell(tile, other, ""));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::bad_data) throw;
      break;  // fewer colors than classes
    }
    report_progress(progress, static_cast<double>(sheet.cells.size()) / (std::size(kCounts) + 2));
  }
  return sheet;
}

Sheet fragment_sheet(const PrincipalVariation& colors, ImageView<const V3f> base, const FragmentOptions& options,
                     const Progress& progress) {
  const FragmentOptions resolved = resolve(options, colors);
  const int factor = reduction_of(base, kFragmentSide);
  Sheet sheet{"fragment: threshold varies by row, areas by column", 3, {}};
  for (const float contrast : {0.5f, 1.0f, 2.0f})
    for (const double size : {0.5, 1.0, 2.0}) {
      const FragmentOptions tried = scaled(resolved, contrast, size);
      const FragmentMap map = fragment(colors, base, tried);
      sheet.cells.push_back(
          {fmt::format("--threshold {:.1f} --min-area {} --max-area {}\n{} fragments", *tried.threshold,
                       *tried.min_area_px, *tried.max_area_px, map.fragments.size()),
           reduce(drawn_fragments(map), factor)});
      report_progress(progress, static_cast<double>(sheet.cells.size()) / 9);
    }
  return sheet;
}

Sheet select_contents_sheet(const PrincipalVariation& colors, ImageView<const V3f> base, const PatchMap& patches,
                            const SelectContentsOptions& options, const Progress& progress) {
  const int factor = reduction_of(base, kContentSide);
  EvaluatorInput input;
  input.base = base;
  input.patches = &patches;
  const ReducedTile tile = reduced_tile(input, factor);
  const PrincipalVariation small = reduced_colors(colors, factor);
  Sheet sheet{
      fmt::format("select-contents: count varies by row, seed by column ({} x {} tiles)", kTiles, kTiles), 3, {}};
  for (const int count : {std::max(options.count - 2, 1), options.count, options.count + 3})
    for (const uint32_t seed : {options.seed, options.seed + 1, options.seed + 2}) {
      SelectContentsOptions tried = options;
      tried.count = count;
      tried.seed = seed;
      if (options.separation_px) tried.separation_px = std::max(*options.separation_px / factor, 1);
      const ContentSelection selection = select_contents(small, tile.base, *tile.patches, tried);
      sheet.cells.push_back({fmt::format("--count {} --seed {}\nrepeats near {:.2f}, far {:.2f}", count, seed,
                                         selection.figures.repetition_near, selection.figures.repetition_far),
                             seen_from_afar(tile.base, *tile.patches, selection.table)});
      report_progress(progress, static_cast<double>(sheet.cells.size()) / 9);
    }
  return sheet;
}

}  // namespace texbake
