// texbake render: bundle → picture of a window of the infinite texture.
#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/bundle_path.h"
#include "cli/command.h"
#include "cli/evaluator_input.h"
#include "cli/option_flags.h"
#include "cli/suggestion.h"
#include "formats/bundle_io.h"
#include "formats/image_writer.h"
#include "libbake/eval/show.h"

namespace texbake {
namespace {

struct RenderOptions {
  std::string size = "1024x1024";
  std::string origin = "0,0";
  double step_texels = 1;
  uint32_t seed = 0;
  Filter filter = Filter::bilinear;
  Show show = Show::color;
  std::optional<SampleType> bits;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.size,
          Field{.name = "size", .unit = "WIDTHxHEIGHT", .help = "of the picture in pixels; one number makes a square"});
    visit(self.origin, Field{.name = "origin",
                             .unit = "X,Y",
                             .help = "of its upper left corner in texels; may be negative, far, decimal"});
    visit(self.step_texels, Field{.name = "step",
                                  .unit = "texels",
                                  .min = 0.00390625,
                                  .max = 65536,
                                  .help = "texels from one pixel to the next, in steps of 1/256"});
    visit(self.seed, Field{.name = "seed",
                           .min = 0,
                           .max = 4294967295.0,
                           .help = "another one gives another texture "
                                   "of the same bundle"});
    visit(self.filter, Field{.name = "filter", .help = "how a pixel is found between texels"});
    visit(self.show, Field{.name = "show", .help = "the texture, or how it is put together"});
    visit(self.bits, Field{.name = "bits",
                           .help = "of one sample: 8 or 16 in PNG (sRGB), half or float in EXR (linear)",
                           .auto_help = "8 in PNG, half in EXR"});
  }
};

struct Request {
  std::string bundle;
  std::string output;
  std::string map;
  RenderOptions options;
};

/// Rows that are drawn at a time: about this many pixels are held, whatever the size of the picture.
constexpr int kStripPixels = 1 << 20;
constexpr double kStepsPerTexel = 256;  // of Window::step_256

Window window_of(const RenderOptions& options, V2i tile_size) {
  const PixelSize size = parse_size("size", options.size);
  const DecimalPoint origin = parse_point("origin", options.origin);
  Window window;
  window.origin_x = tile_offset(origin.x, tile_size.x, "origin");
  window.origin_y = tile_offset(origin.y, tile_size.y, "origin");
  window.step_256 = static_cast<uint32_t>(std::lround(options.step_texels * kStepsPerTexel));
  window.width = size.width;
  window.height = size.height;
  window.seed = options.seed;
  window.filter = options.filter;
  check_window(window, tile_size);
  return window;
}

const Plane& chosen_map(const EvaluatorPlanes& planes, const std::string& name) {
  if (const Plane* map = planes.map(name)) return *map;
  std::vector<std::string> known;
  for (const Plane& map : planes.maps) known.push_back(map.name);
  const std::string list =
      known.empty() ? "the bundle has no maps" : fmt::format("the bundle has {}", fmt::join(known, ", "));
  throw Error(ErrorKind::usage, fmt::format("--map: no map \"{}\"{}; {}", name, suggestion(name, known), list));
}

PictureRole role_of(const Plane& map) {
  const bool normal = map.kind == MapKind::normal_opengl || map.kind == MapKind::normal_directx;
  return normal ? PictureRole::normal : PictureRole::data;
}

/// Draws by strips of rows, so that a window of any size takes the same memory.
template <class DrawRows>
void stream(const std::string& path, const PictureFormat& format, const DrawRows& draw_rows, Console& console) {
  const Progress progress = console.step("render");
  PictureWriter writer(path, format);
  const int strip = std::max(1, kStripPixels / format.width);
  for (int row = 0; row < format.height; row += strip) {
    const int end = std::min(format.height, row + strip);
    writer.write_rows(draw_rows(row, end).view());
    report(progress, static_cast<double>(end) / format.height);
  }
  writer.close();
  console.finish_step();
}

void render(const Request& request, const std::string& path, Console& console) {
  console.step("read");
  const Bundle bundle = read_bundle(request.bundle);
  const EvaluatorPlanes planes = prepare(evaluator_input(bundle.scales.back()));
  const Window window = window_of(request.options, planes.size);
  PictureFormat format{.width = window.width, .height = window.height, .samples = request.options.bits};
  if (request.map.empty()) {
    const auto rows = [&](int begin, int end) { return show_rows(planes, window, request.options.show, begin, end); };
    return stream(path, format, rows, console);
  }
  const Plane& map = chosen_map(planes, request.map);
  format.channels = map.channels;
  format.role = role_of(map);
  const auto rows = [&](int begin, int end) { return render_map_rows(planes, map, window, begin, end); };
  stream(path, format, rows, console);
}

Outcome run(const Request& request, Console& console) {
  const std::string path = request.output.empty() ? default_picture_path(request.bundle, ".png") : request.output;
  check_options(request.options);
  check_picture_name(path, request.options.bits);
  parse_size("size", request.options.size);
  check_file_target(path);
  render(request, path, console);
  return {.text = path + "\n", .result = {{"output", path}}};
}

Action declare(CLI::App& app) {
  const auto request = std::make_shared<Request>();
  app.add_option("BUNDLE", request->bundle, "a folder NAME.texbundle")->required()->type_name("");
  app.add_option("-o,--output", request->output, "the picture: .png or .exr; default: NAME.png here")
      ->type_name("FILE");
  add_flags(app, request->options, "Options");
  add_flag(app,
           {.name = "map",
            .accepted = "NAME",
            .standard = "the colour",
            .help = "draw this map of the material instead",
            .assign = [request](const std::string& name) { request->map = name; }},
           "Options");
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command render_command() {
  return {"render", "bundle → picture: a window of the infinite texture",
          "  texbake render leaves.texbundle -o leaves.png --size 4096x4096\n"
          "  texbake render leaves.texbundle -o patches.png --show patches --origin -512,99999999999\n"
          "  texbake render rock.texbundle -o normal.png --map normal",
          declare};
}

}  // namespace texbake
