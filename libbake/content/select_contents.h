// Chooses what may fill each patch: candidates of least visual impact, then a balanced choice among them.
// Based on: Vanhoey et al. 2013, §5.2, eq. 2 and 3.
#pragma once

#include "libbake/base/options.h"
#include "libbake/base/progress.h"
#include "libbake/color/palette.h"
#include "libbake/content/content.h"
#include "libbake/segment/patch.h"

namespace texbake {

/// How the N_t contents are chosen from the candidates.
enum class Choice {
  impact,    ///< the paper's: the least impact
  balanced,  ///< contents that balance each other from afar and use the exemplar evenly
};
template <>
struct EnumNames<Choice> {
  static constexpr std::pair<Choice, std::string_view> values[] = {{Choice::impact, "impact"},
                                                                   {Choice::balanced, "balanced"}};
};

/// How the candidates are searched.
enum class Search {
  exact,    ///< every translation of the tile is considered
  refined,  ///< at reduced size first, then exactly around the best
};
template <>
struct EnumNames<Search> {
  static constexpr std::pair<Search, std::string_view> values[] = {{Search::exact, "exact"},
                                                                   {Search::refined, "refined"}};
};

/// Whether translations keep to the texture's own lattice (lattice.h).
enum class LatticeUse {
  never,
  automatic,  ///< where the autocorrelation shows one
};
template <>
struct EnumNames<LatticeUse> {
  static constexpr std::pair<LatticeUse, std::string_view> values[] = {{LatticeUse::never, "never"},
                                                                       {LatticeUse::automatic, "auto"}};
};

struct SelectContentsOptions {
  /// N_t. Against 5, on five photographs of 512², G near fell from 0.18 … 0.20 to 0.11 … 0.13 and the other measures
  /// stayed; levels of detail take N_t / 3 of a plane.
  int count = 8;
  std::optional<int> candidates{};
  std::optional<int> separation_px{};
  Choice choice = Choice::balanced;
  std::optional<Search> search{};
  std::optional<int> rotations{};
  std::optional<int> scales{};
  float min_scale = 0.5f;
  LatticeUse lattice = LatticeUse::never;
  uint32_t seed = 1;
  std::optional<int> soft_border_px{};  ///< travels with the contents; the search does not read it

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.count, Field{.name = "count",
                            .unit = "contents",
                            .min = 1,
                            .max = 64,
                            .help = "number of contents for each patch, including the identity (N_t)"});
    visit(self.candidates,
          Field{.name = "candidates",
                .unit = "translations",
                .min = 1,
                .max = 4096,
                .help = "number of translations of least impact kept for the final choice",
                .auto_help = "120, or 4 (count - 1) if that is more; with --choice impact: count - 1"});
    visit(self.separation_px, Field{.name = "separation",
                                    .unit = "px",
                                    .min = 1,
                                    .max = 4096,
                                    .help = "minimum distance of candidates from the identity and from each other",
                                    .auto_help = "1/16 of the tile's shorter side"});
    visit(self.choice,
          Field{.name = "choice",
                .help = "impact: take those of least impact; balanced: also avoid a grid that shows from a distance"});
    visit(self.search,
          Field{.name = "search",
                .help = "exact: test all translations; refined: search at reduced size first",
                .auto_help = "exact up to 1024 x 1024 texels without rotations and scales, otherwise refined"});
    visit(self.rotations, Field{.name = "rotations",
                                .unit = "directions",
                                .min = 1,
                                .max = 8,
                                .help = "number of directions into which contents may be rotated: 1, 2, 4 or 8",
                                .auto_help = "1; 2 on a structure"});
    visit(self.scales, Field{.name = "scales",
                             .unit = "sizes",
                             .min = 1,
                             .max = 16,
                             .help = "number of sizes at which contents may appear; 1: full size only",
                             .auto_help = "1"});
    visit(self.min_scale, Field{.name = "min-scale", .min = 0.5, .max = 1, .help = "smallest of the sizes"});
    visit(self.lattice, Field{.name = "lattice",
                              .help = "auto: if bricks or a weave show a lattice, contents move only along it; not "
                                      "with rotations or scales"});
    visit(self.seed,
          Field{.name = "seed", .min = 0, .max = 4294967295.0, .help = "random seed of the joint choice of contents"});
    visit(self.soft_border_px,
          Field{.name = "soft-border",
                .unit = "px",
                .min = 0,
                .max = 32,
                .help = "width over which patches blend on either side of their borders; 0 and 1: hard borders",
                .auto_help = "3/1024 of the tile's shorter side, 2 to 4"});
  }
};

/// What was found, for provenance.
struct SelectContentsFigures {
  int content_classes = 0;        ///< N_C: dominant color × saliency
  double saliency_threshold = 0;  ///< texels above it are salient
  double salient_share = 0;       ///< of the texels
  double best_impact = 0;         ///< of the chosen contents, the identity apart, in ΔE⁴
  double mean_impact = 0;
  double worst_impact = 0;
  double mean_pair_impact = 0;  ///< over all pairs of contents that can meet at a border
  double worst_pair_impact = 0;
  double repetition_near = 0;  ///< G predicted from the contents, see choice.h
  double repetition_far = 0;
  double use_deviation = 0;        ///< standard deviation / mean of how often a texel is used
  double computed_share = 0;       ///< of the errors that a search without bounds computes
  double lattice_correlation = 0;  ///< of the lattice that contents keep to; 0 without one
};

struct ContentSelection {
  ContentTable table;
  SelectContentsOptions effective;  ///< the options with every automatic value replaced
  SelectContentsFigures figures;
};

SelectContentsOptions resolve(const SelectContentsOptions& options, int width, int height);

/// The options with the `rotations` that suit a structure, whose grain is drawn apart, where they are not given.
SelectContentsOptions deforming(const SelectContentsOptions& options);

/// `base` is the picture behind `colors`, linear Rec.709. Throws Error(infeasible) when the tile is too small for
/// `count` contents at the separation asked for.
ContentSelection select_contents(const PrincipalVariation& colors, ImageView<const V3f> base, const PatchMap& patches,
                                 const SelectContentsOptions& options = {}, const Progress& progress = {});

}  // namespace texbake
