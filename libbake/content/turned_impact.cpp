#include "libbake/content/turned_impact.h"

#include <algorithm>

namespace texbake {
namespace {

bool is_same_turn(const Content& a, const Content& b) { return a.a == b.a && a.b == b.b; }

}  // namespace

TurnedImpact::TurnedImpact(ImageView<const uint8_t> classes, const ClassDistances& distances,
                           std::span<const V2i> border, V2i center)
    : classes_(classes), distances_(distances), center_(center) {
  // The frame around the border and its masks.
  V2i least(0, 0), most(0, 0);
  for (const V2i& d : border) {
    least = {std::min(least.x, d.x), std::min(least.y, d.y)};
    most = {std::max(most.x, d.x), std::max(most.y, d.y)};
  }
  origin_ = least - V2i(kMaskRadius, kMaskRadius);
  const V2i frame = most + V2i(kMaskRadius + 1, kMaskRadius + 1) - origin_;
  delta_ = Image<uint8_t>(frame.x, frame.y);
  columns_.resize(static_cast<size_t>(frame.x));
  find_rows(border);

  const V2i size(classes.width(), classes.height());
  for (const V2i& p : seen_) {
    const V2i texel = wrap(center + origin_ + p, size);
    own_.push_back(classes(texel.x, texel.y));
  }
  turn(turned_);
}

void TurnedImpact::find_rows(std::span<const V2i> border) {
  Image<uint8_t> is_border(delta_.width(), delta_.height()), is_seen(delta_.width(), delta_.height());
  for (const V2i& d : border) {
    const V2i p = d - origin_;
    is_border(p.x, p.y) = 1;
    for (int dy = -kMaskRadius; dy <= kMaskRadius; ++dy)
      for (int dx = -kMaskRadius; dx <= kMaskRadius; ++dx) is_seen(p.x + dx, p.y + dy) = 1;
  }
  for (int y = 0; y < is_seen.height(); ++y)
    for (int x = 0; x < is_seen.width(); ++x) {
      if (is_seen(x, y)) seen_.emplace_back(x, y);
      if (!is_border(x, y)) continue;
      if (is_border(x - 1, y))
        ++runs_.back().count;
      else
        runs_.push_back({x, y, 1});
    }
}

void TurnedImpact::turn(const Content& content) {
  turned_ = content;
  turned_.translation = {0, 0};
  sources_.clear();
  for (const V2i& p : seen_) sources_.push_back(source_offset(turned_, p + origin_));
}

void TurnedImpact::measure_distances(V2i translation) {
  // No wrapping by division: turned offsets are less than two tiles away, each way.
  const V2i size(classes_.width(), classes_.height());
  const V2i moved = wrap(center_ + translation, size);
  const auto once = [](int x, int n) {
    while (x < 0) x += n;
    while (x >= n) x -= n;
    return x;
  };
  for (size_t i = 0; i < seen_.size(); ++i) {
    const V2i source = moved + sources_[i];
    delta_(seen_[i].x, seen_[i].y) = distances_.at(own_[i], classes_(once(source.x, size.x), once(source.y, size.y)));
  }
}

uint64_t TurnedImpact::error_sum(const Content& content) {
  if (!is_same_turn(content, turned_)) turn(content);
  measure_distances(content.translation);

  // M ∗ δ by running sums, down the columns and along the runs.
  std::fill(columns_.begin(), columns_.end(), uint16_t{0});
  uint64_t sum = 0;
  auto run = runs_.begin();
  for (int entering = 0; entering < delta_.height(); ++entering) {
    const uint8_t* in = delta_.row(entering);
    for (size_t x = 0; x < columns_.size(); ++x) columns_[x] = static_cast<uint16_t>(columns_[x] + in[x]);
    if (entering >= kMaskSide) {
      const uint8_t* out = delta_.row(entering - kMaskSide);
      for (size_t x = 0; x < columns_.size(); ++x) columns_[x] = static_cast<uint16_t>(columns_[x] - out[x]);
    }
    for (; run != runs_.end() && run->y == entering - kMaskRadius; ++run) {
      const uint16_t* column = columns_.data() + run->x - kMaskRadius;
      const uint8_t* own = delta_.row(run->y) + run->x;
      uint32_t box = 0;
      for (int i = 0; i < kMaskSide - 1; ++i) box += column[i];
      for (int i = 0; i < run->count; ++i) {
        box += column[i + kMaskSide - 1];
        sum += uint64_t{box} * own[i];
        box -= column[i];
      }
    }
  }
  return sum;
}

}  // namespace texbake
