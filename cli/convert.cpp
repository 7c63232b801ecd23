// texbake convert: pictures → new bundle.
#include <memory>

#include "cli/convert_flags.h"
#include "cli/kept_files.h"
#include "cli/sheets.h"
#include "cli/stage_command.h"
#include "formats/bundle_io.h"
#include "libbake/report/choice_sheets.h"

namespace texbake {
namespace {

struct ConvertFlags {
  ConvertRequest convert;
  std::string output;
  std::string sheet;
};

Outcome run(const ConvertFlags& request, Console& console) {
  const std::string path =
      request.output.empty() ? default_bundle_path(request.convert.files.color.file) : request.output;
  const std::vector<std::string> inputs = files_of(request.convert.files);
  check_keeps_inputs(path, inputs);
  check_keeps_inputs(request.sheet, inputs);
  check_bundle_target(path);
  check_sheet(request.sheet);
  const Bundle bundle = run_convert(request.convert, console);
  if (!request.sheet.empty())
    write_sheet(request.sheet,
                convert_sheet(bundle.scales.front().exemplar, request.convert.convert, console.step("sheet")));
  write_new_bundle(bundle, path, console);
  return written_bundle(path, bundle.stages);
}

Action declare_convert(Arguments& arguments) {
  const auto request = std::make_shared<ConvertFlags>();
  arguments.positional({.name = "PICTURE",
                        .names = Names::file,
                        .help = "the exemplar: PNG, JPEG, TIFF, OpenEXR or another of the formats that are read",
                        .assign = into(request->convert.files.color.file)});
  add_new_bundle_path(arguments, request->output);
  add_convert_flags(arguments, request->convert);
  add_sheet_flag(arguments, request->sheet);
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command convert_command() {
  return {"convert", "pictures → new bundle: make the tile, its palette, and the maps of the material",
          "  texbake convert leaves.jpg -o leaves.texbundle\n"
          "  texbake convert rock.png --map normal=rock_normal.png --map height=rock_height.png\n"
          "  texbake convert wall.jpg --flatten 128 --sheet classes.png",
          declare_convert};
}

}  // namespace texbake
