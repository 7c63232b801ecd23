#include "libbake/report/scene.h"

#include <algorithm>

#include "libbake/color/luv.h"
#include "libbake/planes/prepare.h"
#include "libbake/quality/low_pass.h"
#include "libbake/report/report_input.h"

namespace texbake {
namespace {

constexpr int kSeamSide = 1024;          // longest side of a tile whose seams are measured at full size
constexpr int kMaxSeamTexels = 1 << 22;  // of the rendering in which seams are counted

Scene make_scene(const ReportInput& input, int factor) {
  Scene scene;
  scene.tile = reduced_tile(input.tile, factor);
  scene.planes = prepare(scene.tile.input());
  scene.base_luv = luv_from_linear(scene.tile.base);
  scene.exemplar = input.exemplar.empty() ? scene.tile.base.clone() : reduce(input.exemplar, factor);
  scene.luv = luv_from_linear(scene.exemplar);
  return scene;
}

}  // namespace

Scenes make_scenes(const ReportInput& input, const ReportOptions& options) {
  const int factor = reduction_to(input.tile, options.side_px);
  const int seam_factor = reduction_to(input.tile, std::max(options.side_px, kSeamSide));
  Scenes scenes{make_scene(input, factor), std::nullopt, {0, 0}};
  scenes.main.tiles = {options.tiles, options.tiles};
  if (seam_factor != factor) scenes.full = make_scene(input, seam_factor);
  const Scene& seams = scenes.seams();
  int tiles = std::min(options.tiles, 3);
  while (tiles > 2 && static_cast<int64_t>(seams.luv.size()) * tiles * tiles > kMaxSeamTexels) --tiles;
  scenes.seam_tiles = {tiles, tiles};
  return scenes;
}

}  // namespace texbake
