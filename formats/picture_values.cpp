#include "formats/picture_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "libbake/base/error.h"
#include "libbake/base/portable_math.h"
#include "libbake/color/luv.h"

namespace texbake {
namespace {

struct Offenders {
  size_t count = 0;
  V2i first{0};
  float value = 0;
};

// The texels where any plane is bad.
template <class IsBad>
std::optional<Offenders> find_offenders(const std::vector<ImageView<const float>>& planes, const IsBad& is_bad) {
  Offenders found;
  for (size_t i = 0; i < planes[0].size(); ++i)
    for (const ImageView<const float>& plane : planes) {
      const float value = plane.data()[i];
      if (!is_bad(value)) continue;
      const auto width = static_cast<size_t>(plane.width());
      if (found.count == 0) found = {0, V2i(static_cast<int>(i % width), static_cast<int>(i / width)), value};
      ++found.count;
      break;
    }
  return found.count ? std::optional(found) : std::nullopt;
}

// The value of a table over 0 … 1 at `at_01` ≥ 0; NaN and infinity stay.
float interpolate(const std::vector<float>& table, float at_01) {
  if (!std::isfinite(at_01)) return at_01;
  const float place = at_01 * static_cast<float>(table.size() - 1);
  const size_t left = std::min(static_cast<size_t>(std::min(place, 1e9f)), table.size() - 2);
  const float share = place - static_cast<float>(left);
  return share == 0   ? table[left]
         : share == 1 ? table[left + 1]
                      : table[left] + share * (table[left + 1] - table[left]);
}

}  // namespace

InputCurve InputCurve::exact_power(double gamma) {
  return gamma == 1 ? linear() : InputCurve(gamma, fmt::format("gamma {:.3g}", gamma));
}

InputCurve InputCurve::power(double gamma) { return std::fabs(gamma - 2.2) <= 0.05 ? srgb() : exact_power(gamma); }

InputCurve InputCurve::sampled(std::vector<float> table, const std::string& name) {
  assert(table.size() >= 2);
  InputCurve curve(1, name);
  curve.table_ = std::make_shared<const std::vector<float>>(std::move(table));
  return curve;
}

float InputCurve::decode(float encoded) const {
  if (table_) return std::copysign(interpolate(*table_, std::fabs(encoded)), encoded);
  if (gamma_ == 0) return linear_from_srgb(encoded);
  if (gamma_ == 1) return encoded;
  return std::copysign(static_cast<float>(portable_pow(std::fabs(encoded), gamma_)), encoded);
}

V2i upright_size(V2i stored, int orientation) { return orientation >= 5 ? V2i(stored.y, stored.x) : stored; }

V2i upright_place(V2i p, V2i stored, int orientation) {
  const V2i opposite(stored.x - 1 - p.x, stored.y - 1 - p.y);
  switch (orientation) {
    case 2:
      return {opposite.x, p.y};
    case 3:
      return opposite;
    case 4:
      return {p.x, opposite.y};
    case 5:
      return {p.y, p.x};
    case 6:
      return {opposite.y, p.x};
    case 7:
      return {opposite.y, opposite.x};
    case 8:
      return {p.y, opposite.x};
    default:
      return p;
  }
}

void check_finite(const std::string& path, const std::vector<ImageView<const float>>& planes) {
  if (const auto found = find_offenders(planes, [](float value) { return !std::isfinite(value); }))
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: expected finite values, found NaN or infinity in {} of {} texels, the first at ({}, "
                            "{}); repair the picture in the program that made it",
                            path, found->count, planes[0].size(), found->first.x, found->first.y));
}

void check_largest(const std::string& path, const std::vector<ImageView<const float>>& planes, float largest) {
  if (const auto found = find_offenders(planes, [&](float value) { return value > largest; }))
    throw Error(ErrorKind::bad_data, fmt::format("{}: expected colors up to {:g} (half float), found {} of {} texels "
                                                 "above, the first at ({}, {}) with {:g}; scale its exposure down",
                                                 path, largest, found->count, planes[0].size(), found->first.x,
                                                 found->first.y, found->value));
}

}  // namespace texbake
