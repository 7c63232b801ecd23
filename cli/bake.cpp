// texbake bake: picture or recipe → bundle, the whole chain.
#include "bake/bake.h"

#include <memory>

#include "cli/convert_flags.h"
#include "cli/kept_files.h"
#include "cli/stage_command.h"
#include "formats/bundle_io.h"

namespace texbake {
namespace {

struct BakeFlags {
  std::string input;
  std::string output;
  bool if_changed = false;
  BakeRequest bake;
};

/// The recipe, where there is one, and the pictures.
std::vector<std::string> inputs_of(const BakeFlags& request) {
  std::vector<std::string> inputs = files_of(request.bake.convert.files);
  inputs.push_back(request.input);
  return inputs;
}

Outcome run(const BakeFlags& request, Console& console) {
  const std::string path = request.output.empty() ? default_bundle_path(request.input) : request.output;
  check_request(request.bake);
  check_keeps_inputs(path, inputs_of(request));
  check_bundle_target(path);
  if (request.if_changed && is_up_to_date(path, request.bake)) {
    console.note(path + " is up to date");
    return written_bundle(path, read_bundle(path).stages);
  }
  const Bundle bundle = bake(request.bake, console);
  write_new_bundle(bundle, path, console);
  return written_bundle(path, bundle.stages);
}

std::string title_of(const StageRow& row) {
  return "Options of " + row.verb + (row.use == StageUse::layers ? " (with --layers structure+noise)" : "");
}

void take_input(BakeFlags& request, const std::string& input) {
  request.input = input;
  if (is_recipe(input))
    request.bake = read_recipe(input);
  else
    request.bake.convert.files.color.file = input;
}

Action declare_bake(Arguments& arguments) {
  const auto request = std::make_shared<BakeFlags>();
  // Declared first, so that flags that follow change what the recipe says.
  arguments.positional({.name = "INPUT",
                        .names = Names::file,
                        .help = "a picture, or a recipe (.json) as written by \"info --recipe\"",
                        .assign = [request](const std::string& input) { take_input(*request, input); }});
  add_new_bundle_path(arguments, request->output);
  arguments.flag(
      {.name = "if-changed",
       .help = "do nothing if the bundle was made from the same files, with the same options, by this version",
       .assign = into(request->if_changed)});
  add_flags(arguments, request->bake.layers, "Options");
  add_convert_flags(arguments, request->bake.convert);
  for (const StageRow& row : stage_table())
    if (is_in_chain(row) && &row != &first_stage())
      for_each_options_of(row.verb, request->bake,
                          [&](auto& options) { add_flags(arguments, options, title_of(row), row.verb + "-"); });
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command bake_command() {
  return {"bake", "picture or recipe → bundle: run the whole chain, with defaults that suit most photographs",
          "  texbake bake leaves.jpg -o leaves.texbundle\n"
          "  texbake bake rock.png --map normal=rock_normal.png --patch-count 12\n"
          "  texbake bake moss.png --layers structure+noise --decompose-noises 2\n"
          "  texbake bake rock.json -o rock.texbundle --if-changed",
          declare_bake};
}

}  // namespace texbake
