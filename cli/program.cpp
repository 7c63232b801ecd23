#include "cli/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>

#include "cli/help.h"
#include "cli/parser.h"
#include "cli/resource_limits.h"
#include "cli/signals.h"
#include "cli/standard_streams.h"
#include "formats/json_text.h"
#include "formats/safe_file.h"

namespace texbake {
namespace {

/// How a run ended, for stdout and stderr.
struct Ending {
  ExitCode code = ExitCode::done;
  std::string error;  ///< "" when there was none
  Outcome outcome;
  bool is_fault = false;  ///< of this program: not of what it was given, nor of the system
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

/// Did the system refuse to start a thread? Libraries tell it in exceptions of their own, in the words of the system.
bool tells_of_no_thread(const std::exception& error) {
  return std::string_view(error.what()).find(std::strerror(EAGAIN)) != std::string_view::npos;
}

/// Runs the action; every exception becomes an exit code and a message.
Ending run_action(const Action& action, const GlobalOptions& global, Console& console) {
  const auto& limit = global.max_memory_bytes;
  Ending ending;
  try {
    end_cleanly_on_signals(remove_all_unfinished);
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
  } catch (const std::filesystem::filesystem_error& error) {
    ending = {ExitCode::io, fmt::format("{}: {}", error.path1().string(), error.code().message()), {}};
  } catch (const std::exception& error) {
    if (!tells_of_no_thread(error))
      ending = {ExitCode::internal, error.what(), {}, true};
    else if (limit)
      ending = {ExitCode::limit, fmt::format("--max-memory ({} MiB) leaves no room for threads", *limit >> 20), {}};
    else
      ending = {ExitCode::internal,
                "the system lets no further thread be started; end other programs, raise the limit (ulimit -u), or try "
                "--threads 1",
                {}};
  }
  return ending;
}

int finish(const std::string& verb, const Ending& ending, bool json, Console& console) {
  console.finish_step();
  if (!ending.error.empty()) console.error(verb.empty() ? ending.error : verb + ": " + ending.error);
  if (ending.is_fault) console.error("this is an internal error: please report it with the command line and the input");
  const std::string text = json ? print_lines(envelope(verb, ending, console.warnings())) : ending.outcome.text;
  const Written written = write_to_stdout(text);
  if (written == Written::no_reader) return static_cast<int>(ExitCode::no_reader);
  if (written == Written::not_whole) {
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

/// The whole run; returns the exit code.
int run_words(const std::vector<std::string>& words) {
  Console plain(Verbosity::normal, ProgressMode::never);
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

}  // namespace

void expect_failures() { end_cleanly_on_exceptions(remove_all_unfinished, static_cast<int>(ExitCode::internal)); }

int run_program(int argc, const char* const* argv) {
  open_standard_streams();
  end_cleanly_on_exit();
  const int code = run_words({argv + std::min(argc, 1), argv + argc});
  expect_end();
  return code;
}

}  // namespace texbake
