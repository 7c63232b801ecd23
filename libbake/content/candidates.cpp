#include "libbake/content/candidates.h"

#include "libbake/content/take_apart.h"

namespace texbake {
namespace {

bool by_error(const Candidate& a, const Candidate& b) {
  if (a.error_sum != b.error_sum) return a.error_sum < b.error_sum;
  if (a.translation.y != b.translation.y) return a.translation.y < b.translation.y;
  if (a.translation.x != b.translation.x) return a.translation.x < b.translation.x;
  return a.turn < b.turn;
}

}  // namespace

Candidates take_separated(const Candidates& found, V2i size, const SearchRequest& request) {
  const auto translation_of = [&](uint32_t i) { return found[i].translation; };
  const auto before = [&](uint32_t i, uint32_t j) { return by_error(found[i], found[j]); };
  TakeApart left(static_cast<uint32_t>(found.size()), size, request.separation_px, translation_of, before);
  left.leave_out({0, 0});
  Candidates taken;
  while (taken.size() < static_cast<size_t>(request.count)) {
    const uint32_t best = left.take();
    if (best == left.kNone) break;
    taken.push_back(found[best]);
  }
  return taken;
}

}  // namespace texbake
