// texbake export: bundle → files for an engine; so far the web viewer.
#include <memory>

#include "cli/bundle_path.h"
#include "cli/command.h"
#include "cli/option_flags.h"
#include "cli/stack_drawer.h"
#include "formats/bundle_io.h"
#include "formats/evaluator_input.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/prepare_stack.h"
#include "libbake/planes/stack_levels.h"
#include "pages/web_export.h"

namespace texbake {
namespace {

struct ExportOptions {
  std::optional<float> depth_px;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.depth_px, Field{.name = "relief",
                               .unit = "texels",
                               .min = 0,
                               .max = 1024,
                               .help = "of the coarsest scale between height 0 and 1; 0: flat and unlit",
                               .auto_help = "1/32 of the shorter side, where there are heights"});
  }
};

struct Request {
  std::string bundle;
  std::string output;
  bool web = false;
  ExportOptions options;
};

/// The relief of the page; nullptr where it has none.
std::shared_ptr<const ReliefPlanes> relief_for(const Scale& coarsest, const ExportOptions& options) {
  constexpr float kSharePerSide = 1.0f / 32;
  ReliefOptions relief;
  if (coarsest.height)
    relief.depth_px = kSharePerSide * static_cast<float>(std::min(coarsest.height->width(), coarsest.height->height()));
  if (options.depth_px) relief.depth_px = *options.depth_px;
  return relief_of(coarsest, relief, SlantOptions());
}

/// A page draws the relief of stacks; a tile with relief is a stack of one.
bool is_stack(const Bundle& bundle, const ExportOptions& options) {
  if (bundle.scales.size() > 1) return true;
  const bool has_heights = bundle.scales.front().height.has_value() && options.depth_px.value_or(1) > 0;
  return has_heights || options.depth_px.value_or(0) > 0;
}

Outcome run(const Request& request, Console& console) {
  if (!request.web)
    throw Error(ErrorKind::usage, "expected what to export for; --web is a folder that a browser opens");
  check_options(request.options);
  const std::string folder = request.output.empty() ? default_web_folder(request.bundle) : request.output;
  console.step("read");
  const Bundle bundle = read_bundle(request.bundle);
  if (is_stack(bundle, request.options)) {
    const std::vector<StackScale> scales = stack_input(bundle);
    StackPlanes planes = prepare_stack(scales);
    add_levels(planes, scales);
    const auto relief = relief_for(bundle.scales.front(), request.options);
    console.step("export");
    export_web(planes, relief.get(), folder);
  } else {
    EvaluatorPlanes planes = prepare(evaluator_input(bundle));
    add_levels(planes, planes.base);
    console.step("export");
    export_web(planes, folder);
  }
  const std::string page = folder + "/index.html";
  return {.text = page + "\n", .result = {{"output", folder}, {"page", page}}};
}

Action declare(Arguments& arguments) {
  const auto request = std::make_shared<Request>();
  add_bundle_path(arguments, request->bundle);
  arguments.option({.name = "output",
                    .letter = 'o',
                    .value = "FOLDER",
                    .names = Names::folder,
                    .standard = "NAME_web here",
                    .help = "the folder",
                    .assign = into(request->output)});
  arguments.flag({.name = "web",
                  .help = "a page that shows the endless texture, opened from the disk, without a server",
                  .assign = into(request->web)});
  add_flags(arguments, request->options, "Options");
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command export_command() {
  return {"export", "bundle → a self-contained folder for the web viewer",
          "  texbake export leaves.texbundle --web -o leaves_web\n"
          "  texbake export rock.texbundle --web --relief 24",
          declare};
}

}  // namespace texbake
