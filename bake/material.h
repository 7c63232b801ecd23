// The pictures that go into a bundle: the color and the maps that travel with it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bake/listener.h"
#include "formats/bundle.h"
#include "formats/image_reader.h"
#include "libbake/base/option_text.h"
#include "libbake/tile/periodic.h"

namespace texbake {

/// Which way green points in a normal map.
enum class NormalConvention {
  opengl,   ///< +y up in the picture
  directx,  ///< +y down
};
template <>
struct EnumNames<NormalConvention> {
  static constexpr std::pair<NormalConvention, std::string_view> values[] = {{NormalConvention::opengl, "opengl"},
                                                                             {NormalConvention::directx, "directx"}};
};

/// How the numbers of the files are meant.
struct ImportOptions {
  InputSpace input_space = InputSpace::automatic;
  NormalConvention normal_convention = NormalConvention::opengl;
  std::string layer = {};

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.input_space, Field{.name = "input-space",
                                  .help = "color space of the color picture; auto: what the file says, otherwise sRGB "
                                          "for integers and linear for floats"});
    visit(self.normal_convention,
          Field{.name = "normal-convention",
                .help = "convention of the map \"normal\": +y up (opengl) or +y down (directx)"});
    visit(self.layer, Field{.name = "layer",
                            .unit = "NAME",
                            .help = "layer (or single channel, or part) of the color picture's file that is read, for "
                                    "files that name theirs, as OpenEXR does"});
  }
};

/// One file, as given.
struct MaterialFile {
  std::string name;    ///< "color" or the NAME of --map NAME=FILE
  std::string file;    ///< its path
  std::string sha256;  ///< of the content that is expected; "": any
};

/// What is wrong with `name` as that of a map, in words that suggest a better one; "" for nothing. Of names that mean
/// relief or vectors to people, only kHeightMap and kNormalMap mean them here: others are taken for plain numbers.
std::string map_name_fault(const std::string& name);

/// The files, as given.
struct MaterialFiles {
  MaterialFile color{.name = "color", .file = "", .sha256 = ""};
  std::vector<MaterialFile> maps;
};

inline constexpr const char* kHeightMap = "height";  ///< the map that is relief: its own plane of the bundle
inline constexpr const char* kNormalMap = "normal";  ///< the map that holds vectors

/// The paths of all of them.
std::vector<std::string> files_of(const MaterialFiles& files);

/// The pictures, read.
struct Material {
  Picture color;
  std::vector<Picture> maps;  ///< in the order of `MaterialFiles::maps`
};

/// Reads the pictures; what a person should know about them becomes warnings. Throws Error as read_picture does,
/// Error(usage) when two maps have one name, and Error(bad_data) when a file is not the one that is expected.
Material read_material(const MaterialFiles& files, const ImportOptions& options, Listener& listener);

/// The tile of a map, as a bundle holds it: half-exact where the bundle stores halves.
Map map_tile(const TilePlan& plan, const std::string& name, const Picture& picture, NormalConvention convention);

/// The tile of a height map: one channel, 0 … 1. Throws Error(bad_data) when the picture has colors or other values.
Image<float> height_tile(const TilePlan& plan, const Picture& picture);

/// Is the first channel a slope of so few levels that they will be seen as steps: integers of at most 8 bits, most of
/// them equal to their left neighbors, and most of the others one code from it?
bool has_steps(const Picture& picture);

/// A file as the bundle's list of sources names it.
SourceFile source_of(const std::string& role, const Picture& picture);

}  // namespace texbake
