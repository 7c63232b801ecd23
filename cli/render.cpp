// texbake render: bundle → picture of the infinite texture, a window of it or an endless plane in perspective.
#include <algorithm>
#include <memory>

#include "cli/bundle_path.h"
#include "cli/command.h"
#include "cli/gl_backend.h"
#include "cli/kept_files.h"
#include "cli/option_flags.h"
#include "cli/picture_options.h"
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

struct RenderFlags {
  std::string bundle;
  std::string output;
  RenderOptions options;
  PictureOptions picture;
  GlOptions gl;
};

/// Rows that are drawn at a time: about this many pixels are held, whatever the size of the picture.
constexpr int kStripPixels = 1 << 20;

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
  DrawRequest picture = draw_request_of(request.picture, parse_size("size", request.options.size), tile_size);
  picture.show = request.options.show;
  return picture;
}

/// Everything that can be said without the bundle.
void check(const RenderFlags& request, const std::string& path) {
  check_options(request.options);
  check_options(request.gl);
  check_picture(request.picture, parse_size("size", request.options.size));
  constexpr int kAnySide = 1 << 14;  // of a tile
  const DrawRequest picture = draw_request_of(request, {kAnySide, kAnySide});
  check_features(picture.features());
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
  add_flags(arguments, request->picture.window, "Options");
  add_flags(arguments, request->picture.view, "View");
  add_flags(arguments, request->gl, "Options");
  add_flags(arguments, request->picture.deform, "Deformation");
  add_flags(arguments, request->picture.relief, "Relief");
  add_flags(arguments, request->picture.slant, "Relief");
  arguments.option({.name = "map",
                    .value = "NAME",
                    .standard = "the color",
                    .help = "the map of the material to draw instead of the color",
                    .repeat = Repeat::last,
                    .assign = into(request->picture.map)});
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
          declare_render, fmt::format("These do not go together; everything else does.\n{}", not_together())};
}

}  // namespace texbake
