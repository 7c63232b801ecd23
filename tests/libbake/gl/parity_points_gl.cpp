// Writes the points of parity_points.h, drawn by the reference shader, to files: GL 3.3 core, then ES 3.0.
// Exit: 0 done, 4 not written, 77 no OpenGL.
#include <algorithm>
#include <cstdio>

#include "libbake/base/error.h"
#include "libbake/gl/gl_renderer.h"
#include "tests/libbake/gl/parity_points.h"

namespace texbake {
namespace {

template <class T>
Image<T> image_of(const std::vector<T>& texels, int width) {
  Image<T> image(width, static_cast<int>(texels.size()) / width, texels.front());
  std::copy(texels.begin(), texels.end(), image.begin());
  return image;
}

EvaluatorPlanes planes_of(const parity::Tile& tile) {
  EvaluatorPlanes planes;
  planes.size = {parity::kWidth, parity::kHeight};
  planes.patch_count = parity::kPatches;
  planes.content_count = parity::kContents;
  planes.patch_plane = image_of(tile.patch_plane, parity::kWidth);
  planes.contents = image_of(tile.contents, parity::kContents);
  planes.centers = image_of(tile.centers, parity::kPatches);
  constexpr MapKind kKinds[] = {MapKind::plain, MapKind::normal_opengl, MapKind::normal_directx, MapKind::height};
  for (const MapKind kind : kKinds) planes.maps.push_back({"", kind, 4, image_of(tile.base, parity::kWidth)});
  return planes;
}

Window window_of(const parity::Patchwork& w) {
  Window window;
  window.origin_x = {w.origin.tile.x, static_cast<uint32_t>(w.origin.offset.x)};
  window.origin_y = {w.origin.tile.y, static_cast<uint32_t>(w.origin.offset.y)};
  window.step_256 = w.step_256;
  window.width = window.height = parity::kSide;
  window.seed = w.seed;
  window.filter = w.bilinear ? Filter::bilinear : Filter::nearest;
  return window;
}

std::vector<parity::Pixel> drawn(ShaderLanguage language) {
  const GlContext context({language, std::nullopt});
  std::printf("%s\n", context.description().c_str());
  const EvaluatorPlanes planes = planes_of(parity::made_up_tile());
  GlRenderer renderer(context, planes);
  std::vector<parity::Pixel> pixels;
  for (const parity::Patchwork& w : parity::windows()) {
    const Frame frame = renderer.draw(window_of(w), planes.maps[static_cast<size_t>(w.plane_kind)]);
    for (size_t i = 0; i < frame.values.size(); ++i) {
      const PixelDecision& d = frame.decisions.data()[i];
      pixels.push_back({frame.values.data()[i], {d.patch_idx, d.content, d.source_x, d.source_y}});
    }
  }
  return pixels;
}

bool write(const char* path, const std::vector<parity::Pixel>& pixels) {
  std::FILE* const file = std::fopen(path, "wb");
  if (!file) return false;
  const size_t written = std::fwrite(pixels.data(), sizeof(parity::Pixel), pixels.size(), file);
  return std::fclose(file) == 0 && written == pixels.size();
}

}  // namespace
}  // namespace texbake

int main(int argc, char** argv) {
  using texbake::ShaderLanguage;
  if (argc != 3) return 4;
  try {
    const bool both = texbake::write(argv[1], texbake::drawn(ShaderLanguage::glsl_330)) &&
                      texbake::write(argv[2], texbake::drawn(ShaderLanguage::glsl_300_es));
    return both ? 0 : 4;
  } catch (const texbake::Error& error) {
    std::printf("%s\n", error.what());
    return 77;
  }
}
