#include "bake/stage_parts.h"

namespace texbake {

Scale& only_scale(Bundle& bundle) {
  if (bundle.scales.size() != 1)
    throw Error(
        ErrorKind::unsupported,
        fmt::format("expected a bundle of one scale, found {}; run the verb on each bundle before stacking them",
                    bundle.scales.size()));
  return bundle.scales.front();
}

void refuse_missing(const char* what, const char* verb) {
  throw Error(ErrorKind::bad_data,
              fmt::format("expected a bundle with {}, found none; run \"texbake {}\" first", what, verb));
}

}  // namespace texbake
