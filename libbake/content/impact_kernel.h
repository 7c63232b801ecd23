// Sums the errors of eq. 3 over the borders of all patches for 128 translations at once, along the vector lanes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libbake/content/border_program.h"
#include "libbake/content/distance_field.h"

namespace texbake {

/// The errors summed for one group, as far as they matter.
struct GroupSums {
  V2i translation{0, 0};       ///< the first of the group
  std::vector<uint8_t> alive;  ///< for each patch: some translation may still be at most its limit
  std::vector<int64_t> sums;   ///< patch-major, kGroupSize for each, row by row; complete where alive
  uint64_t error_count = 0;    ///< of E computed, kGroupSize for each texel
};

/// What a translation that must not be chosen starts with.
inline constexpr int64_t kExcluded = INT64_MAX / 2;

/// Adds the errors of the chunks of `program`, taken in `order`, to the sums of the groups. A patch is given up in a
/// group, alive = 0, once all of its sums there are beyond its limit; a chunk is skipped once all of its patches are.
/// Groups that are near each other read the same classes: together they wait less for memory.
void add_group_errors(const BorderProgram& program, const std::vector<uint32_t>& order, const DistanceField& field,
                      const std::vector<int64_t>& limits, std::span<GroupSums> groups);

}  // namespace texbake
