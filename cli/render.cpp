// texbake render: bundle → picture of the infinite texture, a window of it or an endless plane in perspective.
#include <algorithm>
#include <memory>

#include "cli/bundle_path.h"
#include "cli/command.h"
#include "cli/gl_backend.h"
#include "cli/kept_files.h"
#include "cli/option_flags.h"
#include "cli/relief_options.h"
#include "cli/view_options.h"
#include "formats/bundle_io.h"
#include "formats/drawn_bundle.h"
#include "formats/image_writer.h"

namespace texbake {
namespace {

struct RenderOptions {
  std::string size = "1024x1024";
  Show show = Show::color;
  std::optional<SampleType> bits;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.size, Field{.name = "size",
                           .unit = "WIDTHxHEIGHT",
                           .help = "size of the picture in pixels; one number makes a square"});
    visit(self.show, Field{.name = "show", .help = "what to draw: the texture, or how it is put together"});
    visit(self.bits, Field{.name = "bits",
                           .help = "bits of one sample: 8 or 16 in PNG (sRGB), half or float in EXR (linear)",
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
                             .help = "rotate the structure clockwise about the origin; the grain keeps its direction"});
    visit(self.stretch, Field{.name = "stretch",
                              .unit = "FACTOR or X,Y",
                              .help = "enlarge the structure by this factor, 0.5 to 64; the grain keeps its size"});
    visit(self.turbulence, Field{.name = "turbulence",
                                 .unit = "texels",
                                 .min = 0,
                                 .max = 64,
                                 .help = "distort the structure by displacements of about this size"});
    visit(self.turbulence_cell, Field{.name = "turbulence-cell",
                                      .unit = "texels",
                                      .min = 64,
                                      .max = 1024,
                                      .help = "size of the largest eddies of --turbulence, a power of two"});
  }
};

struct RenderFlags {
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

/// What the options ask for, of a bundle whose finest scale has this size.
DrawRequest draw_request_of(const RenderFlags& request, V2i tile_size) {
  const PixelSize size = parse_size("size", request.options.size);
  DrawRequest picture;
  if (request.view.view == View::plane) {
    picture.view = perspective_of(request.view, request.window, size, tile_size);
  } else {
    Window window = window_of(request.window, size, tile_size);
    window.deformation = deformation_of(request.deform);
    picture.view = window;
  }
  picture.map = request.map.value_or("");
  picture.show = request.options.show;
  picture.samples = request.view.supersample;
  picture.relief = relief_of(request.relief, request.slant);
  return picture;
}

/// Everything that can be said without the bundle. A deformation of a plane is no part of a DrawRequest.
void check(const RenderFlags& request, const std::string& path) {
  check_options(request.options);
  check_options(request.window);
  check_options(request.deform);
  check_options(request.gl);
  check_options(request.view);
  check_options(request.relief);
  check_view(request.view, request.window);
  constexpr int kAnySide = 1 << 14;  // of a tile
  const DrawRequest picture = draw_request_of(request, {kAnySide, kAnySide});
  Features features = picture.features();
  features.add(Feature::deformation, !deformation_of(request.deform).is_identity());
  check_features(features);
  check_backend(picture, request.gl.backend);
  check_picture_name(path, request.options.bits);
  check_picture_size(path, picture.width(), picture.height());
  check_file_target(path);
}

/// A word before a picture that takes hours, and a disk, is begun.
void tell_of_size(const PictureFormat& format, Console& console) {
  constexpr double kMany = 1 << 28, kMillion = 1e6;
  const double pixels = static_cast<double>(format.width) * format.height;
  if (pixels > kMany)
    console.warning(
        fmt::format("--size: {} x {} are {:.0f} million pixels, which take long to draw and much of the disk; "
                    "Ctrl-C ends the rendering and leaves nothing behind",
                    format.width, format.height, pixels / kMillion));
}

Outcome run(const RenderFlags& request, Console& console) {
  const std::string path = request.output.empty() ? default_picture_path(request.bundle) : request.output;
  check(request, path);
  console.step("read");
  const Bundle bundle = read_bundle(request.bundle);
  check_keeps_sources(path, bundle);
  const Drawing drawing(drawn_material(bundle), draw_request_of(request, bundle.scales.back().size()));
  const PictureFormat format{.width = drawing.request().width(),
                             .height = drawing.request().height(),
                             .channels = drawing.channels(),
                             .role = picture_role(bundle, drawing.request().map),
                             .samples = request.options.bits};
  tell_of_size(format, console);
  stream(path, format, row_drawer(drawing, request.gl), console);
  return {.text = path + "\n", .result = {{"output", path}}};
}

Action declare_render(Arguments& arguments) {
  const auto request = std::make_shared<RenderFlags>();
  add_bundle_path(arguments, request->bundle);
  arguments.option({.name = "output",
                    .letter = 'o',
                    .value = "FILE",
                    .names = Names::file,
                    .standard = "NAME_render.png here",
                    .help = "the picture to write: .png, .exr, .tif or .jpg",
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
                    .standard = "the color",
                    .help = "the map of the material to draw instead of the color",
                    .repeat = Repeat::last,
                    .assign = into(request->map)});
  return [request](Console& console) { return run(*request, console); };
}

}  // namespace

Command render_command() {
  return {"render", "bundle → picture: draw a window of the infinite texture, or an endless plane in perspective",
          "  texbake render leaves.texbundle -o leaves_large.png --size 4096x4096\n"
          "  texbake render leaves.texbundle -o patches.png --show patches --origin -512,99999999999\n"
          "  texbake render rock.texbundle -o rock_normals.png --map normal\n"
          "  texbake render moss.texbundle -o moss_turned.png --rotate 30 --stretch 2,1 --turbulence 12\n"
          "  texbake render leaves.texbundle -o floor.png --size 1200x800 --view plane --camera-height 600 --pitch 15\n"
          "  texbake render rock.texbundle -o rock_lit.png --relief 24 --view-direction 1,0,1 --light -1,-1,1\n"
          "  texbake render leaves.texbundle -o leaves.exr --bits float --backend gl",
          declare_render, "These options, and bundles, do not go together; all others do.\n" + not_together()};
}

}  // namespace texbake
