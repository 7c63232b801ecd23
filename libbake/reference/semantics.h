// The number of the semantics: what a bundle means and a picture shows, as shaders/README.md specifies it.
#pragma once

namespace texbake {

/// Raised when the same bundle would draw another picture. Bundles carry it; readers refuse one that they do not know.
inline constexpr int kSemantics = 1;

}  // namespace texbake
