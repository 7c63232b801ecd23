#include "cli/stage_command.h"

#include <filesystem>

#include "bake/provenance.h"
#include "cli/kept_files.h"
#include "formats/bundle_io.h"

namespace texbake {
namespace {

Json stage_json(const Stage& stage) {
  return {
      {"verb", stage.verb}, {"version", stage.version}, {"parameters", stage.parameters}, {"figures", stage.figures}};
}

void add_output(Arguments& arguments, std::string& path, const char* standard) {
  arguments.option({.name = "output",
                    .letter = 'o',
                    .value = "BUNDLE",
                    .names = Names::folder,
                    .standard = standard,
                    .help = "the bundle to write",
                    .assign = into(path)});
}

bool is_in_place(const BundlePaths& paths) {
  std::error_code failed;
  return std::filesystem::equivalent(paths.input, paths.target(), failed);
}

void write_and_tell(const Bundle& bundle, const std::string& path, Console& console) {
  console.step("write");
  write_bundle(bundle, path);
  console.tell_losses();
}

}  // namespace

void add_new_bundle_path(Arguments& arguments, std::string& path) {
  add_output(arguments, path, "NAME.texbundle here");
}

void add_changed_bundle_path(Arguments& arguments, std::string& path) {
  add_output(arguments, path, "BUNDLE, in place");
}

void add_bundle_paths(Arguments& arguments, BundlePaths& paths) {
  add_bundle_path(arguments, paths.input);
  add_changed_bundle_path(arguments, paths.output);
}

Outcome written_bundle(const std::string& path, const std::vector<Stage>& stages) {
  Json records = Json::array();
  for (const Stage& stage : stages) records.push_back(stage_json(stage));
  return {.text = path + "\n", .result = {{"output", path}, {"stages", records}}};
}

void write_new_bundle(const Bundle& bundle, const std::string& path, Console& console) {
  for (const std::string& loss : losses(path, bundle)) console.loss(loss);
  write_and_tell(bundle, path, console);
}

Outcome change_bundle(const BundlePaths& paths, const std::string& verb, const std::string& picture, Console& console,
                      const std::function<void(Bundle&)>& change) {
  check_bundle_target(paths.target());
  Bundle bundle = read_bundle(paths.input);
  check_keeps_sources(picture, bundle);
  change(bundle);
  if (is_in_place(paths))
    write_and_tell(bundle, paths.target(), console);
  else
    write_new_bundle(bundle, paths.target(), console);
  return written_bundle(paths.target(), {*find_stage(bundle, verb)});
}

}  // namespace texbake
