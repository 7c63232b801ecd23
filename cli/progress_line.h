// One line on stderr that tells how far a step is, or one JSON object for each advance.
#pragma once

#include <chrono>
#include <string>

namespace texbake {

class ProgressLine {
 public:
  enum class Form { bar, json };
  explicit ProgressLine(Form form) : form_(form) {}

  void begin(const std::string& step);
  /// `done` is 0 … 1. Written at most ten times a second.
  void update(double done);
  void end();
  /// Makes room for other text; the next update draws the line again.
  void clear();

 private:
  void write(double done);

  Form form_;
  std::string step_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace texbake
