// texbake info: bundle → what it holds, as text, JSON or recipe.
#include <memory>

#include "bake/bake_request.h"
#include "cli/command.h"
#include "cli/info_json.h"
#include "formats/bundle_io.h"
#include "formats/json_text.h"

namespace texbake {
namespace {

struct InfoFlags {
  std::string bundle;
  bool recipe = false;
};

Outcome run(const InfoFlags& request, Console&) {
  const Bundle bundle = read_bundle(request.bundle, {.semantics = Semantics::any});
  Outcome outcome;
  if (request.recipe) {
    outcome.result["recipe"] = recipe_of(bundle);
    outcome.text = print_json(with_text(outcome.result["recipe"]));
  } else {
    outcome.result = info_json(bundle);
    outcome.text = info_text(outcome.result, request.bundle);
  }
  return outcome;
}

Action declare_info(Arguments& arguments) {
  const auto request = std::make_shared<InfoFlags>();
  add_bundle_path(arguments, request->bundle);
  arguments.flag({.name = "recipe",
                  .help = "write a recipe from which bake makes the same bundle",
                  .assign = into(request->recipe)});
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command info_command() {
  return {"info", "bundle → text, JSON or recipe: list every field with its shape and unit",
          "  texbake info leaves.texbundle\n"
          "  texbake info leaves.texbundle --recipe > leaves.json",
          declare_info};
}

}  // namespace texbake
