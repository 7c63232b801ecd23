#include "bake/material.h"

#include <algorithm>
#include <set>

#include "libbake/base/half.h"

namespace texbake {
namespace {

/// 8-bit sources are stored as halves (design: bundle, maps).
constexpr int kHalfSourceBits = 8;

void check_names(const std::vector<MaterialFile>& maps) {
  std::set<std::string> names;
  for (const MaterialFile& map : maps)
    if (!names.insert(map.name).second)
      throw Error(ErrorKind::usage, fmt::format("--map {}: given twice; every map needs its own name", map.name));
}

Picture read_noted(const MaterialFile& file, const ImportOptions& options, PictureRole role, Listener& listener) {
  PictureRequest request{.path = file.file, .space = InputSpace::linear, .role = role};
  if (role == PictureRole::color) {
    request.space = options.input_space;
    request.layer = options.layer;
  }
  Picture picture = read_picture(request);
  if (!file.sha256.empty() && picture.sha256 != file.sha256)
    throw Error(ErrorKind::bad_data, fmt::format("{}: expected the file with SHA-256 {}, found {}; remove \"sha256\" "
                                                 "from the recipe to bake another picture",
                                                 file.file, file.sha256, picture.sha256));
  for (const std::string& note : picture.notes) listener.warning(note);
  return picture;
}

/// The channels of `image`, one by one.
void split(ImageView<const V3f> image, Image<float> (&planes)[3]) {
  for (int channel = 0; channel < 3; ++channel) {
    planes[channel] = Image<float>(image.width(), image.height());
    std::transform(image.begin(), image.end(), planes[channel].begin(),
                   [channel](const V3f& texel) { return texel[channel]; });
  }
}

/// Cuts the planes of `picture` into `map`. Vectors stay of unit length.
void put_tile(const TilePlan& plan, const Picture& picture, Map& map) {
  if (map.convention.empty()) {
    for (int channel = 0; channel < map.channels; ++channel) map.planes[channel] = apply(plan, picture.planes[channel]);
    return;
  }
  const Image<V3f> tile = apply_to_normals(plan, interleave(picture.planes));
  split(tile, map.planes);
}

}  // namespace

Material read_material(const MaterialFiles& files, const ImportOptions& options, Listener& listener) {
  check_names(files.maps);
  listener.step("read");
  Material material;
  material.color = read_noted(files.color, options, PictureRole::color, listener);
  for (const MaterialFile& map : files.maps) {
    const PictureRole role = map.name == kNormalMap ? PictureRole::normal : PictureRole::data;
    material.maps.push_back(read_noted(map, options, role, listener));
  }
  listener.finish_step();
  return material;
}

Map map_tile(const TilePlan& plan, const std::string& name, const Picture& picture, NormalConvention convention) {
  Map map;
  map.name = name;
  map.channels = picture.channels;
  map.source_bits = picture.source_bits;
  map.is_float = picture.is_float;
  if (name == kNormalMap) map.convention = enum_name(convention);
  put_tile(plan, picture, map);
  if (map.source_bits > kHalfSourceBits) return map;
  for (Image<float>& plane : map.planes)
    for (float& value : plane) value = half_exact(value);
  return map;
}

Image<float> height_tile(const TilePlan& plan, const Picture& picture) {
  if (picture.channels != 1)
    throw Error(ErrorKind::bad_data, fmt::format("{}: expected a gray height map, found colors", picture.name));
  const auto [least, most] = std::minmax_element(picture.planes[0].begin(), picture.planes[0].end());
  if (*least < 0 || *most > 1)
    throw Error(ErrorKind::bad_data, fmt::format("{}: expected heights from 0 to 1, found {} to {}; rescale them first",
                                                 picture.name, *least, *most));
  return apply(plan, picture.planes[0]);
}

SourceFile source_of(const std::string& role, const Picture& picture) {
  return {role, picture.name, picture.sha256, picture.size_bytes};
}

}  // namespace texbake
