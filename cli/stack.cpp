// texbake stack: bundles coarse … fine → one bundle of several scales.
#include <memory>

#include "bake/stack_stage.h"
#include "cli/kept_files.h"
#include "cli/option_flags.h"
#include "cli/stage_command.h"
#include "formats/bundle_io.h"

namespace texbake {
namespace {

struct StackFlags {
  std::vector<std::string> inputs;
  std::string output;
  StackOptions options;
};

void check_count(const std::vector<std::string>& inputs) {
  if (inputs.size() >= 2 && inputs.size() <= static_cast<size_t>(kMaxScales)) return;
  throw Error(ErrorKind::usage,
              fmt::format("expected 2 to {} bundles, coarse to fine, found {}", kMaxScales, inputs.size()));
}

Outcome run(const StackFlags& request, Console& console) {
  check_count(request.inputs);
  check_options(request.options);
  transfers_of(request.options, request.inputs.size());
  check_keeps_inputs(request.output, request.inputs);
  check_bundle_target(request.output);
  console.step("read");
  std::vector<NamedBundle> bundles;
  for (const std::string& path : request.inputs) bundles.push_back({path, read_bundle(path)});
  const Bundle stack = run_stack(std::move(bundles), request.options, console);
  write_new_bundle(stack, request.output, console);
  return written_bundle(request.output, {stack.stages.back()});
}

Action declare_stack(Arguments& arguments) {
  const auto request = std::make_shared<StackFlags>();
  arguments.positional({.name = "BUNDLES",
                        .names = Names::folder,
                        .help = "two or more bundles (folders NAME.texbundle) of one scale each, coarse to fine",
                        .repeat = Repeat::each,
                        .assign = into(request->inputs)});
  arguments.option({.name = "output",
                    .letter = 'o',
                    .value = "BUNDLE",
                    .names = Names::folder,
                    .help = "the bundle to write",
                    .required = true,
                    .assign = into(request->output)});
  add_flags(arguments, request->options, "Options");
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command stack_command() {
  return {"stack", "bundles, coarse ... fine → bundle: make one material that holds from far away to close up",
          "  texbake stack cliff.texbundle rock.texbundle --ratio 16 -o wall.texbundle\n"
          "  texbake stack far.texbundle mid.texbundle near.texbundle --ratio 8,16 -o ground.texbundle",
          declare_stack};
}

}  // namespace texbake
