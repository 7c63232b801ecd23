#include "libbake/draw/feature.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "libbake/base/error.h"

namespace texbake {
namespace {

/// In the order of Feature.
constexpr std::string_view kNames[kFeatures] = {"--rotate, --stretch, --turbulence",
                                                "--map",
                                                "--show",
                                                "--view plane",
                                                "--supersample",
                                                "--relief",
                                                "several scales"};

struct NotOffered {
  Feature feature;
  Feature beside;
  std::string_view why;
};

constexpr NotOffered kNotOffered[] = {
    {Feature::deformation, Feature::map, "deform only the color"},
    {Feature::deformation, Feature::show, "deform only the color"},
    {Feature::deformation, Feature::plane, "deform only a flat window"},
    {Feature::deformation, Feature::relief, "deform only flat surfaces"},
    {Feature::deformation, Feature::scales, "deform only bundles of one scale"},
    {Feature::show, Feature::map, "shows how the texture is put together, not a map"},
    {Feature::show, Feature::plane, "shows whole texels, which only a flat window has"},
    {Feature::show, Feature::supersample, "shows whole texels, which have no mean"},
    {Feature::show, Feature::relief, "shows how the texture is put together, without light"},
    {Feature::relief, Feature::map, "lights the color, not a map"},
};

}  // namespace

std::string_view feature_name(Feature feature) { return kNames[static_cast<size_t>(feature)]; }

std::string_view why_not(Feature a, Feature b) {
  const auto* const found = std::ranges::find_if(kNotOffered, [&](const NotOffered& pair) {
    return (pair.feature == a && pair.beside == b) || (pair.feature == b && pair.beside == a);
  });
  return found == std::end(kNotOffered) ? std::string_view() : found->why;
}

void check_features(const Features& features) {
  for (const auto& [feature, beside, why] : kNotOffered) {
    if (!features.has(feature) || !features.has(beside)) continue;
    throw Error(
        ErrorKind::usage,
        beside == Feature::scales
            ? fmt::format("{}: {}; found a bundle of {}", feature_name(feature), why, feature_name(beside))
            : fmt::format("{}: {}; expected no {} beside it", feature_name(feature), why, feature_name(beside)));
  }
}

std::string not_together() {
  std::string lines;
  for (int i = 0; i < kFeatures; ++i) {
    const auto feature = static_cast<Feature>(i);
    std::vector<std::string_view> others;
    for (const NotOffered& pair : kNotOffered)
      if (pair.feature == feature) others.push_back(feature_name(pair.beside));
    if (others.empty()) continue;
    const std::string_view last = others.back();
    others.pop_back();
    lines += fmt::format("{}: not with {}{}{}\n", feature_name(feature), fmt::join(others, ", "),
                         others.empty() ? "" : " or ", last);
  }
  return lines;
}

}  // namespace texbake
