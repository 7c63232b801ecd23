#include "formats/normal_vectors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace texbake {
namespace {

constexpr float kUnitLengthTolerance = 0.05f;  // of a length: codes of 8 bits are within 0.014
constexpr float kUnitShare = 0.99f;            // of the texels of a map of vectors; a few may be gaps

bool is_unit(float x, float y, float z) {
  return std::fabs(std::sqrt(x * x + y * y + z * z) - 1) <= kUnitLengthTolerance;
}

size_t count_unit(const Image<float> (&planes)[3]) {
  size_t count = 0;
  for (size_t i = 0; i < planes[0].size(); ++i)
    if (is_unit(planes[0].data()[i], planes[1].data()[i], planes[2].data()[i])) ++count;
  return count;
}

// Do floats hold −1 … 1 as 0 … 1?
bool is_shifted(const Image<float> (&planes)[3], size_t stored) {
  const auto has_negative = [](const Image<float>& plane) {
    return std::any_of(plane.begin(), plane.end(), [](float value) { return value < 0; });
  };
  if (std::any_of(planes, planes + stored, has_negative)) return false;
  return stored < 3 || static_cast<float>(count_unit(planes)) < kUnitShare * static_cast<float>(planes[0].size());
}

// z from x and y; returns how many texels have none.
size_t add_z(Image<float> (&planes)[3]) {
  size_t impossible = 0;
  for (size_t i = 0; i < planes[0].size(); ++i) {
    const float x = planes[0].data()[i], y = planes[1].data()[i];
    const float square = 1 - x * x - y * y;
    if (square < -2 * kUnitLengthTolerance) ++impossible;
    planes[2].data()[i] = square > 0 ? std::sqrt(square) : 0;
  }
  return impossible;
}

bool is_everywhere(const Image<float>& plane, float value) {
  return std::all_of(plane.begin(), plane.end(), [value](float other) { return other == value; });
}

}  // namespace

std::vector<std::string> finish_normals(Image<float> (&planes)[3], size_t stored, NormalNumbers numbers) {
  std::vector<std::string> notes;
  const bool lacks_z = stored == 2 || is_everywhere(planes[2], numbers == NormalNumbers::codes ? -1.0f : 0.0f);
  if (numbers == NormalNumbers::floats && is_shifted(planes, lacks_z ? 2 : 3)) {
    for (Image<float>& plane : planes)
      for (float& value : plane) value = 2 * value - 1;
    notes.emplace_back("no component is negative: 0 to 1 is taken to mean -1 to 1");
  }
  if (lacks_z) {
    planes[2] = Image<float>(planes[0].width(), planes[0].height());
    const size_t impossible = add_z(planes);
    notes.push_back(fmt::format("it has no z (blue): computed from x and y as sqrt(1 - x^2 - y^2){}",
                                impossible ? fmt::format("; {} texels are longer than 1 already", impossible) : ""));
    return notes;
  }
  const size_t total = planes[0].size(), unit = count_unit(planes);
  if (unit < total)
    notes.push_back(fmt::format("{} of {} vectors are not of unit length (more than {:g} % off)", total - unit, total,
                                100 * kUnitLengthTolerance));
  return notes;
}

}  // namespace texbake
