// The clicks nearest to a descriptor, by FLANN's exact linear index with the paper's distance.
#pragma once

#include <memory>
#include <vector>

#include "libbake/height/descriptor.h"

namespace texbake {

struct NearClick {
  int click = 0;       ///< as numbered when the search was built
  float distance = 0;  ///< least over the click's turns
};

class NearestClicks {
 public:
  /// `descriptors` holds every turn of every click; `click_of[i]` tells whose the i-th is.
  NearestClicks(std::vector<Descriptor> descriptors, std::vector<int> click_of);
  ~NearestClicks();
  NearestClicks(NearestClicks&&) noexcept;
  NearestClicks& operator=(NearestClicks&&) noexcept;

  /// The up to three nearest distinct clicks, nearest first; of equal distances the lowest number.
  std::vector<NearClick> nearest(const Descriptor& query) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace texbake
