#include "bake/report_of_bundle.h"

#include <cmath>
#include <optional>
#include <vector>

#include "bake/provenance.h"
#include "formats/drawn_bundle.h"

namespace texbake {
namespace {

// The figures of a stage as numbers; nothing when the stage has not run or has not recorded all of them.
std::optional<std::vector<double>> figures(const Bundle& bundle, const char* verb, std::vector<const char*> names) {
  const Stage* stage = find_stage(bundle, verb);
  if (!stage) return std::nullopt;
  std::vector<double> values;
  for (const char* name : names) {
    if (!stage->figures.contains(name) || !stage->figures[name].is_number()) return std::nullopt;
    values.push_back(stage->figures[name].get<double>());
  }
  return values;
}

// The value of largest magnitude of `value(noise)` over the noises that estimate-psd recorded; nothing when one lacks
// it.
template <class Value>
std::optional<double> largest(const Bundle& bundle, const Value& value) {
  const Stage* stage = find_stage(bundle, "estimate-psd");
  if (!stage || !stage->figures.contains("noises")) return std::nullopt;
  std::optional<double> found;
  for (const Json& noise : stage->figures["noises"]) {
    const std::optional<double> one = value(noise);
    if (!one) return std::nullopt;
    if (!found || std::abs(*one) > std::abs(*found)) found = one;
  }
  return found;
}

std::optional<double> number(const Json& record, const char* name) {
  const Json value = record.value(name, Json());
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::optional<double> largest_kurtosis(const Json& noise) {
  std::optional<double> found;
  for (const Json& one : noise.value("excessKurtosis", Json::array()))
    if (one.is_number() && (!found || std::abs(one.get<double>()) > std::abs(*found))) found = one.get<double>();
  return found;
}

// What estimate-psd and decompose recorded.
NoiseSummary noise_summary(const Bundle& bundle) {
  NoiseSummary summary;
  summary.spectrum_db = largest(bundle, [](const Json& noise) { return number(noise, "tileDifferenceDb"); });
  summary.power_error = largest(bundle, [](const Json& noise) -> std::optional<double> {
    const auto ratio = number(noise, "tileVarianceRatio");
    return ratio ? std::optional(std::abs(*ratio - 1)) : std::nullopt;
  });
  summary.excess_kurtosis = largest(bundle, largest_kurtosis);
  if (const Stage* stage = find_stage(bundle, "decompose")) {
    const Json result = stage->figures.value("result", Json::object());
    summary.energy_deviation = number(result, "energyDeviation");
    summary.coherence_drop = number(result, "coherenceDrop");
  }
  return summary;
}

}  // namespace

ReportInput report_input(const Bundle& bundle) {
  ReportInput input;
  input.tile = evaluator_input(bundle);
  if (bundle.noise) {
    input.exemplar = bundle.scales.back().exemplar;
    input.noise = noise_summary(bundle);
    for (const Noise& noise : bundle.noise->noises) input.spectra.push_back(noise.channels[0].spectrum);
  }
  if (const auto found = figures(bundle, "select-contents", {"meanPairImpact", "worstPairImpact"}))
    input.pairs = PairImpact{(*found)[0], (*found)[1]};
  if (const auto found = figures(bundle, "fragment", {"borderDeltaE", "interiorDeltaE", "sizeLimitedShare"}))
    input.contrast = ContrastReport{(*found)[0], (*found)[1], (*found)[2]};
  return input;
}

}  // namespace texbake
