// A stage at work on a bundle: drops what it replaces, tells how far it is, and is recorded when it is done.
#pragma once

#include <string>

#include "bake/listener.h"
#include "formats/bundle.h"

namespace texbake {

class RunningStage {
 public:
  /// Drops the last result of `verb`, and with a warning what had been derived from it. Borrows both references.
  RunningStage(Bundle& bundle, std::string verb, Listener& listener);
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
