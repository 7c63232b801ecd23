#include "cli/option_flags.h"

namespace texbake {

void add_flag(CLI::App& app, const Flag& flag, const std::string& group) {
  std::string help = flag.help;
  if (!flag.standard.empty()) help += fmt::format("; default: {}", flag.standard);
  app.add_option_function<std::string>("--" + flag.name, flag.assign, help)
      ->group(group)
      ->type_name(flag.accepted)
      ->take_last();
}

}  // namespace texbake
