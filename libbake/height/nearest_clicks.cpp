#include "libbake/height/nearest_clicks.h"

#include <algorithm>
#include <flann/flann.hpp>

namespace texbake {
namespace {

constexpr size_t kNearest = 3;
constexpr size_t kTurns = 3;

// Eq. 7 as a FLANN distance.
struct GradientDistance {
  using ElementType = float;
  using ResultType = float;
  template <class A, class B>
  float operator()(A a, B b, size_t, float = -1) const {
    return descriptor_distance(&*a, &*b);
  }
};

}  // namespace

struct NearestClicks::Index {
  std::vector<Descriptor> descriptors;
  std::vector<int> click_of;
  flann::Index<GradientDistance> flann;

  Index(std::vector<Descriptor> all, std::vector<int> owners)
      : descriptors(std::move(all)),
        click_of(std::move(owners)),
        flann(flann::Matrix<float>(descriptors.front().data(), descriptors.size(), descriptors.front().size()),
              flann::LinearIndexParams()) {
    flann.buildIndex();
  }
};

NearestClicks::NearestClicks(std::vector<Descriptor> descriptors, std::vector<int> click_of)
    : index_(std::make_unique<Index>(std::move(descriptors), std::move(click_of))) {}
NearestClicks::~NearestClicks() = default;
NearestClicks::NearestClicks(NearestClicks&&) noexcept = default;
NearestClicks& NearestClicks::operator=(NearestClicks&&) noexcept = default;

std::vector<NearClick> NearestClicks::nearest(const Descriptor& query) const {
  // Three turns of each of three clicks: the nearest nine hold the nearest three clicks.
  const size_t wanted = std::min(kNearest * kTurns, index_->descriptors.size());
  size_t found[kNearest * kTurns];
  float distance[kNearest * kTurns];
  Descriptor copy = query;
  flann::Matrix<float> queries(copy.data(), 1, copy.size());
  flann::Matrix<size_t> indices(found, 1, wanted);
  flann::Matrix<float> distances(distance, 1, wanted);
  index_->flann.knnSearch(queries, indices, distances, wanted, flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));

  std::vector<NearClick> all;
  for (size_t i = 0; i < wanted; ++i) all.push_back({index_->click_of[found[i]], distance[i]});
  std::sort(all.begin(), all.end(), [](const NearClick& a, const NearClick& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.click < b.click;
  });
  std::vector<NearClick> result;
  for (const NearClick& candidate : all) {
    const bool known = std::any_of(result.begin(), result.end(),
                                   [&](const NearClick& other) { return other.click == candidate.click; });
    if (!known && result.size() < kNearest) result.push_back(candidate);
  }
  return result;
}

}  // namespace texbake
