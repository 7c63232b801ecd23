// Draws the exemplars of the examples and tests: whole materials that no camera took, the same bytes on every machine.
//
//   draw_exemplars FOLDER [SIDE]
//
// writes pebbles.png, pebbles_normal.png, pebbles_height.png, pebbles_roughness.png, the same for bricks,
// lichen.png and leaves.png, SIDE texels wide (1024).
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <string>

#include "examples/draw/surface.h"
#include "formats/image_writer.h"

namespace texbake {
namespace {

/// Drawn at twice the size and averaged, so that outlines are smooth.
constexpr int kOversampling = 2;

void write_color(const std::string& path, const Surface& surface) {
  write_picture(path, halved(lit(surface)), PictureRole::color);
}

void write_material(const std::string& stem, const Surface& surface) {
  write_color(stem + ".png", surface);
  write_picture(stem + "_normal.png", halved(normals(surface)), PictureRole::normal);
  write_picture(stem + "_height.png", halved(surface.height), PictureRole::data, SampleType::uint16);
  write_picture(stem + "_roughness.png", halved(surface.roughness), PictureRole::data);
}

int draw(const std::string& folder, int side) {
  write_material(folder + "/pebbles", draw_pebbles(kOversampling * side, 1));
  write_material(folder + "/bricks", draw_bricks(kOversampling * side, 2));
  write_color(folder + "/lichen.png", draw_lichen(kOversampling * side, 4));
  write_color(folder + "/leaves.png", draw_leaves(kOversampling * side, 3));
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace texbake

int main(int argc, char** argv) {
  const int side = argc > 2 ? std::atoi(argv[2]) : 1024;
  if (argc < 2 || argc > 3 || side < 16 || side > 4096) {
    fmt::print(stderr, "usage: draw_exemplars FOLDER [SIDE, 16 to 4096 texels]\n");
    return 2;
  }
  try {
    return texbake::draw(argv[1], side);
  } catch (const std::exception& error) {
    fmt::print(stderr, "draw_exemplars: {}\n", error.what());
    return EXIT_FAILURE;
  }
}
