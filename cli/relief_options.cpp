#include "cli/relief_options.h"

namespace texbake {
namespace {

/// "X,Y,Z" with z > 0.
Direction parse_direction(std::string_view flag, const std::string& text) {
  const size_t first = text.find(','), second = first == std::string::npos ? first : text.find(',', first + 1);
  if (second == std::string::npos)
    throw Error(ErrorKind::usage, fmt::format("--{}: expected X,Y,Z, found \"{}\"", flag, text));
  const Field component{.name = "", .min = -1e6, .max = 1e6};
  const auto number = [&](size_t begin, size_t end) {
    return static_cast<float>(parse_number(flag, component, std::string_view(text).substr(begin, end - begin)));
  };
  const Direction direction{number(0, first), number(first + 1, second), number(second + 1, text.size())};
  if (!(direction.z > 0))
    throw Error(ErrorKind::usage,
                fmt::format("--{}: expected a direction from above, Z > 0, found \"{}\"", flag, text));
  return direction;
}

}  // namespace

std::string direction_text(const Direction& direction) {
  return fmt::format("{},{},{}", direction.x, direction.y, direction.z);
}

Relief relief_of(const ReliefOptions& options, const SlantOptions& slant) {
  return {options, parse_direction("view-direction", slant.view), parse_direction("light", slant.light)};
}

}  // namespace texbake
