// Draws a window of a bundle from C++: embed BUNDLE PICTURE.exr [MAP]. The picture is that of
// `texbake render BUNDLE -o PICTURE.exr --bits float --size 320x200 --origin -1000,250 [--map MAP]`, to the bit.
#include "formats/bundle_io.h"
#include "formats/drawn_bundle.h"
#include "formats/image_writer.h"
#include "libbake/draw/drawing.h"

int main(int argc, char** argv) try {
  if (argc < 3) throw std::runtime_error("expected BUNDLE PICTURE.exr [MAP]");
  const std::string map = argc > 3 ? argv[3] : "";
  const texbake::Bundle bundle = texbake::read_bundle(argv[1]);
  const texbake::V2i tile = bundle.scales.back().size();

  texbake::Window window{.width = 320, .height = 200, .filter = texbake::Filter::trilinear};
  window.origin_x = texbake::tile_offset(-1000, 0, tile.x);
  window.origin_y = texbake::tile_offset(250, 0, tile.y);
  const texbake::Drawing drawing(texbake::drawn_material(bundle), {.view = window, .map = map});

  texbake::PictureWriter writer(argv[2], {.width = window.width,
                                          .height = window.height,
                                          .channels = drawing.channels(),
                                          .role = texbake::picture_role(bundle, map),
                                          .samples = texbake::SampleType::float32});
  writer.write_rows(drawing.rows(0, window.height).view());
  writer.close();
} catch (const std::exception& error) {
  std::fprintf(stderr, "embed: %s\n", error.what());
  return 1;
}
