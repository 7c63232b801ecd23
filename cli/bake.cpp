// texbake bake: picture or recipe → bundle, the whole chain.
#include <memory>

#include "bake/bake_request.h"
#include "bake/layer_stages.h"
#include "bake/stages.h"
#include "cli/convert_flags.h"
#include "cli/stage_command.h"
#include "formats/bundle_io.h"

namespace texbake {
namespace {

struct Request {
  std::string input;
  std::string output;
  bool if_changed = false;
  BakeRequest bake;
};

Bundle run_chain(const BakeRequest& request, Console& console) {
  Bundle bundle = run_convert(request.convert, console);
  if (request.layers.layers == Layers::structure_noise) {
    run_decompose(bundle, request.decompose, /*sheet=*/"", console);
    run_estimate_psd(bundle, request.estimate_psd, console);
  }
  run_fragment(bundle, request.fragment, console);
  run_patch(bundle, request.patch, console);
  run_select_contents(bundle, request.select_contents, console);
  return bundle;
}

/// Throws Error(usage) for options that exclude each other.
void check_layers(const BakeRequest& request) {
  if (request.layers.layers == Layers::structure_noise && request.convert.storage.color == ColorForm::palette)
    throw Error(
        ErrorKind::usage,
        "--layers structure+noise: expected --colour full, found palette: noise is what the palette leaves out");
}

Outcome run(const Request& request, Console& console) {
  const std::string path = request.output.empty() ? default_bundle_path(request.input) : request.output;
  for_each_stage_options(request.bake, [](const char*, const auto& options) { check_options(options); });
  check_layers(request.bake);
  check_bundle_target(path);
  if (request.if_changed && is_up_to_date(path, request.bake)) {
    console.note(path + " is up to date");
    return written_bundle(path, read_bundle(path).stages);
  }
  const Bundle bundle = run_chain(request.bake, console);
  console.step("write");
  write_bundle(bundle, path);
  return written_bundle(path, bundle.stages);
}

Action declare(CLI::App& app) {
  const auto request = std::make_shared<Request>();
  // Declared first, so that flags that follow change what the recipe says.
  app.add_option_function<std::string>(
         "INPUT",
         [request](const std::string& input) {
           request->input = input;
           if (is_recipe(input))
             request->bake = read_recipe(input);
           else
             request->bake.convert.files.color.file = input;
         },
         "a picture, or a recipe (.json) as \"info --recipe\" writes it")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", request->output, "the bundle to write; default: NAME.texbundle here")
      ->type_name("BUNDLE");
  app.add_flag("--if-changed", request->if_changed,
               "do nothing when the bundle was made from the same files, with the same options, by this version");
  add_flags(app, request->bake.layers, "Options");
  add_convert_flags(app, request->bake.convert);
  add_flags(app, request->bake.decompose, "Options of decompose (with --layers structure+noise)", "decompose-");
  add_flags(app, request->bake.estimate_psd, "Options of estimate-psd (with --layers structure+noise)",
            "estimate-psd-");
  add_flags(app, request->bake.fragment, "Options of fragment", "fragment-");
  add_flags(app, request->bake.patch, "Options of patch", "patch-");
  add_flags(app, request->bake.select_contents, "Options of select-contents", "select-contents-");
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command bake_command() {
  return {"bake", "picture or recipe → bundle: the whole chain, with defaults that suit most photographs",
          "  texbake bake leaves.jpg -o leaves.texbundle\n"
          "  texbake bake rock.png --map normal=rock_normal.png --patch-count 12\n"
          "  texbake bake moss.png --layers structure+noise --decompose-noises 2\n"
          "  texbake bake rock.json -o rock.texbundle --if-changed",
          declare};
}

}  // namespace texbake
