// texbake heightmap: bundle + a few heights → bundle with a height map.
#include <memory>

#include "bake/heightmap_stage.h"
#include "cli/kept_files.h"
#include "cli/option_flags.h"
#include "cli/stage_command.h"
#include "formats/image_writer.h"
#include "libbake/height/shading.h"

namespace texbake {
namespace {

struct PreviewOptions {
  std::string file;
  float depth_px = kPreviewDepthPx;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.file, Field{.name = "preview", .unit = "FILE", .help = "write a picture of the lit tile"});
    visit(self.depth_px, Field{.name = "preview-depth",
                               .unit = "texels",
                               .min = 0,
                               .max = 1000,
                               .help = "depth of the preview's relief between height 0 and height 1"});
  }
};

struct HeightmapFlags {
  BundlePaths paths;
  std::string clicks;
  bool in_source = false;
  HeightmapOptions options;
  PreviewOptions preview;
};

Outcome run(const HeightmapFlags& request, Console& console) {
  check_options(request.options);
  check_options(request.preview);
  const PreviewOptions& preview = request.preview;
  if (!preview.file.empty()) {
    check_picture_name(preview.file);
    check_file_target(preview.file);
    check_keeps_inputs(preview.file, std::vector{request.clicks});
  }
  const ClickFile clicks = read_clicks(request.clicks);
  const ClickSpace space = request.in_source ? ClickSpace::source : ClickSpace::tile;
  Image<V3f> lit;
  Outcome outcome = change_bundle(request.paths, "heightmap", preview.file, console, [&](Bundle& bundle) {
    run_heightmap(bundle, clicks, space, request.options, console);
    const Scale& scale = bundle.scales.front();
    if (!preview.file.empty()) lit = shaded(scale.base(), *scale.height, preview.depth_px);
  });
  if (preview.file.empty()) return outcome;
  write_picture(preview.file, lit, PictureRole::color);
  outcome.result["preview"] = preview.file;
  return outcome;
}

Action declare_heightmap(Arguments& arguments) {
  const auto request = std::make_shared<HeightmapFlags>();
  add_bundle_path(arguments, request->paths.input);
  arguments.positional(
      {.name = "CLICKS",
       .names = Names::file,
       .help = "heights of some texels: .json [{\"x\": 12, \"y\": 34, \"height\": 0.5}, ...], .csv (x,y,height), or a "
               "gray picture whose alpha is 0 (without alpha: that is black) where no height is given",
       .assign = into(request->clicks)});
  add_changed_bundle_path(arguments, request->paths.output);
  arguments.flag({.name = "source-coordinates",
                  .help = "click positions are texels of the photograph, not of the tile",
                  .assign = into(request->in_source)});
  add_flags(arguments, request->options, "Options");
  add_flags(arguments, request->preview, "Options");
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command heightmap_command() {
  return {"heightmap", "bundle, a few heights → bundle: propagate clicks to a height map, by features that look alike",
          "  texbake heightmap bricks.texbundle clicks.json --preview bricks_lit.png\n"
          "  texbake heightmap bricks.texbundle strokes.png -o relief.texbundle",
          declare_heightmap};
}

}  // namespace texbake
