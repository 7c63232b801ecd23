// texbake verify: bundle → whether it is whole and consistent.
#include "formats/verify.h"

#include <algorithm>
#include <memory>

#include "cli/command.h"

namespace texbake {
namespace {

/// What the issues mean for the exit code: a version that this program does not know cannot be judged.
ExitCode verdict(const std::vector<Issue>& issues) {
  ExitCode code = ExitCode::done;
  for (const Issue& issue : issues) {
    if (issue.kind().severity != Severity::error) continue;
    if (issue.kind().error == ErrorKind::unsupported) return ExitCode::unsupported;
    code = ExitCode::no;
  }
  return code;
}

const char* verdict_text(ExitCode code) {
  switch (code) {
    case ExitCode::done:
      return "valid";
    case ExitCode::unsupported:
      return "not known to this program";
    default:
      return "invalid";
  }
}

Outcome run(const std::string& path, Console& console) {
  console.step("verify");
  const std::vector<Issue> issues = verify_bundle(path);
  // What is not there, or cannot be read, is no bundle to judge.
  for (const Issue& issue : issues)
    if (issue.kind().error == ErrorKind::io) throw Error(ErrorKind::io, fmt::format("{}: {}", path, text(issue)));
  Outcome outcome;
  outcome.code = verdict(issues);
  Json list = Json::array();
  for (const Issue& issue : issues) {
    outcome.text += text(issue) + "\n";
    list.push_back(to_json(issue));
  }
  outcome.text += fmt::format("{}: {}\n", path, verdict_text(outcome.code));
  outcome.result = {{"bundle", path}, {"verdict", verdict_text(outcome.code)}, {"issues", list}};
  return outcome;
}

Action declare(CLI::App& app) {
  const auto path = std::make_shared<std::string>();
  app.add_option("BUNDLE", *path, "a folder NAME.texbundle")->required()->type_name("");
  return [path](Console& console) { return run(*path, console); };
}

}  // namespace

Command verify_command() {
  return {"verify", "bundle → report: whether it is whole and consistent (exit code 1 when it is not)",
          "  texbake verify leaves.texbundle", declare};
}

}  // namespace texbake
