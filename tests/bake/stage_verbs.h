// The verbs of the stages that a bundle records, in order.
#pragma once

#include <string>
#include <vector>

#include "formats/bundle.h"

namespace texbake {

inline std::vector<std::string> verbs(const Bundle& bundle) {
  std::vector<std::string> list;
  for (const Stage& stage : bundle.stages) list.push_back(stage.verb);
  return list;
}

}  // namespace texbake
