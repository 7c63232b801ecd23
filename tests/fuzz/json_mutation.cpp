#include "tests/fuzz/json_mutation.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/fuzz/target.h"

namespace texbake::fuzz {
namespace {

void list_values(Json& json, std::vector<Json*>& all) {
  all.push_back(&json);
  if (json.is_structured())
    for (Json& member : json) list_values(member, all);
}

uint32_t below(size_t count, Random& random) { return random.below(static_cast<uint32_t>(count)); }

Json a_number(const Json& before, Random& random) {
  static const std::vector<Json> kNumbers = {
      0,     1,     -1,      2,         3,           8,           9,         255,        256, 65535,
      65536, 16384, 16385,   INT32_MAX, INT32_MIN,   INT64_MAX,   INT64_MIN, UINT64_MAX, 0.5, -0.5,
      1e-30, 1e30,  1.7e308, -1.7e308,  4294967295u, 2147483648u, 0.49999,   1e9};
  if (!before.is_number() || random.below(2) == 0) return kNumbers[below(kNumbers.size(), random)];
  const double value = before.get<double>();
  const std::vector<Json> near = {value + 1, value - 1, -value, value * 2, value / 2};
  const Json chosen = near[below(near.size(), random)];
  const bool stays_whole = before.is_number_integer() && std::abs(chosen.get<double>()) < 1e9;
  return stays_whole ? Json(static_cast<int64_t>(chosen.get<double>())) : chosen;
}

Json a_value(const Json& before, Random& random) {
  static const std::vector<Json> kOthers = {nullptr,
                                            true,
                                            false,
                                            "",
                                            "color",
                                            "normal",
                                            "half",
                                            "uint",
                                            "float",
                                            "..",
                                            "a/b",
                                            std::string(70, 'x'),
                                            "\xff\xfe",
                                            "\u00e9\u4e2d",
                                            std::string(64, '0'),
                                            Json::array(),
                                            Json::object(),
                                            Json::array({0, 0}),
                                            Json::array({1, 2, 3})};
  if (before.is_number() || random.below(3) == 0) return a_number(before, random);
  return kOthers[below(kOthers.size(), random)];
}

void mutate_once(Json& json, Random& random) {
  std::vector<Json*> all;
  list_values(json, all);
  Json& at = *all[below(all.size(), random)];
  switch (random.below(8)) {
    case 0:
      if (at.is_structured() && !at.empty()) at.erase(std::next(at.begin(), below(at.size(), random)));
      return;
    case 1:
      if (at.is_array() && !at.empty()) at.push_back(Json(at[below(at.size(), random)]));
      return;
    case 2:
      if (at.is_object()) at["k" + std::to_string(random.below(3))] = a_value({}, random);
      return;
    case 3:
      at = Json(*all[below(all.size(), random)]);  // a value from elsewhere
      return;
    case 4:
      if (at.is_array() && at.size() > 1) std::swap(at[below(at.size(), random)], at[below(at.size(), random)]);
      return;
    case 5:
      if (random.below(4) == 0) at = Json::array({Json(at)});
      return;
    default:
      at = a_value(at, random);
  }
}

}  // namespace

void mutate_json(Json& json, Random& random) {
  for (uint32_t round = 0; round <= random.below(3); ++round) mutate_once(json, random);
}

std::string mutate_json_text(const std::string& text, Random& random) {
  if (random.below(8) == 0) return mutate_bytes(text, random);
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return mutate_bytes(text, random);
  mutate_json(json, random);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace texbake::fuzz
