// texbake export: bundle → files for an engine: a web page, or the textures that the shader texts bind.
#include <memory>

#include "cli/bundle_path.h"
#include "cli/command.h"
#include "cli/kept_files.h"
#include "cli/option_flags.h"
#include "formats/bundle_io.h"
#include "formats/drawn_bundle.h"
#include "pages/plane_export.h"
#include "pages/web_export.h"

namespace texbake {
namespace {

struct ExportOptions {
  std::optional<float> depth_px;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(
        self.depth_px,
        Field{.name = "relief",
              .unit = "texels",
              .min = 0,
              .max = 1024,
              .help =
                  "depth of the relief: texels of the coarsest scale between height 0 and height 1; 0: flat and unlit",
              .auto_help = "1/32 of the shorter side, if there are heights"});
  }
};

struct ExportFlags {
  std::string bundle;
  std::string output;
  bool web = false;
  bool planes = false;
  ExportOptions options;
};

Outcome run(const ExportFlags& request, Console& console) {
  if (request.web == request.planes)
    throw Error(ErrorKind::usage,
                "expected one target to export to: --web makes a folder that a browser opens, --planes one of textures "
                "for an engine");
  check_options(request.options);
  const std::string folder = !request.output.empty() ? request.output
                             : request.web           ? default_web_folder(request.bundle)
                                                     : default_planes_folder(request.bundle);
  check_keeps_inputs(folder, std::vector{request.bundle});
  console.step("read");
  const Bundle bundle = read_bundle(request.bundle);
  console.step("export");
  if (request.planes) {
    export_planes(drawn_material(bundle), request.options.depth_px, folder);
    const std::string list = folder + "/" + kPlanesFile;
    return {.text = list + "\n", .result = {{"output", folder}, {"planes", list}}};
  }
  export_web(drawn_material(bundle), request.options.depth_px, folder);
  const std::string page = folder + "/index.html";
  return {.text = page + "\n", .result = {{"output", folder}, {"page", page}}};
}

Action declare_export(Arguments& arguments) {
  const auto request = std::make_shared<ExportFlags>();
  add_bundle_path(arguments, request->bundle);
  arguments.option({.name = "output",
                    .letter = 'o',
                    .value = "FOLDER",
                    .names = Names::folder,
                    .standard = "NAME_web or NAME_planes here",
                    .help = "the folder",
                    .assign = into(request->output)});
  arguments.flag({.name = "web",
                  .help = "make a page that shows the endless texture; a browser opens it from disk, without a server",
                  .assign = into(request->web)});
  arguments.flag({.name = "planes",
                  .help =
                      "write the textures, tables and uniforms that the shader texts bind, as OpenEXR and JSON, for "
                      "an engine that draws by itself",
                  .assign = into(request->planes)});
  add_flags(arguments, request->options, "Options");
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command export_command() {
  return {
      "export",
      "bundle → web page or textures: write a folder that shows the endless texture in a browser, or what an engine "
      "binds",
      "  texbake export leaves.texbundle --web -o leaves_web\n"
      "  texbake export leaves.texbundle --planes -o leaves_planes\n"
      "  texbake export rock.texbundle --web --relief 24",
      declare_export};
}

}  // namespace texbake
