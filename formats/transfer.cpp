#include "formats/transfer.h"

#include <fmt/format.h>

#include "formats/json_text.h"

namespace texbake {
namespace {

/// The lists of numbers, by their names: one number for each class of the scale or of the coarser one.
template <class Transfer, class Visitor>
void for_each_list(Transfer& transfer, Visitor&& visit) {
  visit("weights", transfer.weights);
  visit("coarseWeights", transfer.coarse_weights);
  visit("detailGains", transfer.detail_gains);
}

size_t classes_of(const Scale& scale) { return scale.colors ? scale.colors->palette.classes.size() : 0; }

void check_pair(const Scale& coarse, const Scale& fine, V2i coarse_size, V2i fine_size, const std::string& pointer,
                IssueLog& log) {
  const ScaleTransfer& transfer = *fine.transfer;
  const V2i largest = coarse_size * transfer.ratio;
  if (fine_size.x > largest.x || fine_size.y > largest.y)
    log.add({IssueId::scale_order,
             {.pointer = pointer + "/size"},
             fmt::format("expected at most {} x {} texels, {} per texel of the coarser scale, found {} x {}", largest.x,
                         largest.y, transfer.ratio, fine_size.x, fine_size.y)});
  if (!fine.colors || (transfer.mode == TransferMode::fragment && !fine.fragments))
    log.add({IssueId::transfer_fragments, {.pointer = pointer}, "expected a palette and fragments, found none"});
  for_each_list(transfer, [&](const std::string& name, const std::vector<float>& list) {
    const size_t classes = classes_of(name == "coarseWeights" ? coarse : fine);
    if (!list.empty() && list.size() != classes)
      log.add({IssueId::transfer_list,
               {.pointer = fmt::format("{}/transfer/{}", pointer, name)},
               fmt::format("expected {} numbers, one for each class, found {}", classes, list.size())});
  });
}

}  // namespace

Json transfer_json(const ScaleTransfer& transfer) {
  Json json = {{"ratio", transfer.ratio},
               {"mode", enum_name(transfer.mode)},
               {"detailMean", enum_name(transfer.detail_mean)},
               {"detail", enum_name(transfer.detail)},
               {"variation", enum_name(transfer.variation)},
               {"variationFade", json_number(transfer.variation_fade)}};
  for_each_list(transfer, [&](const std::string& name, const std::vector<float>& list) {
    for (const float number : list) json[name].push_back(json_number(number));
  });
  return json;
}

ScaleTransfer transfer_of(const Json& json) {
  ScaleTransfer transfer;
  transfer.ratio = json["ratio"].get<int>();
  transfer.mode = *enum_value<TransferMode>(json["mode"].get<std::string>());
  transfer.detail_mean = *enum_value<DetailMean>(json["detailMean"].get<std::string>());
  if (json.contains("detail")) transfer.detail = *enum_value<DetailStrength>(json["detail"].get<std::string>());
  transfer.variation = *enum_value<VariationFrom>(json["variation"].get<std::string>());
  transfer.variation_fade = json["variationFade"].get<float>();
  for_each_list(transfer, [&](const std::string& name, std::vector<float>& list) {
    if (json.contains(name))
      for (const Json& number : json[name]) list.push_back(number.get<float>());
  });
  return transfer;
}

void check_transfers(const Bundle& bundle, const std::vector<V2i>& sizes, IssueLog& log) {
  for (size_t i = 0; i < bundle.scales.size(); ++i) {
    const std::string pointer = fmt::format("/scales/{}", i);
    if (bundle.scales[i].transfer.has_value() != (i > 0))
      log.add({IssueId::transfer_missing,
               {.pointer = pointer},
               i > 0 ? "expected a member \"transfer\", found none"
                     : "expected no member \"transfer\" in the coarsest scale, found one"});
    else if (i > 0)
      check_pair(bundle.scales[i - 1], bundle.scales[i], sizes[i - 1], sizes[i], pointer, log);
  }
}

}  // namespace texbake
