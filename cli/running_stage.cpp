#include "cli/running_stage.h"

#include <fmt/format.h>

#include <utility>

#include "cli/provenance.h"
#include "formats/history.h"
#include "formats/json_text.h"

namespace texbake {

RunningStage::RunningStage(Bundle& bundle, std::string verb, Console& console)
    : bundle_(bundle), verb_(std::move(verb)), console_(console) {
  const auto dropped = drop_stage(bundle_, verb_);
  if (!dropped.empty())
    console_.warning(
        fmt::format("{} runs again: dropped what was made from its last result ({})", verb_, fmt::join(dropped, ", ")));
  progress_ = console_.step(verb_);
}

void RunningStage::finish(Json parameters, Json figures) {
  console_.finish_step();
  console_.detail(fmt::format("{}: parameters {}", verb_, compact_json(parameters)));
  console_.detail(fmt::format("{}: figures {}", verb_, compact_json(figures)));
  Stage stage;
  stage.verb = verb_;
  stage.parameters = std::move(parameters);
  stage.figures = std::move(figures);
  record_stage(bundle_, std::move(stage));
}

}  // namespace texbake
