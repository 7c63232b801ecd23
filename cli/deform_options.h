// How an artist deforms a window: the options that render and a camera file share.
#pragma once

#include <string>

#include "libbake/base/option_text.h"
#include "libbake/draw/deform.h"

namespace texbake {

struct DeformOptions {
  double rotate = 0;
  std::string stretch = "1";
  double turbulence = 0;
  int turbulence_cell = DeformationRequest().turbulence_cell;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.rotate, Field{.name = "rotate",
                             .unit = "degrees",
                             .min = -360,
                             .max = 360,
                             .help = "rotate the structure clockwise about the origin; the grain keeps its direction"});
    visit(self.stretch, Field{.name = "stretch",
                              .unit = "FACTOR or X,Y",
                              .help = "enlarge the structure by this factor, 0.5 to 64; the grain keeps its size"});
    visit(self.turbulence, Field{.name = "turbulence",
                                 .unit = "texels",
                                 .min = 0,
                                 .max = 64,
                                 .help = "distort the structure by displacements of about this size"});
    visit(self.turbulence_cell, Field{.name = "turbulence-cell",
                                      .unit = "texels",
                                      .min = 64,
                                      .max = 1024,
                                      .help = "size of the largest eddies of --turbulence, a power of two"});
  }
};

/// Throws Error(usage) for values out of range.
Deformation deformation_of(const DeformOptions& options);

}  // namespace texbake
