// Compiled once for each instruction set by Highway, which picks one at run time; whole numbers make all of them equal.
#include "libbake/content/impact_kernel.h"

#include <algorithm>
#include <array>
#include <numeric>

// Highway's emulation of 128-bit vectors is miscompiled by g++ before 12.3: processors without SSSE3 take plain loops.
#define HWY_BROKEN_EMU128 1
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libbake/content/impact_kernel.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "libbake/content/kernel_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace texbake {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR || !HWY_ARCH_X86

// Eq. 3 as it stands, for processors without x86's byte shuffles, whose lanes the vector code is written for.
class ChunkRunner {
 public:
  ChunkRunner(const DistanceField& field, uint32_t* sums) : field_(field), sums_(sums) {}

  void run(const Chunk& chunk, V2i t) {
    std::fill_n(sums_, chunk.sums.size() * kGroupSize, 0u);
    for (const Segment& segment : chunk.segments) {
      if (segment.kind != SegmentKind::sum && segment.kind != SegmentKind::extend) continue;
      for (int i = 0; i < segment.count; ++i)
        for (int lane = 0; lane < kGroupSize; ++lane)
          sums_[segment.sum * kGroupSize + static_cast<unsigned>(lane)] +=
              error(chunk.texel(segment.x + i, segment.y), t + V2i(lane % kGroupWidth, lane / kGroupWidth));
    }
  }

 private:
  uint32_t error(V2i p, V2i t) const {
    uint32_t around = 0;
    for (int dy = -kMaskRadius; dy <= kMaskRadius; ++dy)
      for (int dx = -kMaskRadius; dx <= kMaskRadius; ++dx) around += delta(p + V2i(dx, dy), t);
    return around * delta(p, t);
  }
  uint32_t delta(V2i p, V2i t) const { return field_.distance(*field_.class_at(p), *field_.class_at(p + t)); }

  const DistanceField& field_;
  uint32_t* sums_;
};

bool add_sums(const uint32_t* chunk_sums, int64_t limit, int64_t* patch_sums) {
  bool alive = false;
  for (size_t i = 0; i < kGroupSize; ++i) {
    patch_sums[i] += chunk_sums[i];
    alive |= patch_sums[i] <= limit;
  }
  return alive;
}

std::array<uint8_t, kGroupSize> lane_order() {
  std::array<uint8_t, kGroupSize> order{};
  std::iota(order.begin(), order.end(), uint8_t{0});
  return order;
}

#else

constexpr int kRingRows = 8;  // the seven rows of the mask and the one above, which `slide` takes away

// Runs the segments of chunks.
class ChunkRunner {
 public:
  HWY_ATTR ChunkRunner(const DistanceField& field, uint32_t* sums) : field_(field), sums_(sums) {}

  // `sums` receives kGroupSize numbers for each sum of the chunk, in the order of `lane_order`.
  HWY_ATTR void run(const Chunk& chunk, V2i t) {
    std::fill_n(sums_, chunk.sums.size() * kGroupSize, 0u);
    for (int lane = 0; lane < kGroupWidth; lane += static_cast<int>(hn::Lanes(d8))) {
      const V2i there = chunk.origin + t + V2i(lane, 0);
      if (field_.plane_count() == 1)
        run_lanes(chunk, OnePlane(field_, chunk, there), sums_ + lane);
      else
        run_lanes(chunk, ManyPlanes(field_, chunk, there), sums_ + lane);
    }
  }

 private:
  // δ of the texels of a chunk's frame: the distances of each one's class to those found a translation away.
  struct OnePlane {
    HWY_ATTR OnePlane(const DistanceField& field, const Chunk& chunk, V2i there_at)
        : here(field.class_at(chunk.origin)),
          there(field.plane_at(there_at)),
          tables(field.tables()),
          stride(field.stride()),
          to_right(chunk.rows == Rows::across ? 1 : stride),
          to_below(chunk.rows == Rows::across ? stride : 1) {}
    HWY_ATTR HWY_INLINE ptrdiff_t at(int x, int y) const { return x * to_right + y * to_below; }
    HWY_ATTR HWY_INLINE Bytes operator()(ptrdiff_t texel) const {
      const auto table = hn::LoadDup128(d8, tables + 16 * here[texel]);
      Bytes found;
      for (int r = 0; r < kGroupRows; ++r)
        found.row[r] = hn::TableLookupBytes(table, hn::LoadU(d8, there + texel + r * stride));
      return found;
    }
    const uint8_t* here;
    const uint8_t* there;
    const uint8_t* tables;
    ptrdiff_t stride;
    ptrdiff_t to_right, to_below;  // from a texel of the frame to the next one
  };
  struct ManyPlanes : OnePlane {
    HWY_ATTR ManyPlanes(const DistanceField& field, const Chunk& chunk, V2i there_at)
        : OnePlane(field, chunk, there_at), plane_count(field.plane_count()), plane_size(field.plane_size()) {}
    HWY_ATTR HWY_INLINE Bytes operator()(ptrdiff_t texel) const {
      Bytes found;
      for (int r = 0; r < kGroupRows; ++r) {
        found.row[r] = hn::Zero(d8);
        for (int k = 0; k < plane_count; ++k) {
          const auto table = hn::LoadDup128(d8, this->tables + 16 * (this->here[texel] * plane_count + k));
          const auto classes = hn::LoadU(d8, this->there + texel + r * this->stride + k * plane_size);
          found.row[r] = hn::Or(found.row[r], hn::TableLookupBytesOr0(table, classes));
        }
      }
      return found;
    }
    int plane_count;
    ptrdiff_t plane_size;
  };

  template <class DeltaOf>
  HWY_ATTR void run_lanes(const Chunk& chunk, const DeltaOf& delta_of, uint32_t* sums) {
    Window window{};
    for (const Segment& segment : chunk.segments) switch (segment.kind) {
        case SegmentKind::fetch:
          fetch(segment, delta_of);
          break;
        case SegmentKind::open:
          open(segment);
          break;
        case SegmentKind::slide:
          slide(segment, delta_of);
          break;
        case SegmentKind::sum:
          window = first_window(segment);
          [[fallthrough]];
        case SegmentKind::extend:
          sum(segment, window, sums + segment.sum * kGroupSize);
          break;
      }
  }

  HWY_ATTR HWY_INLINE uint8_t* delta(int x, int y) {
    return delta_ + static_cast<size_t>((y & (kRingRows - 1)) * kChunkStride + x) * slot();
  }
  HWY_ATTR HWY_INLINE uint16_t* column(int x) { return columns_ + static_cast<size_t>(1 + x) * slot(); }

  template <class DeltaOf>
  HWY_ATTR HWY_INLINE void fetch(const Segment& segment, const DeltaOf& delta_of) {
    ptrdiff_t texel = delta_of.at(segment.x, segment.y);
    uint8_t* out = delta(segment.x, segment.y);
    const int count = segment.count;
    for (int i = 0; i < count; ++i, texel += delta_of.to_right, out += slot()) store(delta_of(texel), out);
  }

  HWY_ATTR HWY_INLINE void open(const Segment& segment) {
    for (int x = segment.x; x < segment.x + segment.count; ++x) {
      Words sum = widen(load(delta(x, segment.y + kMaskRadius)));
      for (int y = segment.y - kMaskRadius; y < segment.y + kMaskRadius; ++y) sum = sum + widen(load(delta(x, y)));
      store(sum, column(x));
    }
  }

  template <class DeltaOf>
  HWY_ATTR HWY_INLINE void slide(const Segment& segment, const DeltaOf& delta_of) {
    const int row = segment.y + kMaskRadius;
    ptrdiff_t texel = delta_of.at(segment.x, row);
    uint8_t* entering = delta(segment.x, row);
    const uint8_t* leaving = delta(segment.x, row - kMaskSide);
    uint16_t* columns = column(segment.x);
    const int count = segment.count;
    for (int i = 0; i < count; ++i) {
      const Bytes fetched = delta_of(texel);
      store(load(columns) + widen(fetched) - widen(load(leaving)), columns);
      store(fetched, entering);
      texel += delta_of.to_right;
      entering += slot();
      leaving += slot();
      columns += slot();
    }
  }

  // M ∗ δ at a texel, and the first of the seven column sums in it.
  struct Window {
    Words box;
    const uint16_t* columns;

    HWY_ATTR HWY_INLINE void slide() {
      box = box + load(columns + kMaskSide * slot()) - load(columns);
      columns += slot();
    }
  };
  // That of the texel before the segment, so that each texel begins with a slide.
  HWY_ATTR HWY_INLINE Window first_window(const Segment& segment) {
    Window window;
    window.columns = column(segment.x - kMaskRadius - 1);
    window.box = load(window.columns);
    for (size_t i = 1; i < kMaskSide; ++i) window.box = window.box + load(window.columns + i * slot());
    return window;
  }

  HWY_ATTR HWY_INLINE void sum(const Segment& segment, Window& window, uint32_t* to) {
    const uint8_t* own = delta(segment.x, segment.y);
    const int count = segment.count;
    ErrorSums sums = load_sums(to);
    int i = 0;
    for (; i + 1 < count; i += 2, own += 2 * slot()) {
      window.slide();
      const Words first = window.box;
      window.slide();
      add_errors(load(own), first, load(own + slot()), window.box, sums);
    }
    if (i < count) {
      window.slide();
      Bytes none;
      for (size_t r = 0; r < kGroupRows; ++r) none.row[r] = hn::Zero(d8);
      add_errors(load(own), window.box, none, window.box, sums);
    }
    store_sums(sums, to);
  }

  const DistanceField& field_;
  uint32_t* sums_;
  alignas(64) uint8_t delta_[kRingRows * kChunkStride * kGroupSize];
  // One more in front: the window before the first one. What it holds cancels out.
  alignas(64) uint16_t columns_[(1 + kChunkStride) * kGroupSize] = {};
};

// Adds the sums of a chunk to those of a patch; whether one of them is still at most the limit.
HWY_ATTR bool add_sums(const uint32_t* chunk_sums, int64_t limit, int64_t* patch_sums) {
  const auto beyond = hn::Set(d64, limit);
  auto alive = hn::Gt(beyond, beyond);
  for (size_t i = 0; i < kGroupSize; i += hn::Lanes(d64)) {
    const auto added = hn::BitCast(d64, hn::PromoteTo(du64, hn::LoadU(d32_half, chunk_sums + i)));
    const auto sum = hn::Add(hn::LoadU(d64, patch_sums + i), added);
    hn::StoreU(sum, d64, patch_sums + i);
    alive = hn::Or(alive, hn::Not(hn::Gt(sum, beyond)));
  }
  return !hn::AllFalse(d64, alive);
}

// The translation of each place in a vector of sums: interleaving low and high bytes, and then low and high halves of
// products, shuffles the lanes inside each 128-bit block.
HWY_ATTR std::array<uint8_t, kGroupSize> lane_order() {
  std::array<uint8_t, kGroupSize> order{};
  const size_t n8 = hn::Lanes(d8);
  for (size_t place = 0; place < kGroupSize; ++place) {
    const size_t vector = place / n8;
    const size_t quarter = place % n8 / (n8 / 4);
    const size_t i = place % (n8 / 4);
    order[place] = static_cast<uint8_t>(vector * n8 + i / 4 * 16 + quarter * 4 + i % 4);
  }
  return order;
}

#endif

bool any_alive(const Chunk& chunk, const std::vector<uint8_t>& alive) {
  return std::any_of(chunk.sums.begin(), chunk.sums.end(), [&](const ChunkSum& sum) {
    return std::any_of(sum.patches.begin(), sum.patches.end(), [&](uint32_t patch) { return alive[patch] != 0; });
  });
}

size_t most_sums(const BorderProgram& program) {
  size_t most = 0;
  for (const Chunk& chunk : program) most = std::max(most, chunk.sums.size());
  return most;
}

// Adds the sums of a chunk to those of the patches that are alive.
HWY_ATTR void add_chunk_sums(const Chunk& chunk, const uint32_t* chunk_sums, const std::vector<int64_t>& limits,
                             GroupSums& group) {
  for (size_t s = 0; s < chunk.sums.size(); ++s)
    for (const uint32_t patch : chunk.sums[s].patches)
      if (group.alive[patch])
        group.alive[patch] =
            add_sums(chunk_sums + s * kGroupSize, limits[patch], group.sums.data() + patch * kGroupSize);
}

HWY_ATTR void AddGroupErrors(const BorderProgram& program, const std::vector<uint32_t>& order,
                             const DistanceField& field, const std::vector<int64_t>& limits,
                             std::span<GroupSums> groups) {
  const auto lanes = lane_order();
  const auto lane_of = [&](size_t place) { return place - place % kGroupSize + lanes[place % kGroupSize]; };
  for (GroupSums& group : groups) {
    std::vector<int64_t> shuffled(group.sums.size());
    for (size_t i = 0; i < shuffled.size(); ++i) shuffled[i] = group.sums[lane_of(i)];
    group.sums = std::move(shuffled);
  }

  std::vector<uint32_t> chunk_sums(kGroupSize * most_sums(program));
  ChunkRunner runner(field, chunk_sums.data());
  for (const uint32_t c : order) {
    const Chunk& chunk = program[c];
    for (GroupSums& group : groups) {
      if (!any_alive(chunk, group.alive)) continue;
      runner.run(chunk, group.translation);
      group.error_count += static_cast<uint64_t>(chunk.texel_count) * kGroupSize;
      add_chunk_sums(chunk, chunk_sums.data(), limits, group);
    }
  }

  for (GroupSums& group : groups) {
    std::vector<int64_t> in_order(group.sums.size());
    for (size_t i = 0; i < in_order.size(); ++i) in_order[lane_of(i)] = group.sums[i];
    group.sums = std::move(in_order);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace texbake
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace texbake {

HWY_EXPORT(AddGroupErrors);

void add_group_errors(const BorderProgram& program, const std::vector<uint32_t>& order, const DistanceField& field,
                      const std::vector<int64_t>& limits, std::span<GroupSums> groups) {
  HWY_DYNAMIC_DISPATCH(AddGroupErrors)(program, order, field, limits, groups);
}

}  // namespace texbake
#endif  // HWY_ONCE
