// Writes the golden bundles and, for each camera file beside them, the frame that the program draws.
// usage: regenerate_bundles FOLDER. Equal content gives equal bytes.
#include <cstdio>
#include <filesystem>
#include <string>

#include "cli/camera.h"
#include "formats/bundle_io.h"
#include "formats/drawn_bundle.h"
#include "formats/image_writer.h"
#include "libbake/draw/drawing.h"
#include "tests/golden/golden_bundles.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

/// NAME-VIEW.json is a view of NAME.texbundle.
void write_frame(const fs::path& camera_path) {
  const std::string stem = camera_path.stem().string();
  const Bundle bundle = read_bundle(camera_path.parent_path() / (stem.substr(0, stem.find('-')) + ".texbundle"));
  const Camera camera = read_camera(camera_path.string());
  const PixelSize size = camera.frame_size.value();
  const Drawing drawing(drawn_material(bundle), draw_request_of(camera.picture, size, bundle.scales.back().size()));
  PictureWriter writer((camera_path.parent_path() / (stem + ".exr")).string(),
                       {.width = size.width,
                        .height = size.height,
                        .channels = drawing.channels(),
                        .role = picture_role(bundle, drawing.request().map),
                        .samples = SampleType::float32});
  writer.write_rows(drawing.rows(0, size.height).view());
  writer.close();
}

void write_all(const fs::path& folder) {
  for (const auto& [name, bundle] : golden_bundles()) write_bundle(bundle, folder / (name + ".texbundle"));
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") write_frame(entry.path());
}

}  // namespace
}  // namespace texbake

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    texbake::write_all(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
