#include "libbake/planes/prepare_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libbake/base/error.h"
#include "libbake/color/luv.h"
#include "libbake/planes/box_mean.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/scale_detail.h"
#include "libbake/planes/stack_levels.h"
#include "libbake/planes/stacked.h"

namespace texbake {
namespace {

static_assert(static_cast<int>(TransferMode::fragment) == glsl::kTransferFragment &&
              static_cast<int>(TransferMode::texel) == glsl::kTransferTexel &&
              static_cast<int>(TransferMode::bilinear) == glsl::kTransferBilinear);

bool any_other_than_one(const std::vector<float>& list) {
  return std::any_of(list.begin(), list.end(), [](float x) { return x != 1.0f; });
}

void check_list(const std::vector<float>& list, size_t classes, const char* what, const char* whose) {
  if (!list.empty() && list.size() != classes)
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: expected {} numbers, one for each color class of the {} scale, found {}", what,
                            classes, whose, list.size()));
  for (const float x : list)
    if (!(x >= 0 && x <= 16)) throw Error(ErrorKind::bad_data, fmt::format("{}: expected 0 to 16, found {}", what, x));
}

/// Colors of the classes and what §8 lets a person choose for each: the first two rows.
void add_classes(const StackScale& scale, const ScaleTransfer* finer, std::vector<std::vector<glsl::vec4>>& rows) {
  const ScaleTransfer own = scale.transfer ? *scale.transfer : ScaleTransfer{};
  const std::vector<float> giving = finer ? finer->coarse_weights : std::vector<float>{};
  const std::vector<V3f> dominants = dominant_colors(scale);
  for (size_t k = 0; k < classes_of(scale); ++k) {
    const V3f color = dominants.empty() ? V3f(0) : dominants[k];
    rows[0].emplace_back(color.x, color.y, color.z, entry(own.detail_gains, k));
    rows[1].emplace_back(entry(own.weights, k), entry(giving, k), 0.0f, 0.0f);
  }
}

int transfer_bits(const StackScale& scale, const ScaleTransfer* finer) {
  int bits = 0;
  if (const ScaleTransfer* own = scale.transfer) {
    bits = static_cast<int>(own->mode);
    if (own->detail_mean == DetailMean::local) bits |= glsl::kLocalMean;
    if (own->variation == VariationFrom::coarse) bits |= glsl::kNoVariation;
    if (own->variation == VariationFrom::fine) bits |= glsl::kNoCoarserVariation;
  }
  const bool reads_labels =
      finer && (any_other_than_one(finer->coarse_weights) || finer->variation == VariationFrom::fine);
  return reads_labels ? bits | glsl::kCoarsestLabels : bits;
}

/// Shorter rows end with `empty`.
template <class T>
Image<T> table_of(const std::vector<std::vector<T>>& rows, T empty) {
  size_t width = 1;
  for (const std::vector<T>& row : rows) width = std::max(width, row.size());
  Image<T> table(static_cast<int>(width), static_cast<int>(rows.size()), empty);
  for (size_t y = 0; y < rows.size(); ++y) std::copy(rows[y].begin(), rows[y].end(), table.row(static_cast<int>(y)));
  return table;
}

/// Takes the scales from coarse to fine, then puts them together.
class StackBuilder {
 public:
  void add(const StackScale& scale, const ScaleTransfer* finer) {
    check_soft_border_fits(scale.input.soft_border_px, size_of(scale));
    planes_.push_back(strong_planes(scale));
    const TilePlanes& own = planes_.back();
    const ScaleTransfer transfer = scale.transfer ? *scale.transfer : ScaleTransfer{};
    fragments_.push_back(fragment_plane(scale));
    add_means(scale, transfer);
    add_classes(scale, finer, colors_);
    scales_[0].insert(scales_[0].end(), own.centers.begin(), own.centers.end());
    scales_.push_back({{own.size.x, own.size.y, row_, patch_},
                       {own.content_count, transfer.ratio, first_class_, transfer_bits(scale, finer)},
                       {0, 0, 0, 0},
                       {0, 0, 0, static_cast<int>(std::lround(256 * transfer.variation_fade))}});
    stack_.sizes.push_back(own.size);
    stack_.transfers.push_back(transfer);
    stack_.content_counts.push_back(own.content_count);
    stack_.patch_counts.push_back(own.patch_count);
    row_ += own.size.y;
    patch_ += own.patch_count;
    first_class_ += static_cast<int>(classes_of(scale));
  }

  StackPlanes take() {
    std::vector<const Image<glsl::PatchTexel>*> patch_planes;
    std::vector<const Image<glsl::ivec4>*> contents;
    std::vector<const Image<glsl::vec4>*> bases;
    for (const TilePlanes& scale : planes_) {
      patch_planes.push_back(&scale.patch_plane);
      contents.push_back(&scale.contents);
      bases.push_back(&scale.base.texels);
    }
    stack_.patch_plane = stacked(patch_planes, glsl::PatchTexel{});
    stack_.contents = stacked(contents, glsl::ivec4{0, 65536, 65536, 0});
    stack_.base = stacked(bases, kNothing);
    stack_.fragment_plane = stacked(pointers_to(fragments_), glsl::FragmentTexel{});
    stack_.local_mean = stacked_local_means();
    TilePlanes& finest = planes_.back();
    static_cast<glsl::NoiseUniforms&>(stack_) = finest;
    stack_.masks = std::move(finest.masks);
    stack_.noise_tiles = std::move(finest.noise_tiles);
    stack_.scale_table = table_of(scales_, glsl::ivec4{0, 0, 0, 0});
    stack_.color_table = table_of(colors_, kNothing);
    return std::move(stack_);
  }

 private:
  const glsl::vec4 kNothing{0, 0, 0, 0};

  void add_means(const StackScale& scale, const ScaleTransfer& transfer) {
    const Image<V3f> detail = mean_detail_of(scale);
    const TileMeans means = tile_means(scale, detail);
    colors_.push_back({texel_of(means.dominant), texel_of(means.whole)});
    const bool is_local = scale.transfer && transfer.detail_mean == DetailMean::local;
    local_means_.push_back(is_local ? box_means(detail, transfer.ratio) : Image<glsl::vec4>());
  }

  /// In the rows of their scales; one texel where there are none.
  Image<glsl::vec4> stacked_local_means() {
    const bool any =
        std::any_of(local_means_.begin(), local_means_.end(), [](const auto& image) { return !image.empty(); });
    if (!any) return Image<glsl::vec4>(1, 1, kNothing);
    for (size_t s = 0; s < local_means_.size(); ++s)
      if (local_means_[s].empty()) local_means_[s] = Image<glsl::vec4>(stack_.sizes[s].x, stack_.sizes[s].y, kNothing);
    return stacked(pointers_to(local_means_), kNothing);
  }

  StackPlanes stack_;
  std::vector<TilePlanes> planes_;
  std::vector<Image<glsl::FragmentTexel>> fragments_;
  std::vector<Image<glsl::vec4>> local_means_;
  std::vector<std::vector<glsl::ivec4>> scales_{1};  ///< scale_table: the centers of all patches, then each scale
  std::vector<std::vector<glsl::vec4>> colors_{2};   ///< color_table: classes in two rows, then each scale
  int row_ = 0, patch_ = 0, first_class_ = 0;
};

}  // namespace

void check_transfer(const StackScale& coarse, const StackScale& fine) {
  const ScaleTransfer& transfer = *fine.transfer;
  if (transfer.ratio < 2 || transfer.ratio > kMaxRatio)
    throw Error(ErrorKind::bad_data, fmt::format("ratio: expected 2 to {} fine texels per coarse texel, found {}",
                                                 kMaxRatio, transfer.ratio));
  if (!fine.input.colors || (transfer.mode == TransferMode::fragment && !fine.input.fragments))
    throw Error(ErrorKind::bad_data,
                "expected fragments in a scale that takes the colors of a coarser one, found none; run \"texbake "
                "fragment\" on it before stacking");
  const V2i small = size_of(fine), large = size_of(coarse) * transfer.ratio;
  if (small.x > large.x || small.y > large.y)
    throw Error(ErrorKind::bad_data,
                fmt::format("expected a fine tile no larger than the coarse one, which is {} x {} fine texels at ratio "
                            "{}, found {} x {}; are the scales ordered coarse to fine?",
                            large.x, large.y, transfer.ratio, small.x, small.y));
  check_list(transfer.weights, classes_of(fine), "weights", "fine");
  check_list(transfer.detail_gains, classes_of(fine), "detail gains", "fine");
  check_list(transfer.coarse_weights, classes_of(coarse), "coarse weights", "coarse");
}

StackPlanes prepare_stack(const std::vector<StackScale>& given) {
  std::vector<StackScale> scales = given;
  if (scales.empty() || scales.size() > kMaxScales)
    throw Error(ErrorKind::bad_data, fmt::format("expected 1 to {} scales, found {}", kMaxScales, scales.size()));
  for (size_t s = 1; s < scales.size(); ++s) {
    if (scales[s - 1].input.noise)
      throw Error(ErrorKind::bad_data, "expected noise in the finest scale only, found it in a coarser one");
    check_transfer(scales[s - 1], scales[s]);
  }
  set_strengths(scales);
  StackBuilder builder;
  for (size_t s = 0; s < scales.size(); ++s)
    builder.add(scales[s], s + 1 < scales.size() ? scales[s + 1].transfer : nullptr);
  StackPlanes planes = builder.take();
  add_levels(planes, scales);
  return planes;
}

}  // namespace texbake
