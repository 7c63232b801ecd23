// Whether an exemplar is fit for content exchange at all, and what helps where it is not.
// Based on: Vanhoey et al. 2013, §8, "Limitations": low contrast, and near-regular textures.
#pragma once

#include <optional>
#include <string>

#include "libbake/content/translation_lattice.h"
#include "libbake/segment/contrast.h"

namespace texbake {

struct Suitability {
  std::string because;  ///< "" for an exemplar that is fit
  std::string helps;

  bool fits() const { return because.empty(); }
};

/// `contrast` is nothing where the bundle has no fragments.
Suitability suitability(const std::optional<ContrastReport>& contrast,
                        const std::optional<TranslationLattice>& lattice);

}  // namespace texbake
