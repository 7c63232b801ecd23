// The verbs that run one stage on a bundle: read, run and record, write.
#pragma once

#include <memory>
#include <string>

#include "cli/bundle_path.h"
#include "cli/command.h"
#include "cli/option_flags.h"
#include "cli/sheets.h"

namespace texbake {

/// What a verb from bundle to bundle was given.
struct BundlePaths {
  std::string input;
  std::string output;  ///< "": in place

  const std::string& target() const { return output.empty() ? input : output; }
};

/// Adds BUNDLE and -o. `paths` must outlive the parse.
void add_bundle_paths(Arguments& arguments, BundlePaths& paths);

/// Adds -o: a new bundle beside nothing else, or the changed one. `path` must outlive the parse.
void add_new_bundle_path(Arguments& arguments, std::string& path);
void add_changed_bundle_path(Arguments& arguments, std::string& path);

/// Reads the bundle, lets `change` work on it, writes it. The outcome tells the record of stage `verb`. `picture` is a
/// file that `change` writes too, or "".
Outcome change_bundle(const BundlePaths& paths, const std::string& verb, const std::string& picture, Console& console,
                      const std::function<void(Bundle&)>& change);

/// Writes a bundle that was made anew to `path`; then warns of what another bundle there had that this one has not.
void write_new_bundle(const Bundle& bundle, const std::string& path, Console& console);

/// What a verb that has written a bundle says: its path for people, path and record of stages for programs.
Outcome written_bundle(const std::string& path, const std::vector<Stage>& stages);

/// A verb whose whole work is `run`, a function of bake/stages.h. `sheet` draws what the options of a bundle may be set
/// to; nullptr for a verb without --sheet.
template <class Options>
Command stage_command(const std::string& verb, const std::string& summary, const std::string& example,
                      void (*run)(Bundle&, const Options&, Listener&),
                      Sheet (*sheet)(const Bundle&, const Options&, const Progress&) = nullptr) {
  struct Request {
    BundlePaths paths;
    Options options;
    std::string sheet;
  };
  const auto declare = [verb, run, sheet](Arguments& arguments) -> Action {
    const auto request = std::make_shared<Request>();
    add_bundle_paths(arguments, request->paths);
    add_flags(arguments, request->options, "Options");
    if (sheet) add_sheet_flag(arguments, request->sheet);
    return [verb, run, sheet, request](Console& console) {
      check_sheet(request->sheet);
      return change_bundle(request->paths, verb, request->sheet, console, [&](Bundle& bundle) {
        run(bundle, request->options, console);
        if (!request->sheet.empty())
          write_sheet(request->sheet, sheet(bundle, request->options, console.step("sheet")));
      });
    };
  };
  return {verb, summary, example, declare};
}

}  // namespace texbake
