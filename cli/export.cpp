// texbake export: bundle → files for an engine; so far the web viewer.
#include <memory>

#include "cli/bundle_path.h"
#include "cli/command.h"
#include "cli/evaluator_input.h"
#include "formats/bundle_io.h"
#include "formats/web_export.h"
#include "libbake/eval/levels.h"
#include "libbake/eval/stack_levels.h"

namespace texbake {
namespace {

struct Request {
  std::string bundle;
  std::string output;
  bool web = false;
};

Outcome run(const Request& request, Console& console) {
  if (!request.web)
    throw Error(ErrorKind::usage, "expected what to export for; --web is a folder that a browser opens");
  const std::string folder = request.output.empty() ? default_web_folder(request.bundle) : request.output;
  console.step("read");
  const Bundle bundle = read_bundle(request.bundle);
  if (bundle.scales.size() > 1) {
    const std::vector<StackScale> scales = stack_input(bundle);
    StackPlanes planes = prepare_stack(scales);
    add_levels(planes, scales);
    console.step("export");
    export_web(planes, folder);
  } else {
    EvaluatorPlanes planes = prepare(evaluator_input(bundle));
    add_levels(planes, planes.base);
    console.step("export");
    export_web(planes, folder);
  }
  const std::string page = folder + "/index.html";
  return {.text = page + "\n", .result = {{"output", folder}, {"page", page}}};
}

Action declare(CLI::App& app) {
  const auto request = std::make_shared<Request>();
  app.add_option("BUNDLE", request->bundle, "a folder NAME.texbundle")->required()->type_name("");
  app.add_option("-o,--output", request->output, "the folder; default: NAME_web here")->type_name("FOLDER");
  app.add_flag("--web", request->web, "a page that shows the endless texture, opened from the disk, without a server");
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command export_command() {
  return {"export", "bundle → a self-contained folder for the web viewer",
          "  texbake export leaves.texbundle --web -o leaves_web", declare};
}

}  // namespace texbake
