#include "cli/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "cli/progress_line.h"
#include "cli/standard_streams.h"

namespace texbake {
namespace {

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }

/// https://no-color.org: any value but the empty one switches color off.
bool wants_color() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return !(no_color && *no_color) && stderr_is_terminal() && !(terminal && std::string_view(terminal) == "dumb");
}

std::unique_ptr<ProgressLine> make_line(Verbosity verbosity, ProgressMode mode) {
  if (mode == ProgressMode::automatic)
    mode = stderr_is_terminal() && verbosity != Verbosity::quiet ? ProgressMode::always : ProgressMode::never;
  if (mode == ProgressMode::never) return nullptr;
  return std::make_unique<ProgressLine>(mode == ProgressMode::json ? ProgressLine::Form::json
                                                                   : ProgressLine::Form::bar);
}

constexpr const char* kRed = "\033[1;31m";
constexpr const char* kYellow = "\033[1;33m";
constexpr const char* kPlain = "\033[0m";

}  // namespace

Console::Console(Verbosity verbosity, ProgressMode progress)
    : verbosity_(verbosity), colored_(wants_color()), line_(make_line(verbosity, progress)) {}

Console::~Console() { finish_step(); }

void Console::say(const char* label, const char* color, const std::string& text) {
  if (line_) line_->clear();
  const bool paint = colored_ && *color;
  write_to_stderr(fmt::format("{}{}{}{}\n", paint ? color : "", label, paint ? kPlain : "", text));
}

void Console::error(const std::string& text) { say("texbake: ", kRed, text); }

void Console::warning(const std::string& text) {
  warnings_.push_back(text);
  if (verbosity_ != Verbosity::quiet) say("warning: ", kYellow, text);
}

void Console::loss(const std::string& text) { losses_.push_back(text); }

void Console::tell_losses() {
  for (const std::string& text : losses_) warning(text);
  losses_.clear();
}

void Console::note(const std::string& text) {
  if (verbosity_ != Verbosity::quiet) say("", "", text);
}

void Console::detail(const std::string& text) {
  if (verbosity_ == Verbosity::verbose) say("", "", text);
}

Progress Console::step(const std::string& name) {
  finish_step();
  step_ = name;
  step_begin_ = std::chrono::steady_clock::now();
  if (!line_) return {};
  line_->begin(name);
  return [line = line_.get()](double done) { line->update(done); };
}

void Console::finish_step() {
  if (step_.empty()) return;
  if (line_) line_->end();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - step_begin_;
  detail(fmt::format("{}: {:.2f} s", step_, seconds.count()));
  step_.clear();
}

}  // namespace texbake
