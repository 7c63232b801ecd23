// A stage at work on a bundle: tells how far it is, drops what it replaces once that is made, and is recorded.
#pragma once

#include <string>

#include "bake/listener.h"
#include "formats/bundle.h"

namespace texbake {

class RunningStage {
 public:
  /// Changes nothing in `bundle`: a stage that throws at work leaves it as it was. Borrows both references.
  RunningStage(Bundle& bundle, std::string verb, Listener& listener);
  /// The work is done and its result is about to be put into the bundle: drops the last result of `verb`, and what
  /// had been derived from it, which is told as a loss.
  void replace();
  /// Records the stage: `parameters` in kebab-case, `figures` in camelCase.
  void finish(Json parameters, Json figures);

  const Progress& progress() const { return progress_; }

 private:
  Bundle& bundle_;
  std::string verb_;
  Listener& listener_;
  Progress progress_;
};

}  // namespace texbake
