#include "libbake/height/nearest_clicks.h"

#include <algorithm>
#include <flann/flann.hpp>

namespace texbake {
namespace {

// A distance of ours as FLANN wants it.
struct SpaceDistance {
  using ElementType = float;
  using ResultType = float;
  float (*distance)(const float*, const float*) = nullptr;
  template <class A, class B>
  float operator()(A a, B b, size_t, float = -1) const {
    return distance(&*a, &*b);
  }
};

}  // namespace

struct NearestClicks::Index {
  std::vector<float> descriptors;
  size_t length;
  int turns;
  flann::Index<SpaceDistance> flann;

  Index(DescriptorSpace space, std::vector<float> all, int turns_each)
      : descriptors(std::move(all)),
        length(space.length),
        turns(turns_each),
        flann(flann::Matrix<float>(descriptors.data(), descriptors.size() / length, length), flann::LinearIndexParams(),
              SpaceDistance{space.distance}) {
    flann.buildIndex();
  }
};

NearestClicks::NearestClicks(DescriptorSpace space, std::vector<float> descriptors, int turns)
    : index_(std::make_unique<Index>(space, std::move(descriptors), turns)) {}
NearestClicks::~NearestClicks() = default;
NearestClicks::NearestClicks(NearestClicks&&) noexcept = default;
NearestClicks& NearestClicks::operator=(NearestClicks&&) noexcept = default;

std::vector<NearClick> NearestClicks::nearest(const float* query, int count) const {
  // The nearest turns × count descriptors hold the nearest count clicks.
  const auto turns = static_cast<size_t>(index_->turns);
  const size_t wanted = std::min(turns * static_cast<size_t>(count), index_->descriptors.size() / index_->length);
  std::vector<size_t> found(wanted);
  std::vector<float> distance(wanted);
  std::vector<float> copy(query, query + index_->length);
  const flann::Matrix<float> queries(copy.data(), 1, copy.size());
  flann::Matrix<size_t> indices(found.data(), 1, wanted);
  flann::Matrix<float> distances(distance.data(), 1, wanted);
  index_->flann.knnSearch(queries, indices, distances, wanted, flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));

  std::vector<NearClick> all;
  for (size_t i = 0; i < wanted; ++i) all.push_back({static_cast<int>(found[i] / turns), distance[i]});
  std::sort(all.begin(), all.end(), [](const NearClick& a, const NearClick& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.click < b.click;
  });
  std::vector<NearClick> result;
  for (const NearClick& candidate : all) {
    const bool known = std::any_of(result.begin(), result.end(),
                                   [&](const NearClick& other) { return other.click == candidate.click; });
    if (!known && result.size() < static_cast<size_t>(count)) result.push_back(candidate);
  }
  return result;
}

}  // namespace texbake
