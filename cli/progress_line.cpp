#include "cli/progress_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/standard_streams.h"

namespace texbake {
namespace {

constexpr auto kInterval = std::chrono::milliseconds(100);
constexpr int kBarWidth = 30;

}  // namespace

void ProgressLine::begin(const std::string& step) {
  step_ = step;
  last_ = {};
  update(0);
}

void ProgressLine::update(double done) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < kInterval) return;
  last_ = now;
  write(std::clamp(done, 0.0, 1.0));
}

void ProgressLine::end() {
  if (form_ == Form::json) write(1);
  clear();
}

void ProgressLine::clear() {
  if (!drawn_) return;
  write_to_stderr("\r\033[K");
  drawn_ = false;
}

void ProgressLine::write(double done) {
  if (form_ == Form::json) {
    write_to_stderr(fmt::format("{{\"event\":\"progress\",\"step\":\"{}\",\"done\":{:.3f}}}\n", step_, done));
  } else {
    const int filled = static_cast<int>(done * kBarWidth);
    write_to_stderr(
        fmt::format("\r{:<16} [{:=<{}}{:{}}] {:3.0f} %", step_, "", filled, "", kBarWidth - filled, done * 100));
    drawn_ = true;
  }
}

}  // namespace texbake
