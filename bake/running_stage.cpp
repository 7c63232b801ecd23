#include "bake/running_stage.h"

#include <fmt/format.h>

#include <utility>

#include "bake/provenance.h"
#include "formats/history.h"
#include "formats/json_text.h"

namespace texbake {

RunningStage::RunningStage(Bundle& bundle, std::string verb, Listener& listener)
    : bundle_(bundle), verb_(std::move(verb)), listener_(listener), progress_(listener.step(verb_)) {}

void RunningStage::replace() {
  listener_.finish_step();
  const bool again = find_stage(bundle_, verb_) != nullptr;
  const auto dropped = drop_stage(bundle_, verb_);
  if (dropped.empty()) return;
  listener_.loss(fmt::format("{}: dropped {} ({})", verb_ + (again ? " runs again" : " had not run before"),
                             again ? "what was derived from its last result" : "what was made without it",
                             fmt::join(dropped, ", ")));
}

void RunningStage::finish(Json parameters, Json figures) {
  listener_.finish_step();
  listener_.detail(fmt::format("{}: parameters {}", verb_, compact_json(parameters)));
  listener_.detail(fmt::format("{}: figures {}", verb_, compact_json(figures)));
  Stage stage;
  stage.verb = verb_;
  stage.parameters = std::move(parameters);
  stage.figures = std::move(figures);
  record_stage(bundle_, std::move(stage));
}

}  // namespace texbake
