#include "libbake/content/class_distances.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace texbake {
namespace {

double squared_distance(const V3f& a, const V3f& b) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += d * d;
  }
  return sum;
}

}  // namespace

ClassDistances class_distances(std::span<const V3f> mean_luv) {
  assert(!mean_luv.empty() && mean_luv.size() <= static_cast<size_t>(kMaxContentClasses));
  double largest = 0.0;
  for (const V3f& a : mean_luv)
    for (const V3f& b : mean_luv) largest = std::max(largest, squared_distance(a, b));

  ClassDistances distances;
  distances.class_count = static_cast<int>(mean_luv.size());
  distances.step = largest > 0.0 ? largest / kMaxDistanceSteps : 1.0;
  for (const V3f& a : mean_luv)
    for (const V3f& b : mean_luv)
      distances.steps.push_back(static_cast<uint8_t>(std::floor(squared_distance(a, b) / distances.step + 0.5)));
  return distances;
}

}  // namespace texbake
