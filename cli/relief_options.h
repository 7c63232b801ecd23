// How a surface with relief is looked at and lit: the options that pictures of it share.
#pragma once

#include <string>

#include "libbake/base/option_text.h"
#include "libbake/draw/drawing.h"

namespace texbake {

/// "X,Y,Z"
std::string direction_text(const Direction& direction);

struct SlantOptions {
  std::string view = "0,0,1";
  std::string light = direction_text(kDefaultLight);

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.view,
          Field{.name = "view-direction",
                .unit = "X,Y,Z",
                .help = "direction towards the viewer, for a flat window with --relief: x right, y down, z up"});
    visit(self.light,
          Field{.name = "light", .unit = "X,Y,Z", .help = "direction towards the light, for --relief; z > 0"});
  }
};

/// Throws Error(usage) for directions that are not "X,Y,Z" with z > 0.
Relief relief_of(const ReliefOptions& options, const SlantOptions& slant);

}  // namespace texbake
