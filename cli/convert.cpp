// texbake convert: pictures → new bundle.
#include <memory>

#include "cli/convert_flags.h"
#include "cli/sheets.h"
#include "cli/stage_command.h"
#include "formats/bundle_io.h"
#include "libbake/report/choice_sheets.h"

namespace texbake {
namespace {

struct Request {
  ConvertRequest convert;
  std::string output;
  std::string sheet;
};

Outcome run(const Request& request, Console& console) {
  const std::string path =
      request.output.empty() ? default_bundle_path(request.convert.files.color.file) : request.output;
  check_bundle_target(path);
  check_sheet(request.sheet);
  const Bundle bundle = run_convert(request.convert, console);
  if (!request.sheet.empty())
    write_sheet(request.sheet,
                convert_sheet(bundle.scales.front().exemplar, request.convert.convert, console.step("sheet")));
  console.step("write");
  write_bundle(bundle, path);
  return written_bundle(path, bundle.stages);
}

Action declare(CLI::App& app) {
  const auto request = std::make_shared<Request>();
  app.add_option("PICTURE", request->convert.files.color.file, "the exemplar: any picture that OpenImageIO reads")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", request->output, "the bundle to write; default: NAME.texbundle here")
      ->type_name("BUNDLE");
  add_convert_flags(app, request->convert);
  add_sheet_flag(app, request->sheet);
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command convert_command() {
  return {"convert", "pictures → new bundle: the tile, its palette, and the maps of the material",
          "  texbake convert leaves.jpg -o leaves.texbundle\n"
          "  texbake convert rock.png --map normal=rock_normal.png --map height=rock_height.png\n"
          "  texbake convert wall.jpg --flatten 128 --sheet classes.png",
          declare};
}

}  // namespace texbake
