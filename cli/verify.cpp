// texbake verify: bundle → whether it is whole and consistent.
#include "formats/verify.h"

#include <algorithm>
#include <memory>

#include "cli/command.h"
#include "cli/gl_backend.h"
#include "cli/option_flags.h"
#include "cli/verify_frame.h"
#include "cli/verify_gl.h"
#include "formats/bundle_io.h"
#include "formats/drawn_bundle.h"

namespace texbake {
namespace {

/// What the issues mean for the exit code: a version that this program does not know cannot be judged.
ExitCode verdict(const std::vector<Issue>& issues) {
  ExitCode code = ExitCode::done;
  for (const Issue& issue : issues) {
    if (issue.kind().severity != Severity::error) continue;
    if (issue.kind().error == ErrorKind::unsupported) return ExitCode::unsupported;
    code = ExitCode::no;
  }
  return code;
}

const char* verdict_text(ExitCode code) {
  switch (code) {
    case ExitCode::done:
      return "valid";
    case ExitCode::unsupported:
      return "not known to this program";
    default:
      return "invalid";
  }
}

struct VerifyOptions {
  GlLanguage gl_language = GlLanguage::both;
  int windows = ParityOptions().windows;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.gl_language,
          Field{.name = "gl-language", .help = "language of the shader: OpenGL 3.3 core, OpenGL ES 3.0, or both"});
    visit(self.windows, Field{.name = "windows",
                              .min = 1,
                              .max = 65536,
                              .help = "number of random windows of 65536 points to compare for each plane with "
                                      "--backend gl; more are drawn, up to 256, until every content has been seen"});
  }
};

struct VerifyFlags {
  std::string bundle;
  VerifyOptions options;
  GlOptions gl;
  FrameRequest frame;
};

/// The bundle by itself.
Outcome judged(const std::string& path) {
  const std::vector<Issue> issues = verify_bundle(path);
  // What is not there, or cannot be read, is no bundle to judge.
  for (const Issue& issue : issues)
    if (issue.kind().error == ErrorKind::io) throw Error(ErrorKind::io, fmt::format("{}: {}", path, text(issue)));
  Outcome outcome;
  outcome.code = verdict(issues);
  Json list = Json::array();
  for (const Issue& issue : issues) {
    outcome.text += text(issue) + "\n";
    list.push_back(to_json(issue));
  }
  outcome.text += fmt::format("{}: {}\n", path, verdict_text(outcome.code));
  outcome.result = {{"bundle", path}, {"verdict", verdict_text(outcome.code)}, {"issues", list}};
  return outcome;
}

/// What was found further is told after what is known.
void append(Outcome& outcome, const Outcome& further) {
  if (outcome.code == ExitCode::done) outcome.code = further.code;
  outcome.text += further.text;
  outcome.result.update(further.result);
}

/// What the bundle looks like when something else draws it.
void compare_drawings(const VerifyFlags& request, Outcome& outcome, Console& console) {
  const bool draws = request.gl.backend == Backend::gl;
  if (!draws && request.frame.frame.empty()) return;
  const Bundle bundle = read_bundle(request.bundle);
  if (!request.frame.frame.empty()) {
    console.step("compare the frame");
    append(outcome, frame_outcome(request.frame, bundle, console));
  }
  if (!draws) return;
  console.step("compare with OpenGL");
  ParityOptions options;
  options.windows = request.options.windows;
  const DrawnMaterial material = drawn_material(bundle);
  append(outcome, parity_outcome(gl_parity(material, request.options.gl_language, request.gl.gl_device, options),
                                 material.tile_size()));
}

Outcome run(const VerifyFlags& request, Console& console) {
  check_options(request.options);
  check_options(request.gl);
  check_request(request.frame);
  console.step("verify");
  Outcome outcome = judged(request.bundle);
  if (outcome.code == ExitCode::done) compare_drawings(request, outcome, console);
  return outcome;
}

Action declare_verify(Arguments& arguments) {
  const auto request = std::make_shared<VerifyFlags>();
  add_bundle_path(arguments, request->bundle);
  const char* const shader = "The reference shader";
  add_flags(arguments, request->gl, shader);
  add_flags(arguments, request->options, shader);
  const char* const engine = "An engine's frame";
  const auto add_file = [&](const char* name, const char* value, const char* help, std::string& file) {
    arguments.option(
        {.name = name, .value = value, .names = Names::file, .help = help, .group = engine, .assign = into(file)});
  };
  add_file("frame", "FILE", "captured picture to compare: EXR (linear) or PNG (sRGB)", request->frame.frame);
  add_file("camera", "JSON",
           "what the frame shows, a JSON file: {\"window\": {\"origin\": [x, y], \"step\": 1, \"seed\": 0, \"filter\": "
           "\"bilinear\", \"map\": null}}",
           request->frame.camera);
  add_file("difference", "FILE", "write a picture of the differences; white marks the largest, and NaN",
           request->frame.difference);
  add_flags(arguments, request->frame, engine);
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command verify_command() {
  return {"verify",
          "bundle → issues: check that it is complete and consistent, and that OpenGL or an engine draws it as texbake "
          "does (exit code 1 if not)",
          "  texbake verify leaves.texbundle\n"
          "  texbake verify leaves.texbundle --backend gl\n"
          "  texbake verify leaves.texbundle --frame capture.png --camera capture.json --difference where.png",
          declare_verify};
}

}  // namespace texbake
