#include "bake/stack_stage.h"

#include <fmt/format.h>

#include <algorithm>

#include "bake/option_json.h"
#include "bake/provenance.h"
#include "bake/running_stage.h"
#include "formats/drawn_bundle.h"
#include "libbake/planes/prepare_stack.h"
#include "libbake/planes/transfer_error.h"

namespace texbake {
namespace {

/// Figures are measured on so many fine texels along each axis at most, so that time stays small for any ratio.
constexpr int kMostFineTexels = 768;
/// Of fine texels darker than black: on four pairs of photographs less is not seen.
constexpr double kSeenBlackShare = 0.02;

std::vector<std::string> parted(const std::string& text, char by) {
  std::vector<std::string> parts;
  for (size_t begin = 0; !text.empty() && begin <= text.size();) {
    const size_t end = std::min(text.find(by, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::vector<float> numbers(const std::string& text, const char* flag) {
  const Field field{.name = flag, .min = 0, .max = 16};
  std::vector<float> list;
  for (const std::string& word : parted(text, ',')) list.push_back(static_cast<float>(parse_number(flag, field, word)));
  return list;
}

/// The part of `text` for finer scale `i` of `count`: none, or one for each.
std::string part_of(const std::string& text, size_t i, size_t count, const char* flag) {
  const std::vector<std::string> parts = parted(text, '/');
  if (parts.empty()) return "";
  if (parts.size() != count)
    throw Error(ErrorKind::usage,
                fmt::format("--{}: expected {} lists separated by \"/\", one for each scale but the coarsest, found {}",
                            flag, count, parts.size()));
  return parts[i];
}

int ratio_of(const std::string& text, size_t i, size_t count) {
  const Field field{.name = "ratio", .unit = "fine texels", .min = 2, .max = kMaxRatio};
  const std::vector<std::string> parts = parted(text, ',');
  if (parts.size() != 1 && parts.size() != count)
    throw Error(ErrorKind::usage,
                fmt::format("--ratio: expected one number, or {} (one for each pair of scales), found {}", count,
                            parts.size()));
  return static_cast<int>(parse_integer("ratio", field, parts[parts.size() == 1 ? 0 : i]));
}

void check_single(const NamedBundle& named) {
  if (named.bundle.scales.size() == 1) return;
  throw Error(
      ErrorKind::bad_data,
      fmt::format(
          "{}: expected a bundle of one scale, found a stack of {}; stack its scales and the others in one call",
          named.path, named.bundle.scales.size()));
}

/// A finer scale takes the place of the grain of a coarser one, from near; from afar it is in the exemplar.
void drop_coarse_noise(NamedBundle& named, Listener& listener) {
  if (!named.bundle.noise) return;
  drop_stage(named.bundle, "estimate-psd");
  listener.warning(fmt::format(
      "{}: noise is drawn in the finest scale only; the stack shows the exemplar of this bundle, and drops its noise",
      named.path));
}

/// Members of `from` go to `to`; two scales may not say different things under one name.
void merge(Json& to, const Json& from, const std::string& path) {
  for (const auto& [key, value] : from.items()) {
    if (to.contains(key) && to[key] != value)
      throw Error(ErrorKind::bad_data, fmt::format("{}: extension \"{}\": expected the same value as in the other "
                                                   "scales, found another; remove it from one of them",
                                                   path, key));
    to[key] = value;
  }
}

/// Moves a bundle of one scale into the stack, under its new name.
void add_scale(Bundle& stack, NamedBundle& named, const std::string& name) {
  Bundle& bundle = named.bundle;
  merge(stack.extensions, bundle.extensions, named.path);
  merge(stack.unknown, bundle.unknown, named.path);
  if (!bundle.extras.empty()) stack.extras[name] = std::move(bundle.extras);
  for (SourceFile& source : bundle.sources) {
    source.scale = name;
    stack.sources.push_back(std::move(source));
  }
  for (Stage& stage : bundle.stages) {
    stage.scale = name;
    stack.stages.push_back(std::move(stage));
  }
  if (bundle.noise) stack.noise = std::move(bundle.noise);
  bundle.scales[0].name = name;
  stack.scales.push_back(std::move(bundle.scales[0]));
}

Json error_json(const TransferError& error) {
  return {{"rms", error.rms}, {"worst", error.worst}, {"belowBlack", error.below_black}};
}

void warn_of_black(const ScaleTransfer& transfer, double share, const std::string& scale, Listener& listener) {
  if (share < kSeenBlackShare || transfer.detail == DetailStrength::relative) return;
  listener.warning(
      fmt::format("scale {}: {:.0f} % of its texels fall below black where the coarse scale is dark, and lose their "
                  "detail; --detail relative preserves it",
                  scale, 100 * share));
}

/// Planes of `stack` that can show either mean of every scale.
StackPlanes planes_with_local_means(const Bundle& stack) {
  std::vector<StackScale> scales = stack_input(stack);
  std::vector<ScaleTransfer> transfers(scales.size());
  for (size_t s = 1; s < scales.size(); ++s) {
    transfers[s] = *scales[s].transfer;
    transfers[s].detail_mean = DetailMean::local;
    scales[s].transfer = &transfers[s];
  }
  return prepare_stack(scales);
}

/// Eq. 4, for both means that a stack may subtract.
Json figures_of(const Bundle& stack, Listener& listener) {
  StackPlanes planes = planes_with_local_means(stack);
  const auto chosen = [&](size_t s) { return stack.scales[s].transfer->detail_mean; };
  for (size_t s = 1; s < stack.scales.size(); ++s) set_detail_mean(planes, static_cast<int>(s), chosen(s));
  Json list = Json::array();
  for (size_t s = 1; s < stack.scales.size(); ++s) {
    const ScaleTransfer& transfer = *stack.scales[s].transfer;
    const int scale = static_cast<int>(s), side = std::clamp(kMostFineTexels / transfer.ratio, 1, kTransferErrorSide);
    Json figures = {{"scale", stack.scales[s].name}, {"coarseTexels", side * side}};
    double below_black = 0;
    for (const DetailMean mean : {DetailMean::tile, DetailMean::local}) {
      set_detail_mean(planes, scale, mean);
      const TransferError error = transfer_error(planes, scale, side);
      figures[mean == DetailMean::tile ? "violationTileMean" : "violationLocalMean"] = error_json(error);
      if (mean == chosen(s)) below_black = error.below_black;
    }
    set_detail_mean(planes, scale, chosen(s));
    list.push_back(figures);
    warn_of_black(transfer, below_black, stack.scales[s].name, listener);
  }
  return {{"pairs", list}};
}

}  // namespace

std::vector<ScaleTransfer> transfers_of(const StackOptions& options, size_t count) {
  std::vector<ScaleTransfer> transfers;
  for (size_t i = 0; i + 1 < count; ++i) {
    ScaleTransfer transfer;
    transfer.ratio = ratio_of(options.ratio, i, count - 1);
    transfer.mode = options.transfer;
    transfer.detail_mean = options.detail_mean;
    transfer.detail = options.detail;
    transfer.variation = options.variation;
    transfer.variation_fade = options.variation_fade;
    transfer.weights = numbers(part_of(options.weights, i, count - 1, "weights"), "weights");
    transfer.coarse_weights =
        numbers(part_of(options.coarse_weights, i, count - 1, "coarse-weights"), "coarse-weights");
    transfer.detail_gains = numbers(part_of(options.detail_gains, i, count - 1, "detail-gains"), "detail-gains");
    transfers.push_back(transfer);
  }
  return transfers;
}

std::vector<std::string> scale_names(size_t count) {
  std::vector<std::string> names = {"coarse"};
  for (size_t i = 1; i + 1 < count; ++i) names.push_back(count == 3 ? "middle" : fmt::format("middle{}", i));
  names.push_back("fine");
  return names;
}

Bundle run_stack(std::vector<NamedBundle> bundles, const StackOptions& options, Listener& listener) {
  const std::vector<ScaleTransfer> transfers = transfers_of(options, bundles.size());
  const std::vector<std::string> names = scale_names(bundles.size());
  for (NamedBundle& named : bundles) {
    check_single(named);
    if (&named != &bundles.back()) drop_coarse_noise(named, listener);
  }
  Bundle stack;
  for (size_t s = 0; s < bundles.size(); ++s) {
    add_scale(stack, bundles[s], names[s]);
    if (s > 0) stack.scales[s].transfer = transfers[s - 1];
    if (s > 0) try {
        const auto input = stack_input(stack);
        check_transfer(input[s - 1], input[s]);
      } catch (const Error& error) {
        throw Error(error.kind(), fmt::format("{} after {}: {}", bundles[s].path, bundles[s - 1].path, error.what()));
      }
  }
  RunningStage stage(stack, "stack", listener);
  Json parameters = Json::object();
  add_parameters(parameters, options, options);
  stage.finish(parameters, figures_of(stack, listener));
  return stack;
}

}  // namespace texbake
