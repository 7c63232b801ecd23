// texbake decompose: bundle → bundle with structure and masks.
#include "bake/layer_stages.h"
#include "cli/sheets.h"
#include "cli/stage_command.h"

namespace texbake {
namespace {

struct DecomposeFlags {
  BundlePaths paths;
  DecomposeOptions options;
  std::string sheet;
};

Outcome run(const DecomposeFlags& request, Console& console) {
  check_options(request.options);
  check_sheet(request.sheet);
  return change_bundle(request.paths, "decompose", request.sheet, console,
                       [&](Bundle& bundle) { run_decompose(bundle, request.options, request.sheet, console); });
}

Action declare_decompose(Arguments& arguments) {
  const auto request = std::make_shared<DecomposeFlags>();
  add_bundle_paths(arguments, request->paths);
  add_flags(arguments, request->options, "Options");
  arguments.option({.name = "sheet",
                    .value = "FILE",
                    .names = Names::file,
                    .help = "also write a picture for choosing --local-size by eye: for each size, smallest on top, "
                            "the exemplar, structure, noise, and a synthesis of both; the chosen size is framed",
                    .assign = into(request->sheet)});
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command decompose_command() {
  return {"decompose", "bundle → bundle: separate structure from noise, and find where each noise occurs",
          "  texbake decompose rock.texbundle --noises 2\n"
          "  texbake decompose rock.texbundle --local-size auto --sheet choice.png",
          declare_decompose};
}

}  // namespace texbake
