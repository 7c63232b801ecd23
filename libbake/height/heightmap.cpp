#include "libbake/height/heightmap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "libbake/base/parallel.h"
#include "libbake/height/descriptor.h"
#include "libbake/height/nearest_clicks.h"

namespace texbake {
namespace {

constexpr double kTurn_rad = M_PI / 8;

void check(const std::vector<HeightClick>& clicks, V2i size) {
  if (clicks.empty()) throw Error(ErrorKind::bad_data, "expected one or more clicks, found none: give some heights");
  std::map<std::pair<int, int>, float> known;
  for (size_t i = 0; i < clicks.size(); ++i) {
    const HeightClick& click = clicks[i];
    const V2i p = click.texel;
    if (p.x < 0 || p.y < 0 || p.x >= size.x || p.y >= size.y)
      throw Error(ErrorKind::bad_data, fmt::format("click {}: expected a texel of the {} x {} tile, found ({}, {})", i,
                                                   size.x, size.y, p.x, p.y));
    if (!(click.height_01 >= 0.0f && click.height_01 <= 1.0f))
      throw Error(ErrorKind::bad_data, fmt::format("click {} at ({}, {}): expected a height of 0 to 1, found {}", i,
                                                   p.x, p.y, click.height_01));
    const auto [place, fresh] = known.try_emplace({p.y, p.x}, click.height_01);
    if (!fresh && place->second != click.height_01)
      throw Error(ErrorKind::bad_data, fmt::format("click {}: texel ({}, {}) has two heights, {} and {}: remove one", i,
                                                   p.x, p.y, place->second, click.height_01));
  }
}

// A click with its three turned descriptors.
struct DescribedClick {
  float height_01;
  std::array<Descriptor, 3> turns;
};

DescribedClick describe(const ClassGradients& gradients, const HeightClick& click) {
  return {
      click.height_01,
      {gradients.at(click.texel), gradients.turned(click.texel, -kTurn_rad), gradients.turned(click.texel, kTurn_rad)}};
}

// Keeps the clicks whose descriptors differ most: farthest first from the clicks already kept, starting with the first.
std::vector<DescribedClick> representatives(std::vector<DescribedClick> clicks, size_t most) {
  if (clicks.size() <= most) return clicks;
  std::vector<float> distance(clicks.size(), INFINITY);
  std::vector<DescribedClick> kept;
  size_t next = 0;
  while (kept.size() < most) {
    kept.push_back(clicks[next]);
    for (size_t i = 0; i < clicks.size(); ++i)
      distance[i] = std::min(distance[i], descriptor_distance(clicks[i].turns[0].data(), kept.back().turns[0].data()));
    next = static_cast<size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return kept;
}

NearestClicks search_among(const std::vector<DescribedClick>& clicks) {
  std::vector<Descriptor> descriptors;
  std::vector<int> click_of;
  for (size_t i = 0; i < clicks.size(); ++i)
    for (const Descriptor& turn : clicks[i].turns) {
      descriptors.push_back(turn);
      click_of.push_back(static_cast<int>(i));
    }
  return NearestClicks(std::move(descriptors), std::move(click_of));
}

// Inverse-distance mean; a click at distance 0 decides alone.
float interpolate(const std::vector<NearClick>& nearest, const std::vector<DescribedClick>& clicks) {
  const auto height = [&](const NearClick& near) { return clicks[static_cast<size_t>(near.click)].height_01; };
  if (nearest.front().distance == 0.0f) return height(nearest.front());
  double sum = 0.0;
  double weights = 0.0;
  for (const NearClick& near : nearest) {
    const double weight = 1.0 / near.distance;
    sum += weight * height(near);
    weights += weight;
  }
  return static_cast<float>(sum / weights);
}

}  // namespace

Heightmap heightmap(const PrincipalVariation& colors, const std::vector<HeightClick>& clicks,
                    const HeightmapOptions& options, const Progress& progress) {
  check_options(options);
  const V2i size(colors.index.width(), colors.index.height());
  check(clicks, size);
  const auto classes = static_cast<int>(colors.palette.classes.size());

  // Describe the clicks class by class, and reduce crowds to representatives.
  std::vector<std::vector<DescribedClick>> clicks_of_class(static_cast<size_t>(classes));
  std::vector<ClassGradients> gradients;
  for (int k = 0; k < classes; ++k) {
    gradients.emplace_back(colors, static_cast<uint8_t>(k));
    auto& own = clicks_of_class[static_cast<size_t>(k)];
    for (const HeightClick& click : clicks)
      if (colors.index(click.texel.x, click.texel.y) == k) own.push_back(describe(gradients.back(), click));
    own = representatives(std::move(own), static_cast<size_t>(options.max_representatives));
    report(progress, 0.5 * (k + 1) / classes);
  }
  std::vector<DescribedClick> all;
  Heightmap result;
  for (const auto& own : clicks_of_class) all.insert(all.end(), own.begin(), own.end());
  result.clicks_used = static_cast<int>(all.size());

  // Spread the heights; a class without a click looks among those of all classes.
  result.height_01 = Image<float>(size.x, size.y);
  for (int k = 0; k < classes; ++k) {
    const auto& own = clicks_of_class[static_cast<size_t>(k)];
    if (own.empty()) result.classes_without_click.push_back(k);
    const auto& used = own.empty() ? all : own;
    const NearestClicks search = search_among(used);
    parallel_for(0, size.y, [&](int y) {
      for (int x = 0; x < size.x; ++x)
        if (colors.index(x, y) == k)
          result.height_01(x, y) = interpolate(search.nearest(gradients[static_cast<size_t>(k)].at({x, y})), used);
    });
    report(progress, 0.5 + 0.5 * (k + 1) / classes);
  }
  return result;
}

}  // namespace texbake
