#include "cli/global_options.h"

#include "cli/option_flags.h"

namespace texbake {
namespace {

constexpr const char* kGroup = "For every verb";

}  // namespace

void add_global_flags(CLI::App& app, GlobalOptions& options) {
  CLI::Option* quiet = app.add_flag("-q,--quiet", options.quiet, "say nothing but errors")->group(kGroup);
  app.add_flag("-v,--verbose", options.verbose, "tell seconds, chosen values and memory")
      ->group(kGroup)
      ->excludes(quiet);
  app.add_flag("--json", options.json, "write one JSON object to stdout (schema: cli/output.schema.json)")
      ->group(kGroup);
  add_flag(app,
           {.name = "progress",
            .accepted = accepted_text<ProgressMode>({}),
            .standard = "auto (a line when stderr is a terminal)",
            .help = "progress on stderr",
            .assign = [&](const std::string& text) { assign_text(options.progress, "progress", {}, text); }},
           kGroup);
  const Field threads{.name = "threads", .unit = "threads", .min = 0, .max = 1024};
  app.add_option_function<std::string>(
         "-j,--threads",
         [&options, threads](const std::string& text) { assign_text(options.threads, "threads", threads, text); },
         "0 = all; never changes a result; default: 0")
      ->group(kGroup)
      ->type_name(number_range_text(threads));
  add_flag(app,
           {.name = "max-memory",
            .accepted = "SIZE such as 512M or 4G",
            .standard = "no limit",
            .help = "end with exit code 7 rather than take more memory",
            .assign = [&](const std::string& text) { options.max_memory_bytes = parse_bytes("max-memory", text); }},
           kGroup);
}

}  // namespace texbake
