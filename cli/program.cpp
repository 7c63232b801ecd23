#include "cli/program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <new>
#include <system_error>

#include "cli/command.h"
#include "cli/global_options.h"
#include "cli/limits.h"
#include "cli/signals.h"
#include "formats/safe_file.h"
#include "libbake/base/suggestion.h"

namespace texbake {
namespace {

constexpr const char* kVersion = TEXBAKE_VERSION;

std::vector<Command> all_commands() {
  return {bake_command(),   convert_command(),         decompose_command(), estimate_psd_command(), fragment_command(),
          patch_command(),  select_contents_command(), heightmap_command(), stack_command(),        render_command(),
          verify_command(), report_command(),          info_command(),      export_command()};
}

/// How a run ended, for stdout and stderr.
struct Ending {
  ExitCode code = ExitCode::done;
  std::string error;  ///< "" when there was none
  Outcome outcome;
};

/// The command line, declared; and what the parse found in it.
class CommandLine {
 public:
  CommandLine();
  /// Throws CLI::Success for --help and --version, CLI::ParseError and Error(usage) for mistakes.
  void parse(int argc, const char* const* argv);
  int print_help(const CLI::Success& request) { return app_.exit(request); }
  /// What a parse error means, with a suggestion where a word is near.
  std::string explain(const CLI::ParseError& error);

  const std::string& verb() const { return verb_; }
  const Action& action() const { return actions_.at(verb_); }
  const GlobalOptions& global() const { return global_; }

 private:
  void check_verb(int argc, const char* const* argv) const;

  CLI::App app_{"texbake bakes a photograph into an endless, non-repeating texture.", "texbake"};
  GlobalOptions global_;
  std::vector<std::string> verbs_;
  std::map<std::string, Action> actions_;
  std::string verb_;
};

CommandLine::CommandLine() {
  app_.set_version_flag("--version", std::string("texbake ") + kVersion);
  app_.footer(
      "texbake VERB --help tells the options of a verb.\n\nExample:\n"
      "  texbake bake leaves.jpg -o leaves.texbundle\n"
      "  texbake render leaves.texbundle -o leaves.png --size 4096x4096");
  for (const Command& command : all_commands()) {
    CLI::App* verb = app_.add_subcommand(command.verb, command.summary);
    verb->footer("Example:\n" + command.example);
    verb->get_formatter()->column_width(44);
    actions_[command.verb] = command.declare(*verb);
    add_global_flags(*verb, global_);
    verbs_.push_back(command.verb);
  }
}

void CommandLine::check_verb(int argc, const char* const* argv) const {
  if (argc < 2) throw Error(ErrorKind::usage, "expected a verb; texbake --help lists them");
  const std::string word = argv[1];
  if (word.starts_with("-") || std::find(verbs_.begin(), verbs_.end(), word) != verbs_.end()) return;
  throw Error(ErrorKind::usage, fmt::format("unknown verb \"{}\"{} texbake --help lists the verbs", word,
                                            suggestion(word, verbs_).empty() ? ";" : suggestion(word, verbs_)));
}

void CommandLine::parse(int argc, const char* const* argv) {
  check_verb(argc, argv);
  app_.parse(argc, argv);
  const auto chosen = app_.get_subcommands();
  if (chosen.empty()) throw Error(ErrorKind::usage, "expected a verb; texbake --help lists them");
  verb_ = chosen.front()->get_name();
}

std::string CommandLine::explain(const CLI::ParseError& error) {
  const auto chosen = app_.get_subcommands();
  const CLI::App& where = chosen.empty() ? app_ : *chosen.front();
  const std::string help = fmt::format("; see {} --help", chosen.empty() ? "texbake" : "texbake " + where.get_name());

  std::vector<std::string> known;
  for (const CLI::Option* option : where.get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  for (const std::string& word : where.remaining(true)) {
    const std::string name = word.substr(0, word.find('='));
    const std::string near = suggestion(name, known);
    return word.starts_with("-") ? fmt::format("unknown option \"{}\"{}", name, near.empty() ? help : near)
                                 : fmt::format("unexpected argument \"{}\"{}", word, help);
  }
  return error.what() + help;
}

bool asks_for_json(int argc, const char* const* argv) {
  return std::any_of(argv, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
}

Json envelope(const std::string& verb, const Ending& ending, const std::vector<std::string>& warnings) {
  Json json;
  json["texbake"] = kVersion;
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
Ending run_action(const CommandLine& line, Console& console) {
  const auto& limit = line.global().max_memory_bytes;
  Ending ending;
  try {
    const ThreadLimit threads(line.global().threads);
    if (limit) limit_memory(*limit);
    ending.outcome = line.action()(console);
    ending.code = ending.outcome.code;
  } catch (const Error& error) {
    ending = {exit_code_of(error.kind()), error.what(), {}};
  } catch (const std::bad_alloc&) {
    if (limit)
      ending = {
          ExitCode::limit, fmt::format("more memory is needed than --max-memory grants ({} MiB)", *limit >> 20), {}};
    else
      ending = {ExitCode::internal, "the system has no memory left for this; a smaller input or window takes less", {}};
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
    console.error("this is a mistake of the program: please report it with the command line and the input");
  const std::string text = json ? envelope(verb, ending, console.warnings()).dump(2) + "\n" : ending.outcome.text;
  if (!print_result(text)) {
    console.error("standard output: the result could not be written; is the disk full?");
    return static_cast<int>(ExitCode::io);
  }
  return static_cast<int>(ending.code);
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  end_cleanly_on_signals(remove_all_unfinished);
  Console plain(Verbosity::normal, ProgressMode::never);
  CommandLine line;
  Ending mistake{ExitCode::usage, "", {}};
  try {
    line.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return line.print_help(request);
  } catch (const CLI::ParseError& error) {
    mistake.error = line.explain(error);
  } catch (const Error& error) {
    mistake.code = exit_code_of(error.kind());
    mistake.error = error.what();
  }
  if (!mistake.error.empty()) return finish("", mistake, asks_for_json(argc, argv), plain);

  Console console(line.global().verbosity(), line.global().progress);
  const Ending ending = run_action(line, console);
  const int code = finish(line.verb(), ending, line.global().json, console);
  console.detail(fmt::format("peak memory: {} MiB", peak_memory_bytes() >> 20));
  return code;
}

}  // namespace texbake
