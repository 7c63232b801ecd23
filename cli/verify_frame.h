// texbake verify --frame: a frame that an engine drew against the reference.
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "formats/bundle.h"

namespace texbake {

struct FrameRequest {
  std::string frame;       ///< picture; "" when none is to be compared
  std::string camera;      ///< JSON, see cli/camera.h
  std::string difference;  ///< picture to write, or ""
  std::optional<float> tolerance;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.tolerance,
          Field{.name = "tolerance",
                .unit = "steps of the frame's samples",
                .min = 0,
                .max = 65536,
                .help = "largest difference allowed between a channel and the reference; for float samples, absolute",
                .auto_help = "0.6 of a code for 8 or 16 bits, 1 half float, 0 for float"});
  }
};

/// Throws Error(usage) for a part of the request that means nothing without another.
void check_request(const FrameRequest& request);

/// What was found, for people and for JSON; ExitCode::no where the frame differs by more than the tolerance. Writes the
/// difference where it was asked for. Throws Error for a frame or camera file that cannot be judged.
Outcome frame_outcome(const FrameRequest& request, const Bundle& bundle, Console& console);

}  // namespace texbake
