// What a report measures and draws: the tile, whole or at a fraction of its size.
#pragma once

#include <optional>

#include "libbake/report/reduced_tile.h"
#include "libbake/report/report_input.h"

namespace texbake {

/// The measured tile and what is drawn from it.
struct Scene {
  ReducedTile tile;
  EvaluatorPlanes planes;
  Image<V3f> exemplar;  ///< what all methods start from
  Image<V3f> luv;       ///< the same in CIELUV
  Image<V3f> base_luv;  ///< what contents exchange; the exemplar, or its structure
  V2i tiles{0, 0};      ///< of a rendering

  V2i size() const { return planes.size; }
};

/// Both scenes of a report. Seams are steps from texel to texel, which a smaller tile does not show: they have a scene
/// of their own where the tile is measured at a fraction of its size.
struct Scenes {
  Scene main;
  std::optional<Scene> full;
  V2i seam_tiles{0, 0};  ///< of the rendering in which seams are counted

  const Scene& seams() const { return full ? *full : main; }
};

/// `options` are in range.
Scenes make_scenes(const ReportInput& input, const ReportOptions& options);

}  // namespace texbake
