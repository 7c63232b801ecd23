#include "cli/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <new>
#include <system_error>

#include "cli/help.h"
#include "cli/parser.h"
#include "cli/resource_limits.h"
#include "cli/signals.h"
#include "formats/safe_file.h"

namespace texbake {
namespace {

/// How a run ended, for stdout and stderr.
struct Ending {
  ExitCode code = ExitCode::done;
  std::string error;  ///< "" when there was none
  Outcome outcome;
};

bool asks_for_json(const std::vector<std::string>& words) { return std::ranges::find(words, "--json") != words.end(); }

Json envelope(const std::string& verb, const Ending& ending, const std::vector<std::string>& warnings) {
  Json json;
  json["texbake"] = program_version();
  json["verb"] = verb;
  json["status"] = exit_name(ending.code);
  json["exitCode"] = static_cast<int>(ending.code);
  json["warnings"] = warnings;
  if (!ending.error.empty()) json["error"] = ending.error;
  if (!ending.outcome.result.empty()) json["result"] = ending.outcome.result;
  return json;
}

/// Writes `text` to stdout and makes sure that it arrived.
bool print_result(const std::string& text) {
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
}

/// Runs the action; every exception becomes an exit code and a message.
Ending run_action(const Action& action, const GlobalOptions& global, Console& console) {
  const auto& limit = global.max_memory_bytes;
  Ending ending;
  try {
    const ThreadLimit threads(global.threads);
    if (limit) limit_memory(*limit);
    ending.outcome = action(console);
    ending.code = ending.outcome.code;
  } catch (const Error& error) {
    ending = {exit_code_of(error.kind()), error.what(), {}};
  } catch (const std::bad_alloc&) {
    if (limit)
      ending = {
          ExitCode::limit, fmt::format("more memory is needed than --max-memory allows ({} MiB)", *limit >> 20), {}};
    else
      ending = {ExitCode::internal, "the system has no memory left; a smaller input or window needs less", {}};
  } catch (const std::system_error& error) {
    if (limit && error.code() == std::errc::resource_unavailable_try_again)
      ending = {ExitCode::limit, fmt::format("--max-memory ({} MiB) leaves no room for threads", *limit >> 20), {}};
    else
      ending = {ExitCode::internal, error.what(), {}};
  } catch (const std::exception& error) {
    ending = {ExitCode::internal, error.what(), {}};
  }
  return ending;
}

int finish(const std::string& verb, const Ending& ending, bool json, Console& console) {
  console.finish_step();
  if (!ending.error.empty()) console.error(verb.empty() ? ending.error : verb + ": " + ending.error);
  if (ending.code == ExitCode::internal && !ending.error.empty())
    console.error("this is an internal error: please report it with the command line and the input");
  const std::string text = json ? envelope(verb, ending, console.warnings()).dump(2) + "\n" : ending.outcome.text;
  if (!print_result(text)) {
    console.error("standard output: the result could not be written; is the disk full?");
    return static_cast<int>(ExitCode::io);
  }
  return static_cast<int>(ending.code);
}

/// The help or the version.
std::string answer(const CommandLine& line, const Asked& asked) {
  if (asked.what == Asked::For::version) return fmt::format("texbake {}\n", program_version());
  return asked.verb ? help_text(line, *asked.verb, help_width()) : help_text(line, help_width());
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  end_cleanly_on_signals(remove_all_unfinished);
  Console plain(Verbosity::normal, ProgressMode::never);
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const CommandLine line;
  Asked asked;
  try {
    asked = parse(line, words);
  } catch (const Error& error) {
    return finish("", {exit_code_of(error.kind()), error.what(), {}}, asks_for_json(words), plain);
  }
  if (asked.what != Asked::For::run)
    return finish("", {ExitCode::done, "", {.text = answer(line, asked)}}, false, plain);

  Console console(line.global().verbosity(), line.global().progress);
  const Ending ending = run_action(asked.verb->action, line.global(), console);
  const int code = finish(asked.verb->name(), ending, line.global().json, console);
  console.detail(fmt::format("peak memory: {} MiB", peak_memory_bytes() >> 20));
  return code;
}

}  // namespace texbake
