// What a picture can have, and what of it goes together: the one table that refusals, help and README follow.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace texbake {

enum class Feature : uint8_t { deformation, map, show, plane, supersample, relief, scales };
inline constexpr int kFeatures = 7;

/// As `texbake render` asks for it: "--rotate, --stretch, --turbulence"; "several scales" is what a bundle has.
std::string_view feature_name(Feature feature);

/// Those of one picture.
class Features {
 public:
  Features() = default;
  Features(std::initializer_list<Feature> features) {
    for (const Feature one : features) add(one);
  }
  void add(Feature feature, bool asked = true) {
    if (asked) bits_ |= bit(feature);
  }
  bool has(Feature feature) const { return (bits_ & bit(feature)) != 0; }

 private:
  static uint32_t bit(Feature feature) { return 1u << static_cast<uint32_t>(feature); }
  uint32_t bits_ = 0;
};

/// Why two features do not go together, as a sentence to follow the name of `a` or `b`, whichever the table has first;
/// "" where they do.
std::string_view why_not(Feature a, Feature b);

/// Throws Error(usage) for the first two, in the order of the table, that do not go together.
void check_features(const Features& features);

/// What is not offered, for people: "--show: not with --map, --view plane, --supersample or --relief", a line for each.
std::string not_together();

}  // namespace texbake
