// Puts bundles of one scale together, coarse to fine.
// Based on: Vanhoey et al. 2013, §6.
#pragma once

#include <string>
#include <vector>

#include "bake/listener.h"
#include "formats/bundle.h"

namespace texbake {

struct StackOptions {
  std::string ratio = "16";
  TransferMode transfer = TransferMode::fragment;
  DetailMean detail_mean = DetailMean::tile;
  DetailStrength detail = DetailStrength::absolute;
  VariationFrom variation = VariationFrom::both;
  float variation_fade = 1.25f;
  std::string weights, coarse_weights, detail_gains;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.ratio, Field{.name = "ratio",
                            .unit = "R[,R...]",
                            .help = "number of fine texels along one coarse texel, 2 to 1024; one number for all pairs "
                                    "of scales, or one for each"});
    visit(self.transfer, Field{.name = "transfer",
                               .help = "where a fine texel reads the coarse color: at the center of its fragment, at "
                                       "the texel itself, or bilinearly between coarse texels"});
    visit(
        self.detail_mean,
        Field{
            .name = "detail-mean",
            .help =
                "what the coarse color replaces: the mean of the fine tile, or the local mean over one coarse texel"});
    visit(self.detail, Field{.name = "detail",
                             .help = "strength of the fine scale's detail: absolute, or relative to the mean color of "
                                     "the coarsest scale, for scales of different brightness"});
    visit(self.variation, Field{.name = "variation", .help = "whose variation around the dominant colors is shown"});
    visit(self.variation_fade, Field{.name = "variation-fade",
                                     .min = 1,
                                     .max = 1000,
                                     .help = "factor by which the variation fades sooner than the dominant colors"});
    visit(self.weights, Field{.name = "weights",
                              .unit = "W,W,...[/...]",
                              .help = "share of the coarse color that each class of the fine scale takes, 0 to 16; "
                                      "lists for further scales follow after \"/\""});
    visit(self.coarse_weights, Field{.name = "coarse-weights",
                                     .unit = "W,W,...[/...]",
                                     .help = "share of its color that each class of the coarse scale gives"});
    visit(self.detail_gains, Field{.name = "detail-gains",
                                   .unit = "G,G,...[/...]",
                                   .help = "factor on the variation of each class of the fine scale"});
  }
};

/// A bundle and how it is called in messages.
struct NamedBundle {
  std::string path;
  Bundle bundle;
};

/// The transfers of scales 1, 2, ... of `count`. Throws Error(usage) for what the options do not say clearly.
std::vector<ScaleTransfer> transfers_of(const StackOptions& options, size_t count);

/// Names of `count` scales, coarse to fine: coarse, middle, ..., fine.
std::vector<std::string> scale_names(size_t count);

/// All scales, sources, stages, extensions and extras of `bundles`, and how each scale takes the colors of the one
/// before it; the record of the stage tells how far eq. 4 is violated. Throws Error(bad_data) for a bundle of several
/// scales, for scales in the wrong order, and as prepare_stack does.
Bundle run_stack(std::vector<NamedBundle> bundles, const StackOptions& options, Listener& listener);

}  // namespace texbake
