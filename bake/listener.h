// Who is told how a bake goes on: a listener, a window, a log.
#pragma once

#include <string>

#include "libbake/base/progress.h"

namespace texbake {

/// Called on the thread that bakes. The messages are whole sentences for people.
class Listener {
 public:
  virtual ~Listener() = default;

  /// Something that the user should know, because the result may disappoint.
  virtual void warning(const std::string& text) = 0;
  /// Something that the result lacks of what it replaces: true once the result is written, and not before.
  virtual void loss(const std::string& text) { warning(text); }
  /// Something worth knowing.
  virtual void note(const std::string& text) = 0;
  /// Parameters and figures of a stage, for those who want to see everything.
  virtual void detail(const std::string& text) = 0;

  /// A step that takes time begins, and the one before it has ended. Returns what the step calls to tell how far it is,
  /// from any thread; it may be empty.
  virtual Progress step(const std::string& name) = 0;
  virtual void finish_step() = 0;
};

/// For those who do not want to be told.
class SilentListener : public Listener {
 public:
  void warning(const std::string&) override {}
  void note(const std::string&) override {}
  void detail(const std::string&) override {}
  Progress step(const std::string&) override { return {}; }
  void finish_step() override {}
};

}  // namespace texbake
