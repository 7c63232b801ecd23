// The clicks nearest to a descriptor, by FLANN's exact linear index with a distance of ours.
#pragma once

#include <memory>
#include <vector>

namespace texbake {

struct NearClick {
  int click = 0;       ///< as numbered when the search was built
  float distance = 0;  ///< least over the click's turns
};

/// Descriptors of `length` numbers each and what lies between two of them.
struct DescriptorSpace {
  size_t length;
  float (*distance)(const float*, const float*);
};

class NearestClicks {
 public:
  /// `descriptors` holds all turns of the first click, `turns` of them, then those of the next, and so on.
  NearestClicks(DescriptorSpace space, std::vector<float> descriptors, int turns);
  ~NearestClicks();
  NearestClicks(NearestClicks&&) noexcept;
  NearestClicks& operator=(NearestClicks&&) noexcept;

  /// The up to `count` nearest distinct clicks, nearest first; of equal distances the lowest number.
  std::vector<NearClick> nearest(const float* query, int count) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace texbake
