#include "libbake/content/group_search.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>

#include "libbake/base/parallel.h"
#include "libbake/content/take_apart.h"

namespace texbake {
namespace {

constexpr int kWiderAttempts = 3;          // with limits half as wide again each; after them there are none
constexpr size_t kFirstRoundShare = 64;    // the first round, which knows no limits yet, takes 1/64 of the tasks
constexpr size_t kLongestRoundShare = 16;  // what a round finds is there twice while it is merged

// Translations and their sums in 8 bytes each, since millions are kept at a time: the sum above the place y · width +
// x, so that numbers are ordered as candidates are.
class FoundPacking {
 public:
  explicit FoundPacking(V2i size)
      : width_(static_cast<uint64_t>(size.x)),
        place_bits_(std::max(static_cast<int>(std::bit_width(width_ * static_cast<uint64_t>(size.y) - 1)), 1)) {}

  // The largest sum there is room for: 44 bits at 1024², where no sum needs more than 42, and 40 bits at 4096², enough
  // for 345 000 texels of the largest error.
  int64_t largest_sum() const { return std::min(kExcluded - 1, static_cast<int64_t>(~uint64_t{0} >> place_bits_)); }
  uint64_t pack(V2i t, int64_t sum) const {
    return static_cast<uint64_t>(sum) << place_bits_ |
           (static_cast<uint64_t>(t.y) * width_ + static_cast<uint64_t>(t.x));
  }
  uint64_t error_sum(uint64_t found) const { return found >> place_bits_; }
  V2i translation(uint64_t found) const {
    const auto place = static_cast<uint32_t>(found & ((uint64_t{1} << place_bits_) - 1));
    const auto width = static_cast<uint32_t>(width_);
    return {static_cast<int>(place % width), static_cast<int>(place / width)};
  }

 private:
  uint64_t width_;
  int place_bits_;
};

// One search: rounds of tasks, each at most as long as all before it, with limits learnt from what the earlier rounds
// found.
class Rounds {
 public:
  Rounds(V2i size, const BorderProgram& program, const DistanceField& field, const std::vector<uint32_t>& order,
         int patch_count, const SearchRequest& request)
      : size_(size),
        packing_(size),
        no_limit_(packing_.largest_sum()),
        program_(program),
        field_(field),
        order_(order),
        request_(request),
        open_(static_cast<size_t>(patch_count), 1),
        limits_(static_cast<size_t>(patch_count), no_limit_),
        found_(static_cast<size_t>(patch_count)),
        taken_(static_cast<size_t>(patch_count)) {}

  void run(std::span<const GroupTask> tasks, const Progress& progress) {
    const size_t first = (tasks.size() / kFirstRoundShare / kBatch + 1) * kBatch;
    const size_t longest = (tasks.size() / kLongestRoundShare / kBatch + 1) * kBatch;
    size_t learnt = 0;
    for (size_t begin = 0; begin < tasks.size();) {
      const size_t end = std::min(tasks.size(), std::max(first, begin + std::min(begin, longest)));
      run_round(tasks.subspan(begin, end - begin));
      begin = end;
      if (begin < tasks.size() && begin >= 2 * learnt) {
        learn_limits();
        learnt = begin;
      }
      if (attempts_ == 0) report_progress(progress, static_cast<double>(begin) / static_cast<double>(tasks.size()));
    }
    take_all();
  }

  // Opens again, with a wider limit, every patch whose limit proved too narrow. Whether there was one.
  bool widen() {
    bool any = false;
    for (size_t patch = 0; patch < open_.size(); ++patch) {
      if (!open_[patch]) continue;
      open_[patch] = taken_[patch].size() < static_cast<size_t>(request_.count) && limits_[patch] < no_limit_;
      if (!open_[patch]) continue;
      any = true;
      limits_[patch] = attempts_ < kWiderAttempts ? limits_[patch] + limits_[patch] / 2 + 1 : no_limit_;
    }
    ++attempts_;
    return any;
  }

  SearchResult result() const {
    SearchResult result;
    result.candidates = taken_;
    result.error_count = error_count_;
    return result;
  }

 private:
  void run_round(std::span<const GroupTask> tasks) {
    struct Batch {
      std::vector<std::vector<uint64_t>> found;  // of each patch
      uint64_t error_count = 0;
    };
    std::vector<Batch> batches((tasks.size() + kBatch - 1) / kBatch);
    parallel_for(0, static_cast<int>(batches.size()), [&](int b) {
      Batch& batch = batches[static_cast<size_t>(b)];
      const size_t begin = static_cast<size_t>(b) * kBatch;
      std::vector<GroupSums> groups;
      for (const GroupTask& task : tasks.subspan(begin, std::min<size_t>(kBatch, tasks.size() - begin)))
        groups.push_back(start(task));
      add_group_errors(program_, order_, field_, limits_, groups);
      batch.found.resize(open_.size());
      for (const GroupSums& group : groups) {
        batch.error_count += group.error_count;
        for (size_t patch = 0; patch < open_.size(); ++patch) add_survivors(group, patch, batch.found[patch]);
      }
    });
    for (const Batch& batch : batches) error_count_ += batch.error_count;
    parallel_for(0, static_cast<int>(open_.size()), [&](int p) {
      const auto patch = static_cast<size_t>(p);
      size_t count = found_[patch].size();
      for (const Batch& batch : batches) count += batch.found[patch].size();
      found_[patch].reserve(count);  // no more than needed: this is most of the memory of a search
      for (const Batch& batch : batches)
        found_[patch].insert(found_[patch].end(), batch.found[patch].begin(), batch.found[patch].end());
    });
  }

  static V2i translation(V2i first, int lane) { return first + V2i(lane % kGroupWidth, lane / kGroupWidth); }

  // Translations beyond the borders, which only fill the lanes, those near the identity, and those that are not allowed
  // take no part.
  GroupSums start(const GroupTask& task) const {
    GroupSums group;
    group.translation = task.translation;
    group.alive = open_;
    for (size_t patch = 0; patch < task.wanted.size(); ++patch) group.alive[patch] &= task.wanted[patch];
    for (size_t patch = 0; patch < open_.size(); ++patch)
      for (int lane = 0; lane < kGroupSize; ++lane) {
        const V2i t = translation(task.translation, lane);
        const bool allowed = t.x < size_.x && t.y < size_.y && far_enough(t, {0, 0}, size_, request_.separation_px) &&
                             (request_.allowed.empty() || request_.allowed(t.x, t.y));
        group.sums.push_back(allowed ? 0 : kExcluded);
      }
    return group;
  }

  void add_survivors(const GroupSums& group, size_t patch, std::vector<uint64_t>& found) const {
    if (!group.alive[patch]) return;
    for (int lane = 0; lane < kGroupSize; ++lane) {
      const int64_t sum = group.sums[patch * kGroupSize + static_cast<size_t>(lane)];
      if (sum > limits_[patch]) continue;
      found.push_back(packing_.pack(translation(group.translation, lane), sum));
    }
  }

  // take_separated of what a patch has found.
  Candidates take(size_t patch, int count) const {
    const std::vector<uint64_t>& found = found_[patch];
    const auto translation_of = [&](uint32_t i) { return packing_.translation(found[i]); };
    const auto before = [&](uint32_t i, uint32_t j) { return found[i] < found[j]; };
    TakeApart left(static_cast<uint32_t>(found.size()), size_, request_.separation_px, translation_of, before);
    Candidates taken;
    while (taken.size() < static_cast<size_t>(count)) {
      const uint32_t best = left.take();
      if (best == left.kNone) break;
      taken.push_back({translation_of(best), packing_.error_sum(found[best])});
    }
    return taken;
  }

  void take_all() {
    parallel_for(0, static_cast<int>(open_.size()), [&](int i) {
      const auto patch = static_cast<size_t>(i);
      if (open_[patch]) taken_[patch] = take(patch, request_.count);
      found_[patch] = {};
    });
  }

  // A limit is the sum of the last candidate among those found so far. Of many a few more are required than asked for,
  // since a better translation found later may stand in the way of two.
  void learn_limits() {
    if (attempts_ > 0) return;  // what is learnt from the same tasks would be too narrow again
    const int wider_count = request_.count + request_.count / 16;
    parallel_for(0, static_cast<int>(open_.size()), [&](int i) {
      const auto patch = static_cast<size_t>(i);
      if (!open_[patch]) return;
      const Candidates taken = take(patch, wider_count);
      if (taken.size() < static_cast<size_t>(wider_count)) return;
      limits_[patch] = std::min(limits_[patch], static_cast<int64_t>(taken.back().error_sum));
      std::erase_if(found_[patch],
                    [&](uint64_t found) { return packing_.error_sum(found) > static_cast<uint64_t>(limits_[patch]); });
    });
  }

  V2i size_;
  FoundPacking packing_;
  int64_t no_limit_;
  const BorderProgram& program_;
  const DistanceField& field_;
  const std::vector<uint32_t>& order_;
  SearchRequest request_;
  std::vector<uint8_t> open_;
  std::vector<int64_t> limits_;
  std::vector<std::vector<uint64_t>> found_;  // packed; not beyond the limits, of the tasks so far
  std::vector<Candidates> taken_;
  uint64_t error_count_ = 0;
  int attempts_ = 0;
};

// Chunks with much error for their work first: hopeless translations are given up soon.
std::vector<uint32_t> chunk_order(const BorderProgram& program) {
  std::vector<uint32_t> order(program.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return program[a].expected_error * program[b].texel_count > program[b].expected_error * program[a].texel_count;
  });
  return order;
}

}  // namespace

GroupSearch::GroupSearch(ImageView<const uint8_t> classes, const ClassDistances& distances, const PatchBorders& borders)
    : size_(classes.width(), classes.height()),
      patch_count_(borders.patch_count),
      program_(border_program(borders, classes, distances)),
      field_(classes, distances),
      order_(chunk_order(program_)) {}

SearchResult GroupSearch::run(const std::vector<GroupTask>& tasks, const SearchRequest& request,
                              const Progress& progress) const {
  Rounds rounds(size_, program_, field_, order_, patch_count_, request);
  do rounds.run(tasks, progress);
  while (rounds.widen());
  return rounds.result();
}

std::vector<int> scattered_batches(int count) {
  const int64_t batches = (count + kBatch - 1) / kBatch;
  if (batches == 0) return {};
  auto step = static_cast<int64_t>(static_cast<double>(batches) * 0.6180339887498949);
  while (std::gcd(step, batches) != 1) ++step;
  std::vector<int> order;
  for (int64_t i = 0; i < batches; ++i) {
    const auto begin = static_cast<int>(i * step % batches) * kBatch;
    for (int j = begin; j < std::min(begin + kBatch, count); ++j) order.push_back(j);
  }
  return order;
}

}  // namespace texbake
