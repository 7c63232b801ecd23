#include "cli/global_options.h"

#include "cli/option_flags.h"

namespace texbake {
void add_global_flags(Arguments& arguments, GlobalOptions& options) {
  arguments.flag({.name = "quiet",
                  .letter = 'q',
                  .help = "print errors only",
                  .group = kForEveryVerb,
                  .assign = into(options.quiet)});
  arguments.flag({.name = "verbose",
                  .letter = 'v',
                  .help = "print times, automatically chosen values, and memory use",
                  .group = kForEveryVerb,
                  .excludes = "quiet",
                  .assign = into(options.verbose)});
  arguments.flag({.name = "json",
                  .help = "write one JSON object to stdout (schema: cli/output.schema.json)",
                  .group = kForEveryVerb,
                  .assign = into(options.json)});
  Argument progress =
      option_of(options.progress, {.name = "progress", .help = "how progress is shown on stderr"}, "progress");
  progress.standard = "auto (one line if stderr is a terminal)";
  progress.group = kForEveryVerb;
  arguments.option(progress);
  const Field threads_field{.name = "threads",
                            .unit = "threads",
                            .min = 0,
                            .max = 1024,
                            .help = "number of threads; 0: all; never changes a result"};
  Argument threads = option_of(options.threads, threads_field, "threads");
  threads.letter = 'j';
  threads.group = kForEveryVerb;
  threads.repeat = Repeat::never;
  arguments.option(threads);
  arguments.option(
      {.name = "max-memory",
       .value = "SIZE such as 512M or 4G",
       .standard = "no limit",
       .help = "end with exit code 7 instead of using more memory than this",
       .group = kForEveryVerb,
       .repeat = Repeat::last,
       .assign = [&](const std::string& text) { options.max_memory_bytes = parse_bytes("max-memory", text); }});
}

}  // namespace texbake
