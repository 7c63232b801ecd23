// How a scale takes its colors from the next coarser one.
// Based on: Vanhoey et al. 2013, §6, eq. 4 and 5; §8 for weights and gains of single color classes.
#pragma once

#include <vector>

#include "libbake/base/options.h"

namespace texbake {

/// Where the coarse color of a fine texel is read.
enum class TransferMode {
  fragment,  ///< at the center of the fragment that shows there: one color for each fragment
  texel,     ///< at the texel itself: blocks as large as coarse texels show (Fig. 5, left)
  bilinear,  ///< at the texel, between four coarse texels: the coarse picture shows through (Fig. 5, middle)
};
template <>
struct EnumNames<TransferMode> {
  static constexpr std::pair<TransferMode, std::string_view> values[] = {
      {TransferMode::fragment, "fragment"}, {TransferMode::texel, "texel"}, {TransferMode::bilinear, "bilinear"}};
};

/// What is subtracted from the fine color, so that its mean becomes the coarse color.
enum class DetailMean {
  tile,   ///< the mean of the fine tile: eq. 5
  local,  ///< the mean of the fine tile over one coarse texel around the place where the coarse color is read
};
template <>
struct EnumNames<DetailMean> {
  static constexpr std::pair<DetailMean, std::string_view> values[] = {{DetailMean::tile, "tile"},
                                                                       {DetailMean::local, "local"}};
};

/// How strong the detail is that a scale adds to the coarser color.
enum class DetailStrength {
  absolute,  ///< as in its tile: eq. 5. Where the coarse scale is much darker, the darkest detail falls below black
  relative,  ///< in proportion: its tile times the mean of the coarsest over its own, channel by channel
};
template <>
struct EnumNames<DetailStrength> {
  static constexpr std::pair<DetailStrength, std::string_view> values[] = {{DetailStrength::absolute, "absolute"},
                                                                           {DetailStrength::relative, "relative"}};
};

/// Whose variation, what a color has beside the dominant color of its class, is seen from near.
enum class VariationFrom {
  both,
  coarse,  ///< the fine scale gives its dominant colors alone
  fine,    ///< the coarse scale gives its dominant colors alone
};
template <>
struct EnumNames<VariationFrom> {
  static constexpr std::pair<VariationFrom, std::string_view> values[] = {
      {VariationFrom::both, "both"}, {VariationFrom::coarse, "coarse"}, {VariationFrom::fine, "fine"}};
};

inline constexpr int kMaxRatio = 1024;
inline constexpr int kMaxScales = 8;  ///< that are drawn together

/// Held by every scale but the coarsest.
struct ScaleTransfer {
  int ratio = 16;  ///< texels of this scale along one texel of the coarser one, 2 … kMaxRatio
  TransferMode mode = TransferMode::fragment;
  DetailMean detail_mean = DetailMean::tile;
  DetailStrength detail = DetailStrength::absolute;
  VariationFrom variation = VariationFrom::both;
  float variation_fade = 1.25f;     ///< ≥ 1: how much sooner than the dominant color the variation fades
  std::vector<float> weights = {};  ///< for each class of this scale: the share of the coarse color it takes; empty: 1
  std::vector<float> coarse_weights = {};  ///< for each class of the coarser scale: the share it gives; empty: 1
  std::vector<float> detail_gains = {};    ///< for each class of this scale: its variation times this; empty: 1

  bool operator==(const ScaleTransfer&) const = default;
};

}  // namespace texbake
