#include "cli/convert_flags.h"

#include "cli/option_flags.h"

namespace texbake {

void add_convert_flags(CLI::App& app, ConvertRequest& request) {
  constexpr const char* kGroup = "Options of convert";
  app.add_option_function<std::vector<std::string>>(
         "--map",
         [&request](const std::vector<std::string>& list) {
           for (const std::string& text : list) {
             const NamedFile map = parse_named_file("map", text);
             request.files.maps.push_back({.name = map.name, .file = map.file, .sha256 = ""});
           }
         },
         "another picture of the same surface, such as normal, roughness, occlusion, metallic; height is relief and "
         "counts among the colours; may be repeated")
      ->group(kGroup)
      ->type_name("NAME=FILE")
      ->allow_extra_args(false);
  for_each_options(request, [&](auto& options) { add_flags(app, options, kGroup); });
}

}  // namespace texbake
