#include "cli/command.h"

namespace texbake {

void add_bundle_path(Arguments& arguments, std::string& path) {
  arguments.positional(
      {.name = "BUNDLE", .names = Names::folder, .help = "the bundle: a folder NAME.texbundle", .assign = into(path)});
}

std::vector<Command> all_commands() {
  return {bake_command(),   convert_command(),         decompose_command(), estimate_psd_command(), fragment_command(),
          patch_command(),  select_contents_command(), heightmap_command(), stack_command(),        render_command(),
          verify_command(), report_command(),          info_command(),      export_command()};
}

}  // namespace texbake
