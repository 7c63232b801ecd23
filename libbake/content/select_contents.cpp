#include "libbake/content/select_contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "libbake/color/luv.h"
#include "libbake/content/choice.h"
#include "libbake/content/choice_figures.h"
#include "libbake/content/content_classes.h"
#include "libbake/content/content_search.h"
#include "libbake/content/pair_impact.h"
#include "libbake/content/refined_search.h"
#include "libbake/content/translation_lattice.h"
#include "libbake/content/turned_search.h"

namespace texbake {
namespace {

// More candidates balance better: on four photographs 120 were predicted to repeat 6, 20, 23 and 53 % less from afar
// than 60, at 3 to 6 % more impact.
constexpr int kBalancedCandidates = 120;
// Candidates closer than this show nearly the same from afar. On four photographs 1/16 of the side gave a third to
// two thirds of the repetition from afar that 1/32 did, at seams that are hardly more visible.
constexpr int kSeparationDivisor = 16;
// A hard border steps within one texel, edges of photographs over two or three. On four photographs of 512 texels 2
// made steps at borders usual ones (own AUC 0.51 to 0.58 instead of 0.63 to 0.79), of 1024 texels 3 did (0.57 instead
// of 0.84), at a sharpness of 1.00 to 1.02; to the eye pictures are as crisp. Beyond 4 features show through each
// other.
constexpr double kSoftBorderShare = 3.0 / 1024;
constexpr int kLeastSoftBorder = 2;
constexpr int kMostSoftBorder = 4;
constexpr int kSoftBorderSides = 8;  // a tile is at least so many borders wide

// Classes hardly see directions: among eight rotations of bark more than half of the contents lay across its grain.
// Half a turn keeps the directions of any structure. Sizes are not varied: with three, plates of bark and leaves came
// half as large as they are, and from afar G was 0.096 rather than 0.070 (bark), 0.103 rather than 0.064 (grass).
constexpr int kStructureRotations = 2;

int automatic_soft_border(int side) {
  const auto px = static_cast<int>(side * kSoftBorderShare + 0.5);
  return std::min(std::clamp(px, kLeastSoftBorder, kMostSoftBorder), side / kSoftBorderSides);
}

// Bricks of a wall differ in place by a texel or two: the seams decide there.
constexpr int kLatticeRadius = 2;

SearchResult search(const ContentClasses& classes, const ClassDistances& distances, const Partition& patches,
                    const Turns& turns, const std::optional<TranslationLattice>& lattice,
                    const SelectContentsOptions& options, const Progress& progress) {
  SearchRequest request{*options.candidates, *options.separation_px, {}};
  if (lattice) {  // few translations are left: all of them are searched, whatever the size of the tile
    const Image<uint8_t> allowed = near_lattice(*lattice, patches.size(), kLatticeRadius);
    request.allowed = allowed;
    return search_contents(classes.idx, distances, patch_borders(patches.idx, patches.count()), request, progress);
  }
  if (turns.size() > 1) return search_contents_turned(classes.idx, distances, patches, turns, request, progress);
  if (*options.search == Search::refined)
    return search_contents_refined(classes.idx, distances, patches.idx, patches.count(), request, progress);
  return search_contents(classes.idx, distances, patch_borders(patches.idx, patches.count()), request, progress);
}

void check_enough(const std::vector<Candidates>& candidates, int wanted, const SelectContentsOptions& options) {
  for (size_t patch = 0; patch < candidates.size(); ++patch)
    if (candidates[patch].size() < static_cast<size_t>(wanted))
      throw Error(ErrorKind::infeasible,
                  fmt::format("patch {}: expected {} translations at least {} px apart, but the tile has {}; ask for "
                              "fewer contents (--count) or a smaller --separation",
                              patch, wanted, *options.separation_px, candidates[patch].size()));
}

// What the search found, as contents.
ContentCandidates contents_of(const std::vector<Candidates>& found, const Turns& turns, const ClassDistances& distances,
                              const Partition& patches) {
  const std::vector<size_t> border_counts = patch_borders(patches.idx, patches.count()).texel_counts;
  ContentCandidates candidates(found.size());
  for (size_t patch = 0; patch < found.size(); ++patch)
    for (const Candidate& candidate : found[patch]) {
      Content content = turns[static_cast<size_t>(candidate.turn)];
      content.translation = shortest(candidate.translation, patches.size());
      content.impact = static_cast<float>(distances.impact(candidate.error_sum, border_counts[patch]));
      candidates[patch].push_back(content);
    }
  return candidates;
}

// The identity and the chosen candidates of each patch, least impact first.
ContentTable make_table(const ContentCandidates& candidates, const ChosenCandidates& chosen) {
  ContentTable table;
  table.patch_count = static_cast<int>(candidates.size());
  table.content_count = static_cast<int>(chosen.front().size()) + 1;
  for (size_t patch = 0; patch < candidates.size(); ++patch) {
    table.contents.emplace_back();
    for (const int number : chosen[patch]) table.contents.push_back(candidates[patch][static_cast<size_t>(number)]);
  }
  return table;
}

void measure_impacts(const ContentTable& table, SelectContentsFigures& figures) {
  double sum = 0.0;
  int count = 0;
  for (int patch = 0; patch < table.patch_count; ++patch)
    for (int content = 1; content < table.content_count; ++content) {
      const auto impact = static_cast<double>(table.at(patch, content).impact);
      figures.best_impact = count == 0 ? impact : std::min(figures.best_impact, impact);
      figures.worst_impact = std::max(figures.worst_impact, impact);
      sum += impact;
      ++count;
    }
  figures.mean_impact = count > 0 ? sum / count : 0.0;
}

}  // namespace

SelectContentsOptions resolve(const SelectContentsOptions& options, int width, int height) {
  check_options(options);
  SelectContentsOptions effective = options;
  const int wanted = std::max(options.count - 1, 1);
  if (!effective.candidates)
    effective.candidates = options.choice == Choice::balanced ? std::max(kBalancedCandidates, 4 * wanted) : wanted;
  if (*effective.candidates < wanted)
    throw Error(
        ErrorKind::usage,
        fmt::format(
            "--candidates: expected at least {}, one for each of the {} contents other than the identity, found {}",
            wanted, options.count, *effective.candidates));
  if (!effective.separation_px) effective.separation_px = std::max(std::min(width, height) / kSeparationDivisor, 1);
  if (!effective.soft_border_px) effective.soft_border_px = automatic_soft_border(std::min(width, height));
  effective.rotations = options.rotations.value_or(1);
  effective.scales = options.scales.value_or(1);
  if (std::popcount(static_cast<unsigned>(*effective.rotations)) != 1)
    throw Error(ErrorKind::usage, fmt::format("--rotations: expected 1, 2, 4 or 8, found {}", *effective.rotations));
  const bool is_turned = *effective.rotations > 1 || *effective.scales > 1;
  if (is_turned && options.lattice != LatticeUse::never)
    throw Error(
        ErrorKind::usage,
        "--lattice auto: expected neither --rotations nor --scales, which would break the lattice; found one of them");
  if (is_turned && options.search == Search::exact)
    throw Error(ErrorKind::usage,
                "--search exact: not possible with --rotations or --scales, which search exactly only among the most "
                "promising contents; use --search refined");
  if (is_turned) effective.search = Search::refined;
  if (!effective.search) effective.search = std::max(width, height) <= kExactSide ? Search::exact : Search::refined;
  return effective;
}

SelectContentsOptions deforming(const SelectContentsOptions& options) {
  SelectContentsOptions deforming = options;
  if (!options.rotations) deforming.rotations = kStructureRotations;
  return deforming;
}

ContentSelection select_contents(const PrincipalVariation& colors, ImageView<const V3f> base, const PatchMap& patches,
                                 const SelectContentsOptions& options, const Progress& progress) {
  ContentSelection result;
  const V2i size(base.width(), base.height());
  result.effective = resolve(options, size.x, size.y);
  const int wanted = options.count - 1;
  const Partition& partition = patches.partition;

  // Compare contents by classes of dominant color and saliency.
  const ContentClasses classes = content_classes(colors, base);
  const ClassDistances distances = class_distances(classes.mean_luv);
  result.figures.content_classes = classes.count();
  result.figures.saliency_threshold = static_cast<double>(classes.saliency_threshold);
  result.figures.salient_share = classes.salient_share;

  // Candidates of least impact, then the choice among them.
  const Image<V3f> luv = luv_from_linear(base);
  ContentCandidates candidates(static_cast<size_t>(partition.count()));
  ChosenCandidates chosen(candidates.size());
  if (wanted > 0) {
    const Turns turns = make_turns(*result.effective.rotations, *result.effective.scales, options.min_scale);
    std::optional<TranslationLattice> lattice;
    if (options.lattice == LatticeUse::automatic) lattice = find_lattice(luv);
    if (lattice) result.figures.lattice_correlation = lattice->correlation;
    const SearchResult found = search(classes, distances, partition, turns, lattice, result.effective,
                                      [&](double done) { report_progress(progress, 0.9 * done); });
    check_enough(found.candidates, wanted, result.effective);
    if (found.all_error_count > 0)
      result.figures.computed_share =
          static_cast<double>(found.error_count) / static_cast<double>(found.all_error_count);
    candidates = contents_of(found.candidates, turns, distances, partition);
    chosen = options.choice == Choice::balanced ? choose_balanced(candidates, wanted, luv, partition, options.seed)
                                                : choose_least_impact(candidates, wanted);
  }
  result.table = make_table(candidates, chosen);

  // Say how good the choice is.
  measure_impacts(result.table, result.figures);
  const PairImpact pairs = pair_impact(classes.idx, distances, partition, result.table);
  result.figures.mean_pair_impact = pairs.mean;
  result.figures.worst_pair_impact = pairs.worst;
  const ChoiceFigures figures = choice_figures(result.table, luv, partition);
  result.figures.repetition_near = figures.repetition_near;
  result.figures.repetition_far = figures.repetition_far;
  result.figures.use_deviation = figures.use_deviation;
  report_progress(progress, 1.0);
  return result;
}

}  // namespace texbake
