#include "libbake/planes/stack_levels.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "libbake/planes/fragment_shares.h"
#include "libbake/planes/level_weights.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/scale_detail.h"
#include "libbake/planes/stacked.h"

namespace texbake {
namespace {

/// w: the share of the coarser color that each texel takes.
void set_texels(Plane& plane, const Image<V3f>& colors, const Image<float>& taking) {
  for (size_t i = 0; i < colors.size(); ++i) {
    const V3f& c = colors.data()[i];
    plane.texels.data()[i] = {c.x, c.y, c.z, taking.data()[i]};
  }
}

Image<float> taking_of(const StackScale& scale) {
  const V2i size = size_of(scale);
  Image<float> taking(size.x, size.y, 1.0f);
  if (!scale.transfer || scale.transfer->weights.empty()) return taking;
  const Image<glsl::FragmentTexel> labels = fragment_plane(scale);
  for (size_t i = 0; i < taking.size(); ++i)
    taking.data()[i] = scale.transfer->weights[static_cast<size_t>(labels.data()[i].fragment_class)];
  return taking;
}

/// What the variation of each texel is multiplied with; empty: 1.
Image<float> gain_of(const StackScale& scale) {
  Image<float> gain;
  if (!scale.transfer || scale.transfer->detail_gains.empty()) return gain;
  const V2i size = size_of(scale);
  gain = Image<float>(size.x, size.y);
  for (size_t i = 0; i < gain.size(); ++i)
    gain.data()[i] = scale.transfer->detail_gains[scale.input.colors->index.data()[i]];
  return gain;
}

/// The planes of one scale with the lists of the levels that it needs in a stack.
struct LeveledScale {
  TilePlanes planes;  ///< base: with its gains; map 0: the dominant colors, where they are read
  LevelLists lists = {};
  LevelTables tables = {};
  Image<glsl::ivec4> shares = {};  ///< of fragments; empty where they pass no colors
  int level_count = 0;
};

/// Whether the levels of dominant colors are read: of a scale that fades, and of texels on soft borders that are
/// passed to a finer scale without their variation.
bool has_dominants(const std::vector<StackScale>& scales, size_t s) {
  if (scales[s].transfer) return true;
  return soft_border_of(scales[s]) > 0 && scales.size() > 1 && scales[1].transfer->variation == VariationFrom::fine;
}

LeveledScale leveled(const StackScale& scale, bool with_dominants) {
  LeveledScale leveled{strong_planes(scale)};
  TilePlanes& planes = leveled.planes;
  planes.soft_border_px = soft_border_of(scale);
  planes.noise_gain = gain_of(scale);
  const Image<float> taking = taking_of(scale);
  set_texels(planes.base, detail_of(scale), taking);
  if (with_dominants) {
    planes.maps.push_back(
        {"dominant", MapKind::plain, 3, Image<glsl::vec4>(planes.size.x, planes.size.y, {0, 0, 0, 0})});
    set_texels(planes.maps.back(), dominant_of(scale), taking);
  }
  leveled.lists = level_lists(planes);
  leveled.tables = level_tables(leveled.lists, planes);
  leveled.level_count = leveled.tables.level_count;
  if (!scale.transfer) return leveled;
  leveled.level_count = std::min(leveled.level_count, last_level(scale.transfer->ratio));
  if (scale.transfer->mode == TransferMode::fragment)
    leveled.shares = fragment_shares(scale, planes, leveled.lists, leveled.level_count);
  return leveled;
}

/// Numbers of next fragments count from the top of all scales.
void count_from(Image<glsl::ivec4>& shares, int row) {
  if (row == 0) return;
  for (glsl::ivec4& fragment : shares)
    if (fragment.w > 0) fragment.w += row * kListWidth;
}

}  // namespace

int last_level(int ratio) { return static_cast<int>(std::bit_width(static_cast<uint32_t>(ratio - 1))); }

void add_levels(StackPlanes& stack, const std::vector<StackScale>& scales) {
  std::vector<LeveledScale> leveled_scales;
  for (size_t s = 0; s < scales.size(); ++s) leveled_scales.push_back(leveled(scales[s], has_dominants(scales, s)));

  // Bases of all scales first, then dominant colors.
  std::vector<const Image<glsl::ivec4>*> tables = {&stack.scale_table};
  std::vector<const Image<glsl::LevelBlock>*> blocks;
  std::vector<const Image<glsl::PatchTexel>*> entries;
  std::vector<Image<glsl::ivec4>> shares;
  int level_row = stack.scale_table.height(), block_row = 0, entry_row = 0, value_row = 0, share_row = 0;
  for (size_t s = 0; s < scales.size(); ++s) {
    LeveledScale& scale = leveled_scales[s];
    count_from(scale.shares, share_row);
    if (scale.tables.first_level == 0) stack.scale_entry(1, static_cast<int>(s)).w |= glsl::kSoftBorders;
    stack.scale_entry(2, static_cast<int>(s)) = {level_row, block_row, entry_row, scale.level_count};
    stack.scale_entry(3, static_cast<int>(s)).x = value_row;
    stack.scale_entry(3, static_cast<int>(s)).z = share_row;
    tables.push_back(&scale.tables.level_table);
    blocks.push_back(&scale.tables.level_blocks);
    entries.push_back(&scale.tables.level_entries);
    level_row += tables.back()->height();
    block_row += blocks.back()->height();
    entry_row += entries.back()->height();
    value_row += value_rows(scale.lists, scale.planes);
    share_row += scale.shares.height();
    shares.push_back(std::move(scale.shares));
  }
  for (size_t s = 0; s < scales.size(); ++s) {
    if (!has_dominants(scales, s)) continue;
    stack.scale_entry(3, static_cast<int>(s)).y = value_row;
    value_row += value_rows(leveled_scales[s].lists, leveled_scales[s].planes);
  }
  stack.scale_table = stacked(tables, glsl::ivec4{0, 0, 0, 0});
  stack.level_blocks = stacked(blocks, glsl::LevelBlock{});
  stack.level_entries = stacked(entries, glsl::PatchTexel{});
  stack.base_levels = Image<glsl::vec4>::unset(kListWidth, value_row);
  for (size_t s = 0; s < scales.size(); ++s) {
    TilePlanes& planes = leveled_scales[s].planes;
    const LevelLists& lists = leveled_scales[s].lists;
    const glsl::ivec4& first = stack.scale_entry(3, static_cast<int>(s));
    const auto fill = [&](const Plane& plane, int row) {
      fill_levels(lists, plane, planes, {stack.base_levels.row(row), kListWidth, value_rows(lists, planes)});
    };
    fill(planes.base, first.x);
    if (has_dominants(scales, s)) fill(planes.maps[0], first.y);
    if (s + 1 == scales.size())
      stack.level_weights = planes.base.kind == MapKind::structure ? level_weights(planes, lists)
                                                                   : Image<glsl::MaskTexel>(1, 1, glsl::MaskTexel{});
    leveled_scales[s] = {};
  }
  stack.fragment_shares = in_one(std::move(shares), glsl::ivec4{0, 0, 0, 0});
}

}  // namespace texbake
