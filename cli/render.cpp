// texbake render: bundle → picture of the infinite texture, a window of it or an endless plane in perspective.
#include <algorithm>
#include <memory>

#include "cli/bundle_path.h"
#include "cli/command.h"
#include "cli/gl_backend.h"
#include "cli/option_flags.h"
#include "cli/stack_drawer.h"
#include "cli/view_options.h"
#include "formats/bundle_io.h"
#include "formats/evaluator_input.h"
#include "formats/image_writer.h"
#include "libbake/draw/show.h"
#include "libbake/draw/supersample.h"
#include "libbake/draw/window_rows.h"
#include "libbake/planes/levels.h"
#include "libbake/planes/prepare.h"

namespace texbake {
namespace {

struct RenderOptions {
  std::string size = "1024x1024";
  Show show = Show::color;
  std::optional<SampleType> bits;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.size,
          Field{.name = "size", .unit = "WIDTHxHEIGHT", .help = "of the picture in pixels; one number makes a square"});
    visit(self.show, Field{.name = "show", .help = "the texture, or how it is put together"});
    visit(self.bits, Field{.name = "bits",
                           .help = "of one sample: 8 or 16 in PNG (sRGB), half or float in EXR (linear)",
                           .auto_help = "8 in PNG, half in EXR"});
  }
};

/// The deformation, as it is told.
struct DeformOptions {
  double rotate = 0;
  std::string stretch = "1";
  double turbulence = 0;
  int turbulence_cell = DeformationRequest().turbulence_cell;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.rotate, Field{.name = "rotate",
                             .unit = "degrees",
                             .min = -360,
                             .max = 360,
                             .help = "turn the structure clockwise about the origin; grain keeps its direction"});
    visit(self.stretch, Field{.name = "stretch",
                              .unit = "FACTOR or X,Y",
                              .help = "show the structure so many times as large, 0.5 to 64; grain keeps its size"});
    visit(self.turbulence, Field{.name = "turbulence",
                                 .unit = "texels",
                                 .min = 0,
                                 .max = 64,
                                 .help = "stir the structure by about so much"});
    visit(self.turbulence_cell, Field{.name = "turbulence-cell",
                                      .unit = "texels",
                                      .min = 64,
                                      .max = 1024,
                                      .help = "size of the largest eddies, a power of two"});
  }
};

struct Request {
  std::string bundle;
  std::string output;
  std::optional<std::string> map;
  RenderOptions options;
  DeformOptions deform;
  WindowOptions window;
  ViewOptions view;
  ReliefOptions relief;
  SlantOptions slant;
  GlOptions gl;
};

/// Rows that are drawn at a time: about this many pixels are held, whatever the size of the picture.
constexpr int kStripPixels = 1 << 20;

Deformation deformation_of(const DeformOptions& options) {
  DeformationRequest request;
  request.rotate_degrees = options.rotate;
  const std::string both =
      options.stretch.find(',') == std::string::npos ? options.stretch + "," + options.stretch : options.stretch;
  const DecimalPoint stretch = parse_point("stretch", both);
  const Field factor{.name = "stretch", .unit = "times", .min = 0.5, .max = 64};
  request.stretch_x = parse_number(factor.name, factor, stretch.x);
  request.stretch_y = parse_number(factor.name, factor, stretch.y);
  request.turbulence_texels = options.turbulence;
  request.turbulence_cell = options.turbulence_cell;
  return deformation_of(request);
}

/// The reference shader has no views: their tables are no part of what an engine binds.
void check_show(const Request& request) {
  const bool is_deformed = !deformation_of(request.deform).is_identity();
  if (is_deformed && (request.map || request.options.show != Show::color))
    throw Error(ErrorKind::usage,
                "--rotate, --stretch, --turbulence: deform the colour alone; expected neither --map nor --show");
  if (request.options.show == Show::color) return;
  const std::string asked = fmt::format("--show {}", enum_name(request.options.show));
  if (request.map) throw Error(ErrorKind::usage, asked + ": a view shows the texture; expected no --map beside it");
  if (request.gl.backend == Backend::gl)
    throw Error(ErrorKind::usage, asked + ": the reference shader draws colours and maps alone; use --backend cpu");
  if (request.view.view == View::plane || request.view.supersample > 1)
    throw Error(ErrorKind::usage, asked + ": a view shows whole texels; expected no --view plane or --supersample");
}

void check_deformation(const Request& request) {
  if (deformation_of(request.deform).is_identity()) return;
  if (request.view.view == View::plane || request.view.supersample > 1)
    throw Error(
        ErrorKind::usage,
        "--rotate, --stretch, --turbulence: a flat window is deformed; expected no --view plane or --supersample");
}

void check_supersample(const Request& request) {
  if (request.view.supersample > 1 && request.gl.backend == Backend::gl)
    throw Error(ErrorKind::usage, "--supersample: the processor's alone; use --backend cpu");
}

void check_relief(const Request& request) {
  parse_direction("light", request.slant.light);
  parse_direction("view-direction", request.slant.view);
  if (request.relief.depth_px == 0) return;
  if (request.map || request.options.show != Show::color)
    throw Error(ErrorKind::usage, "--relief: the texture is lit; expected no --map and no --show beside it");
  if (request.view.view == View::plane) return;
  if (request.view.supersample > 1)
    throw Error(ErrorKind::usage, "--supersample: expected --view plane beside --relief, found a flat window");
}

/// Draws by strips of rows, so that a window of any size takes the same memory.
void stream(const std::string& path, const PictureFormat& format, const DrawRows& draw_rows, Console& console) {
  const Progress progress = console.step("render");
  PictureWriter writer(path, format);
  const int strip = std::max(1, kStripPixels / format.width);
  for (int row = 0; row < format.height; row += strip) {
    const int end = std::min(format.height, row + strip);
    writer.write_rows(draw_rows(row, end).view());
    report_progress(progress, static_cast<double>(end) / format.height);
  }
  writer.close();
  console.finish_step();
}

/// What draws a picture from the planes, whose levels are added where it needs them.
DrawRows flat_drawer(const Request& request, EvaluatorPlanes& planes, const Plane& plane, PixelSize size) {
  Window window = window_of(request.window, size, planes.size);
  window.deformation = deformation_of(request.deform);
  const int samples = request.view.supersample;
  if (samples > 1)
    return [&, window, samples](int begin, int end) {
      return supersampled_rows(planes, plane, window, samples, begin, end);
    };
  if (request.options.show == Show::color && needs_levels(window)) add_levels(planes, plane);
  if (request.gl.backend == Backend::gl) return gl_row_drawer(planes, plane, window, request.gl.gl_device);
  if (!request.map)
    return [&, window](int begin, int end) { return show_rows(planes, window, request.options.show, begin, end); };
  return [&, window](int begin, int end) { return render_map_rows(planes, plane, window, begin, end); };
}

DrawRows plane_drawer(const Request& request, EvaluatorPlanes& planes, const Plane& plane, PixelSize size) {
  const Perspective view = perspective_of(request.view, request.window, size, planes.size);
  const int samples = request.view.supersample;
  add_levels(planes, plane);
  if (request.gl.backend == Backend::gl) return gl_row_drawer(planes, plane, view, request.gl.gl_device);
  if (samples > 1)
    return [&, view, samples](int begin, int end) {
      return supersampled_perspective_rows(planes, plane, view, samples, begin, end);
    };
  return [&, view](int begin, int end) { return render_perspective_rows(planes, plane, view, begin, end); };
}

/// Whether all scales are drawn together; a map, or how the texture is put together, is that of the finest.
bool draws_stack(const Request& request, const Bundle& bundle) {
  const bool in_colour = !request.map && request.options.show == Show::color;
  return in_colour && (bundle.scales.size() > 1 || has_relief(request.relief));
}

void render_stack(const Request& request, const Bundle& bundle, const std::string& path, Console& console) {
  if (!deformation_of(request.deform).is_identity())
    throw Error(ErrorKind::usage,
                "--rotate, --stretch, --turbulence: a bundle of one scale is deformed, without --relief");
  const PixelSize size = parse_size("size", request.options.size);
  const DrawRows draw_rows =
      stack_drawer(bundle, {size, request.window, request.view, request.relief, request.slant, request.gl});
  stream(path, {.width = size.width, .height = size.height, .samples = request.options.bits}, draw_rows, console);
}

void render(const Request& request, const std::string& path, Console& console) {
  console.step("read");
  const Bundle bundle = read_bundle(request.bundle);
  if (draws_stack(request, bundle)) return render_stack(request, bundle, path, console);
  EvaluatorPlanes planes = prepare(evaluator_input(bundle));
  const Plane& plane = chosen_plane(planes, request.map);
  const PixelSize size = parse_size("size", request.options.size);
  const DrawRows draw_rows = request.view.view == View::plane ? plane_drawer(request, planes, plane, size)
                                                              : flat_drawer(request, planes, plane, size);
  const PictureFormat format{.width = size.width,
                             .height = size.height,
                             .channels = plane.channels,
                             .role = role_of(planes, plane),
                             .samples = request.options.bits};
  stream(path, format, draw_rows, console);
}

Outcome run(const Request& request, Console& console) {
  const std::string path = request.output.empty() ? default_picture_path(request.bundle, ".png") : request.output;
  check_options(request.options);
  check_options(request.window);
  check_options(request.deform);
  check_options(request.gl);
  check_options(request.view);
  check_view(request.view, request.window);
  check_supersample(request);
  check_deformation(request);
  check_options(request.relief);
  check_show(request);
  check_relief(request);
  check_picture_name(path, request.options.bits);
  parse_size("size", request.options.size);
  check_file_target(path);
  render(request, path, console);
  return {.text = path + "\n", .result = {{"output", path}}};
}

Action declare(Arguments& arguments) {
  const auto request = std::make_shared<Request>();
  add_bundle_path(arguments, request->bundle);
  arguments.option({.name = "output",
                    .letter = 'o',
                    .value = "FILE",
                    .names = Names::file,
                    .standard = "NAME.png here",
                    .help = "the picture: .png or .exr",
                    .assign = into(request->output)});
  add_flags(arguments, request->options, "Options");
  add_flags(arguments, request->window, "Options");
  add_flags(arguments, request->view, "View");
  add_flags(arguments, request->gl, "Options");
  add_flags(arguments, request->deform, "Deformation");
  add_flags(arguments, request->relief, "Relief");
  add_flags(arguments, request->slant, "Relief");
  arguments.option({.name = "map",
                    .value = "NAME",
                    .standard = "the colour",
                    .help = "draw this map of the material instead",
                    .repeat = Repeat::last,
                    .assign = into(request->map)});
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command render_command() {
  return {"render", "bundle → picture: a window of the infinite texture, or an endless plane",
          "  texbake render leaves.texbundle -o leaves.png --size 4096x4096\n"
          "  texbake render leaves.texbundle -o patches.png --show patches --origin -512,99999999999\n"
          "  texbake render rock.texbundle -o normal.png --map normal\n"
          "  texbake render moss.texbundle -o moss.png --rotate 30 --stretch 2,1 --turbulence 12\n"
          "  texbake render leaves.texbundle -o floor.png --size 1200x800 --view plane --camera-height 600 --pitch 15\n"
          "  texbake render rock.texbundle -o rock.png --relief 24 --view-direction 1,0,1 --light -1,-1,1\n"
          "  texbake render leaves.texbundle -o leaves.exr --bits float --backend gl",
          declare};
}

}  // namespace texbake
