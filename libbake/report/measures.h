// What a report measures: the numbers, their names, and what they mean to a person.
// Based on: the quality measures of Swamy, Butler, Chandler and Hemami 2011 (structure, misalignment, blur,
// repetition), each as a number of its own; nothing is blended into one score.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "libbake/base/options.h"

namespace texbake {

/// What is measured: the bundle, and what a user would pick instead.
enum class Method { bundle, periodic, wang, hex };
inline constexpr int kMethodCount = 4;
template <>
struct EnumNames<Method> {
  static constexpr std::pair<Method, std::string_view> values[] = {
      {Method::bundle, "bundle"}, {Method::periodic, "periodic"}, {Method::wang, "wang"}, {Method::hex, "hex"}};
};

enum class Measure : uint8_t {
  tile_x,
  tile_y,
  repetition_near,
  repetition_mid,
  repetition_far,
  amplitude_far,
  predicted_near,
  predicted_far,
  band_finest,
  band_fine,
  band_middle,
  band_coarse,
  band_rest,
  seam_auc,
  seam_tail,
  seam_auc_all,
  seam_tail_all,
  seam_run,
  pair_mean,
  pair_worst,
  color,
  spectrum,
  gradient_ratio,
  gradient_distance,
  structure,
  noise_spectrum,
  noise_power,
  noise_kurtosis,
  noise_energy,
  noise_coherence,
  fetches,
  gpu_bytes,
};
inline constexpr int kMeasureCount = static_cast<int>(Measure::gpu_bytes) + 1;
inline constexpr int kBandCount = 5;  ///< band_finest … band_rest

/// One measure, in words.
struct MeasureKind {
  Measure measure;
  std::string_view key;      ///< in JSON
  std::string_view group;    ///< heading
  std::string_view label;    ///< a few words
  std::string_view unit;     ///< "" for a ratio
  std::string_view meaning;  ///< one plain line
  std::string_view advice;   ///< what to try when it is not good; "" for what is not judged
};

/// All measures in the order of the enum, which is that of the table.
std::span<const MeasureKind> measure_kinds();
inline const MeasureKind& kind_of(Measure measure) { return measure_kinds()[static_cast<size_t>(measure)]; }

/// Over the seeds: mean and standard deviation.
struct MeasuredValue {
  double mean = 0;
  double spread = 0;
};

/// A number, or why there is none.
struct Measured {
  std::optional<MeasuredValue> value;
  std::string undefined_because;  ///< "" where there is a value

  static Measured of(double mean, double spread = 0) { return {MeasuredValue{mean, spread}, ""}; }
  static Measured undefined(std::string reason) { return {std::nullopt, std::move(reason)}; }
};

/// The numbers of one method.
class MeasureRow {
 public:
  Measured& operator[](Measure measure) { return values_[static_cast<size_t>(measure)]; }
  const Measured& operator[](Measure measure) const { return values_[static_cast<size_t>(measure)]; }

 private:
  std::array<Measured, kMeasureCount> values_;
};

}  // namespace texbake
