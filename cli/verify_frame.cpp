#include "cli/verify_frame.h"

#include <cmath>

#include "cli/bundle_path.h"
#include "cli/camera.h"
#include "cli/kept_files.h"
#include "formats/drawn_bundle.h"
#include "formats/frame.h"
#include "formats/image_writer.h"
#include "formats/json_text.h"
#include "libbake/draw/compare.h"
#include "libbake/draw/drawing.h"

namespace texbake {
namespace {

/// Throws Error(bad_data) where the frame has another size than the camera file says.
void check_size(const Camera& camera, PixelSize size, const FrameRequest& request) {
  const auto& stated = camera.frame_size;
  if (stated && (stated->width != size.width || stated->height != size.height))
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: expected {} x {} pixels, as {} says, found {} x {}", request.frame, stated->width,
                            stated->height, request.camera, size.width, size.height));
}

/// Channels of a frame of what the camera shows. Throws Error(bad_data) where the bundle cannot show it.
int channels_of(const Camera& camera, const Bundle& bundle, const std::string& path) {
  try {
    const V2i tile_size = bundle.scales.back().size();
    const DrawRequest picture = draw_request_of(camera.picture, {1, 1}, tile_size);
    return drawn_channels(drawn_material(bundle), picture);
  } catch (const Error& error) {
    throw Error(ErrorKind::bad_data, fmt::format("{}: {}", path, error.what()));
  }
}

/// Every difference as light: white is the greatest one, or NaN.
void write_difference(const std::string& path, const Image<V3f>& expected, const Image<V3f>& found,
                      const ValueComparison& comparison) {
  const float worst = comparison.worst ? comparison.worst->difference : 0;
  const float gain = worst > 0 && std::isfinite(worst) ? 1 / worst : 1;
  write_picture(path, difference_picture(expected, found, gain), PictureRole::data);
}

/// The frame beside the reference, in light and in steps of its samples.
struct Finding {
  const CapturedFrame& frame;
  const Image<V3f>& expected;
  ValueComparison comparison;
  float tolerance;

  const char* unit() const { return frame.scale.code == SampleCode::float32 ? "" : " steps"; }
};

std::string text(const Finding& finding, const std::string& path) {
  const ValueComparison& c = finding.comparison;
  std::string out = fmt::format("{}: {} the reference\n", path, c.differing_pixels > 0 ? "differs from" : "equals");
  out += fmt::format("  {} pixels of {}: {} differ by more than {}{}, {} are NaN; mean difference {:.4g}{}\n", c.pixels,
                     sample_name(finding.frame.scale), c.differing_pixels, finding.tolerance, finding.unit(),
                     c.nan_pixels, c.mean_difference, finding.unit());
  if (const auto& worst = c.worst)
    out += fmt::format("  worst: pixel ({}, {}): expected {}, found {}, {:.4g}{} apart\n", worst->x, worst->y,
                       vector_text(finding.expected(worst->x, worst->y)),
                       vector_text(finding.frame.values(worst->x, worst->y)), worst->difference, finding.unit());
  return out;
}

Json json_of(const Finding& finding, const FrameRequest& request) {
  const ValueComparison& c = finding.comparison;
  Json json = {{"file", request.frame},
               {"camera", request.camera},
               {"equal", c.differing_pixels == 0},
               {"samples", sample_name(finding.frame.scale)},
               {"pixels", c.pixels},
               {"tolerance", json_number(finding.tolerance)},
               {"differingPixels", c.differing_pixels},
               {"nanPixels", c.nan_pixels},
               {"meanDifference", c.mean_difference}};
  if (const auto& worst = c.worst)
    json["worst"] = {{"pixel", {worst->x, worst->y}},
                     {"expected", vector_json(finding.expected(worst->x, worst->y))},
                     {"found", vector_json(finding.frame.values(worst->x, worst->y))},
                     {"difference", json_number(worst->difference)}};
  if (!request.difference.empty()) json["difference"] = request.difference;
  return json;
}

}  // namespace

void check_request(const FrameRequest& request) {
  const auto refuse = [](const char* what) { throw Error(ErrorKind::usage, what); };
  check_options(request);
  if (request.frame.empty() != request.camera.empty())
    refuse("expected --frame and --camera together: the picture, and a description of what it shows");
  if (request.frame.empty() && request.tolerance) refuse("--tolerance: expected a --frame to compare");
  if (request.frame.empty() && !request.difference.empty()) refuse("--difference: expected a --frame to compare");
  if (request.difference.empty()) return;
  check_picture_name(request.difference);
  check_file_target(request.difference);
  check_keeps_inputs(request.difference, std::vector{request.frame, request.camera});
}

Outcome frame_outcome(const FrameRequest& request, const Bundle& bundle, Console& console) {
  check_keeps_sources(request.difference, bundle);
  const Camera camera = read_camera(request.camera);
  const int channels = channels_of(camera, bundle, request.camera);
  const CapturedFrame frame =
      read_frame(request.frame, picture_role(bundle, camera.picture.map.value_or("")), channels);
  for (const std::string& note : frame.notes) console.note(note);
  const PixelSize size{frame.values.width(), frame.values.height()};
  check_size(camera, size, request);
  const Drawing drawing(drawn_material(bundle), draw_request_of(camera.picture, size, bundle.scales.back().size()));
  const Image<V3f> expected = drawing.rows(0, size.height);

  const Image<V3f> expected_steps = in_steps(expected, frame.scale), found_steps = in_steps(frame.values, frame.scale);
  const float tolerance = request.tolerance.value_or(default_tolerance(frame.scale));
  const Finding finding{frame, expected, compare_values(expected_steps, found_steps, tolerance), tolerance};
  if (!request.difference.empty())
    write_difference(request.difference, expected_steps, found_steps, finding.comparison);

  Outcome outcome;
  outcome.code = finding.comparison.differing_pixels > 0 ? ExitCode::no : ExitCode::done;
  outcome.text = text(finding, request.frame);
  outcome.result["frame"] = json_of(finding, request);
  return outcome;
}

}  // namespace texbake
