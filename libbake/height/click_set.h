// Clicks with their descriptors, and the height that another descriptor takes from the nearest of them.
#pragma once

#include <optional>
#include <vector>

#include "libbake/height/nearest_clicks.h"

namespace texbake {

/// How heights are blended from the nearest clicks: weights 1 / distance^falloff.
struct Blend {
  int nearest = 8;
  int falloff = 2;
};

class ClickSet {
 public:
  /// Every click has `turns` descriptors, of which the first is the upright one.
  ClickSet(DescriptorSpace space, int turns);

  int count() const { return static_cast<int>(heights_.size()); }
  void add(float height_01, const std::vector<float>& turned_descriptors);
  /// Keeps up to `most` clicks whose upright descriptors differ most: farthest first from those already kept, starting
  /// with the first click.
  void reduce(int most);
  /// To be called once all clicks are there, of which there is one or more.
  void build();
  /// The weighted mean of the nearest clicks; a click at distance 0 decides alone.
  float height_of(const float* descriptor, const Blend& blend) const;

 private:
  const float* upright(size_t click) const { return descriptors_.data() + click * stride(); }
  size_t stride() const { return static_cast<size_t>(turns_) * space_.length; }

  DescriptorSpace space_;
  int turns_;
  std::vector<float> heights_;
  std::vector<float> descriptors_;
  std::optional<NearestClicks> search_;
};

}  // namespace texbake
