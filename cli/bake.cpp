// texbake bake: picture or recipe → bundle, the whole chain.
#include "bake/bake.h"

#include <memory>

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

Outcome run(const Request& request, Console& console) {
  const std::string path = request.output.empty() ? default_bundle_path(request.input) : request.output;
  check_request(request.bake);
  check_bundle_target(path);
  if (request.if_changed && is_up_to_date(path, request.bake)) {
    console.note(path + " is up to date");
    return written_bundle(path, read_bundle(path).stages);
  }
  const Bundle bundle = bake(request.bake, console);
  console.step("write");
  write_bundle(bundle, path);
  return written_bundle(path, bundle.stages);
}

std::string title_of(const StageRow& row) {
  return "Options of " + row.verb + (row.use == StageUse::layers ? " (with --layers structure+noise)" : "");
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
  for (const StageRow& row : stage_table())
    if (is_in_chain(row) && &row != &first_stage())
      for_each_options_of(row.verb, request->bake,
                          [&](auto& options) { add_flags(app, options, title_of(row), row.verb + "-"); });
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
