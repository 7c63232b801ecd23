#include "cli/deform_options.h"

namespace texbake {

Deformation deformation_of(const DeformOptions& options) {
  DeformationRequest request;
  request.rotate_degrees = options.rotate;
  const std::string both =
      options.stretch.find(',') == std::string::npos ? options.stretch + "," + options.stretch : options.stretch;
  const DecimalPoint stretch = parse_point("stretch", both);
  const Field factor{.name = "stretch", .unit = "times", .min = 0.5, .max = 64};
  request.stretch_x = parse_number(factor.name, factor, stretch.x);
  request.stretch_y = parse_number(factor.name, factor, stretch.y);
  request.turbulence_texels = options.turbulence;
  request.turbulence_cell = options.turbulence_cell;
  return deformation_of(request);
}

}  // namespace texbake
