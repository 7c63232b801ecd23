#include "libbake/height/click_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texbake {
namespace {

double power(double base, int exponent) {
  double result = 1.0;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

}  // namespace

ClickSet::ClickSet(DescriptorSpace space, int turns) : space_(space), turns_(turns) {}

void ClickSet::add(float height_01, const std::vector<float>& turned_descriptors) {
  heights_.push_back(height_01);
  descriptors_.insert(descriptors_.end(), turned_descriptors.begin(), turned_descriptors.end());
}

void ClickSet::reduce(int most) {
  if (count() <= most) return;
  std::vector<float> distance(heights_.size(), INFINITY);
  ClickSet kept(space_, turns_);
  size_t next = 0;
  while (kept.count() < most) {
    kept.add(heights_[next], {upright(next), upright(next) + stride()});
    for (size_t i = 0; i < distance.size(); ++i)
      distance[i] = std::min(distance[i], space_.distance(upright(i), upright(next)));
    next = static_cast<size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  *this = std::move(kept);
}

void ClickSet::build() { search_.emplace(space_, descriptors_, turns_); }

float ClickSet::height_of(const float* descriptor, const Blend& blend) const {
  const std::vector<NearClick> nearest = search_->nearest(descriptor, blend.nearest);
  const auto height = [&](const NearClick& near) { return heights_[static_cast<size_t>(near.click)]; };
  // Weights relative to the nearest click's, so that no power overflows.
  const double least = nearest.front().distance;
  if (least == 0.0) return height(nearest.front());
  double sum = 0.0;
  double weights = 0.0;
  for (const NearClick& near : nearest) {
    const double weight = power(least / near.distance, blend.falloff);
    sum += weight * height(near);
    weights += weight;
  }
  return static_cast<float>(sum / weights);
}

}  // namespace texbake
