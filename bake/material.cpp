#include "bake/material.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "libbake/base/half.h"
#include "libbake/base/suggestion.h"

namespace texbake {
namespace {

/// 8-bit sources are stored as halves (design: bundle, maps).
constexpr int kHalfSourceBits = 8;

constexpr const char* kOpacityMap = "opacity";

/// `name` in lower-case letters alone.
std::string letters_of(const std::string& name) {
  std::string letters;
  for (const char c : name)
    if (std::isalpha(static_cast<unsigned char>(c)))
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

/// The maps that are not plain numbers, and what else they are called, as letters_of gives it.
struct KnownMap {
  const char* name;
  std::vector<std::string> others;
};
const std::vector<KnownMap>& known_maps() {
  static const std::vector<KnownMap> maps = {
      {kNormalMap, {"normal", "normals", "normalmap", "normalgl", "normaldx", "norm", "nor", "nrm", "nrml", "nmap"}},
      {kHeightMap,
       {"height", "heights", "heightmap", "bump", "bumpmap", "displacement", "displace", "disp", "depth", "relief"}}};
  return maps;
}

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

/// Where the reader has said that alpha was dropped, and no map holds it.
void tell_how_to_keep_alpha(const MaterialFiles& files, const Picture& color, Listener& listener) {
  const bool was_told = std::ranges::any_of(
      color.notes, [](const std::string& note) { return note.find("alpha was dropped") != std::string::npos; });
  if (was_told && std::ranges::find(files.maps, kOpacityMap, &MaterialFile::name) == files.maps.end())
    listener.warning(fmt::format("{}: to keep its alpha, save it as a gray picture of its own and add --map {}=FILE",
                                 files.color.file, kOpacityMap));
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

std::string map_name_fault(const std::string& name) {
  if (name == kColorRole || name == kClicksRole)
    return fmt::format("expected another name: \"{}\" is that of another source of the bundle", name);
  for (const KnownMap& map : known_maps()) {
    if (name == map.name) return "";
    const std::string letters = letters_of(name);
    const bool is_alias = std::ranges::find(map.others, letters) != map.others.end();
    // Nobody mistypes the first letter, but "weight" is a word.
    const bool is_mistyped = letters.starts_with(map.name[0]) && edit_distance(letters, map.name) == 1;
    if (is_alias || is_mistyped)
      return fmt::format(
          "would be taken for plain numbers; did you mean \"{0}\"? If not, give it a name such as \"{1}-data\"",
          map.name, name);
  }
  return "";
}

std::vector<std::string> files_of(const MaterialFiles& files) {
  std::vector<std::string> paths = {files.color.file};
  for (const MaterialFile& map : files.maps) paths.push_back(map.file);
  return paths;
}

Material read_material(const MaterialFiles& files, const ImportOptions& options, Listener& listener) {
  check_names(files.maps);
  listener.step("read");
  Material material;
  material.color = read_noted(files.color, options, PictureRole::color, listener);
  tell_how_to_keep_alpha(files, material.color, listener);
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

bool has_steps(const Picture& picture) {
  constexpr double kFewest = 0.5;  // of the neighbors
  if (picture.is_float || picture.source_bits > kHalfSourceBits) return false;
  const float code = 1.0f / static_cast<float>((1 << picture.source_bits) - 1);
  const Image<float>& plane = picture.planes[0];
  size_t level = 0, single = 0, steep = 0;
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 1; x < plane.width(); ++x) {
      const float step = std::abs(plane(x, y) - plane(x - 1, y));
      ++(step < code / 2 ? level : step < 3 * code / 2 ? single : steep);
    }
  return static_cast<double>(level) > kFewest * static_cast<double>(level + single + steep) && single > steep;
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
