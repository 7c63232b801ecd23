#include "cli/stage_command.h"

#include "bake/provenance.h"
#include "formats/bundle_io.h"

namespace texbake {
namespace {

Json stage_json(const Stage& stage) {
  return {
      {"verb", stage.verb}, {"version", stage.version}, {"parameters", stage.parameters}, {"figures", stage.figures}};
}

}  // namespace

void add_bundle_paths(CLI::App& app, BundlePaths& paths) {
  app.add_option("BUNDLE", paths.input, "a folder NAME.texbundle")->required()->type_name("");
  app.add_option("-o,--output", paths.output, "the bundle to write; default: BUNDLE, in place")->type_name("BUNDLE");
}

Outcome written_bundle(const std::string& path, const std::vector<Stage>& stages) {
  Json records = Json::array();
  for (const Stage& stage : stages) records.push_back(stage_json(stage));
  return {.text = path + "\n", .result = {{"output", path}, {"stages", records}}};
}

Outcome change_bundle(const BundlePaths& paths, const std::string& verb, Console& console,
                      const std::function<void(Bundle&)>& change) {
  check_bundle_target(paths.target());
  Bundle bundle = read_bundle(paths.input);
  change(bundle);
  console.step("write");
  write_bundle(bundle, paths.target());
  return written_bundle(paths.target(), {*find_stage(bundle, verb)});
}

}  // namespace texbake
