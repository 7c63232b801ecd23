#include "libbake/height/heightmap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "libbake/base/parallel.h"
#include "libbake/color/luv.h"
#include "libbake/height/appearance.h"
#include "libbake/height/click_set.h"
#include "libbake/height/descriptor.h"
#include "libbake/height/refine.h"

namespace texbake {
namespace {

constexpr double kTurn_rad = M_PI / 8;
// Raises the correlation with known heights on all three photographs measured; from 32 on narrow cracks suffer.
constexpr float kRefine = 16;

void check(const std::vector<HeightClick>& clicks, V2i size) {
  if (clicks.empty()) throw Error(ErrorKind::bad_data, "expected at least one click, found none; give some heights");
  std::map<std::pair<int, int>, float> known;
  for (size_t i = 0; i < clicks.size(); ++i) {
    const HeightClick& click = clicks[i];
    const V2i p = click.texel;
    if (p.x < 0 || p.y < 0 || p.x >= size.x || p.y >= size.y)
      throw Error(ErrorKind::bad_data, fmt::format("click {}: expected a texel inside the {} x {} tile, found ({}, {})",
                                                   i, size.x, size.y, p.x, p.y));
    if (!(click.height_01 >= 0.0f && click.height_01 <= 1.0f))
      throw Error(ErrorKind::bad_data, fmt::format("click {} at ({}, {}): expected a height from 0 to 1, found {}", i,
                                                   p.x, p.y, click.height_01));
    const auto [place, fresh] = known.try_emplace({p.y, p.x}, click.height_01);
    if (!fresh && place->second != click.height_01)
      throw Error(ErrorKind::bad_data, fmt::format("click {}: texel ({}, {}) has two heights, {} and {}: remove one", i,
                                                   p.x, p.y, place->second, click.height_01));
  }
}

constexpr DescriptorSpace kAppearanceSpace = {std::tuple_size_v<Appearance>, appearance_distance};
constexpr DescriptorSpace kGradientSpace = {std::tuple_size_v<Descriptor>, descriptor_distance};

ClickSet by_appearance(const AppearancePyramid& pyramid, const std::vector<HeightClick>& clicks, int most) {
  ClickSet set(kAppearanceSpace, 1);
  for (const HeightClick& click : clicks) {
    const Appearance appearance = pyramid.at(click.texel);
    set.add(click.height_01, {appearance.begin(), appearance.end()});
  }
  set.reduce(most);
  set.build();
  return set;
}

/// The clicks on texels of class k, each with its three turns.
ClickSet by_gradients(const ClassGradients& gradients, const Image<uint8_t>& index, int k,
                      const std::vector<HeightClick>& clicks, int most) {
  ClickSet set(kGradientSpace, 3);
  for (const HeightClick& click : clicks) {
    if (index(click.texel.x, click.texel.y) != k) continue;
    std::vector<float> turns;
    for (const Descriptor& turn : {gradients.at(click.texel), gradients.turned(click.texel, -kTurn_rad),
                                   gradients.turned(click.texel, kTurn_rad)})
      turns.insert(turns.end(), turn.begin(), turn.end());
    set.add(click.height_01, turns);
  }
  set.reduce(most);
  if (set.count() > 0) set.build();
  return set;
}

/// Fills the heights of the texels that `chosen` accepts; `descriptor_at` describes one of them.
template <class Chosen, class DescriptorAt>
void spread(Image<float>& heights, const ClickSet& set, const Blend& blend, const Chosen& chosen,
            const DescriptorAt& descriptor_at) {
  parallel_for(0, heights.height(), [&](int y) {
    for (int x = 0; x < heights.width(); ++x)
      if (chosen(x, y)) heights(x, y) = set.height_of(descriptor_at(V2i(x, y)).data(), blend);
  });
}

Heightmap spread_by_appearance(ImageView<const V3f> luv, const std::vector<HeightClick>& clicks, const Blend& blend,
                               int most, const Progress& progress) {
  const AppearancePyramid pyramid(luv);
  report_progress(progress, 0.5);
  const ClickSet set = by_appearance(pyramid, clicks, most);
  Heightmap result{Image<float>(luv.width(), luv.height()), {}, set.count()};
  spread(
      result.height_01, set, blend, [](int, int) { return true; }, [&](V2i texel) { return pyramid.at(texel); });
  return result;
}

Heightmap spread_by_gradients(const PrincipalVariation& colors, ImageView<const V3f> luv,
                              const std::vector<HeightClick>& clicks, const Blend& blend, int most,
                              const Progress& progress) {
  Heightmap result{Image<float>(luv.width(), luv.height()), {}, 0};
  const auto classes = static_cast<int>(colors.palette.classes.size());
  std::optional<AppearancePyramid> pyramid;
  std::optional<ClickSet> all;
  for (int k = 0; k < classes; ++k) {
    const ClassGradients gradients(colors, static_cast<uint8_t>(k));
    const ClickSet own = by_gradients(gradients, colors.index, k, clicks, most);
    const auto in_class = [&](int x, int y) { return colors.index(x, y) == k; };
    result.clicks_used += own.count();
    if (own.count() > 0) {
      spread(result.height_01, own, blend, in_class, [&](V2i texel) { return gradients.at(texel); });
    } else {
      result.classes_without_click.push_back(k);
      if (!pyramid) pyramid.emplace(luv);
      if (!all) all = by_appearance(*pyramid, clicks, most);
      spread(result.height_01, *all, blend, in_class, [&](V2i texel) { return pyramid->at(texel); });
    }
    report_progress(progress, static_cast<double>(k + 1) / classes);
  }
  return result;
}

}  // namespace

HeightmapOptions resolve(const HeightmapOptions& options) {
  check_options(options);
  const bool paper = options.descriptor == HeightDescriptor::gradients;
  HeightmapOptions resolved = options;
  if (!resolved.nearest) resolved.nearest = paper ? 3 : 8;
  if (!resolved.falloff) resolved.falloff = paper ? 1 : 2;
  if (!resolved.refine) resolved.refine = paper ? 0.0f : kRefine;
  return resolved;
}

Heightmap heightmap(const PrincipalVariation& colors, ImageView<const V3f> base, const std::vector<HeightClick>& clicks,
                    const HeightmapOptions& options, const Progress& progress) {
  const HeightmapOptions resolved = resolve(options);
  check(clicks, {base.width(), base.height()});
  const Blend blend{*resolved.nearest, *resolved.falloff};
  const Image<V3f> luv = luv_from_linear(base);
  Heightmap result = resolved.descriptor == HeightDescriptor::appearance
                         ? spread_by_appearance(luv, clicks, blend, resolved.max_representatives, progress)
                         : spread_by_gradients(colors, luv, clicks, blend, resolved.max_representatives, progress);
  if (*resolved.refine > 0) result.height_01 = refine(result.height_01, luv, *resolved.refine);
  return result;
}

}  // namespace texbake
