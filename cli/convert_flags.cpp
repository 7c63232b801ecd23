#include "cli/convert_flags.h"

#include "cli/option_flags.h"

namespace texbake {

void add_convert_flags(Arguments& arguments, ConvertRequest& request) {
  constexpr const char* kGroup = "Options of convert";
  arguments.option({.name = "map",
                    .value = "NAME=FILE",
                    .help = "another picture of the same surface, such as normal, roughness, occlusion or metallic; "
                            "\"height\" is relief, and also counts as a color coordinate; may be repeated",
                    .group = kGroup,
                    .repeat = Repeat::each,
                    .assign = [&request](const std::string& text) {
                      const NamedFile map = parse_named_file("map", text);
                      if (const std::string fault = map_name_fault(map.name); !fault.empty())
                        throw Error(ErrorKind::usage, fmt::format("--map {}: {}", map.name, fault));
                      request.files.maps.push_back({.name = map.name, .file = map.file, .sha256 = ""});
                    }});
  for_each_options(request, [&](auto& options) { add_flags(arguments, options, kGroup); });
}

}  // namespace texbake
