// What texbake says to people, on stderr: warnings, notes, progress. Results go to stdout and are not its business.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "bake/listener.h"
#include "libbake/base/options.h"

namespace texbake {

/// When progress is shown.
enum class ProgressMode {
  automatic,  ///< when stderr is a terminal
  always,     ///< a line that is rewritten
  never,
  json,  ///< one JSON object for each step, a line each
};
template <>
struct EnumNames<ProgressMode> {
  static constexpr std::pair<ProgressMode, std::string_view> values[] = {{ProgressMode::automatic, "auto"},
                                                                         {ProgressMode::always, "always"},
                                                                         {ProgressMode::never, "never"},
                                                                         {ProgressMode::json, "json"}};
};

/// How much is said. Errors are always said.
enum class Verbosity { quiet, normal, verbose };

class ProgressLine;

class Console : public Listener {
 public:
  Console(Verbosity verbosity, ProgressMode progress);
  ~Console() override;

  void error(const std::string& text);
  void warning(const std::string& text) override;  ///< also kept for the JSON result
  void loss(const std::string& text) override;     ///< kept until tell_losses
  void note(const std::string& text) override;     ///< unless quiet
  void detail(const std::string& text) override;   ///< only when verbose

  /// Warns of every loss: the result that replaces something has been written.
  void tell_losses();

  const std::vector<std::string>& warnings() const { return warnings_; }

  Progress step(const std::string& name) override;
  /// Ends the running step; with -v its seconds are told.
  void finish_step() override;

 private:
  void say(const char* label, const char* color, const std::string& text);

  Verbosity verbosity_;
  bool colored_;
  std::vector<std::string> warnings_, losses_;
  std::unique_ptr<ProgressLine> line_;
  std::string step_;
  std::chrono::steady_clock::time_point step_begin_;
};

}  // namespace texbake
