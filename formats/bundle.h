// The bundle in memory: everything that `NAME.texbundle/` holds. The format is specified in formats/README.md.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "libbake/base/image.h"
#include "libbake/color/palette.h"
#include "libbake/content/content.h"
#include "libbake/noise/estimate_psd.h"
#include "libbake/planes/transfer.h"
#include "libbake/reference/semantics.h"
#include "libbake/segment/fragment.h"
#include "libbake/segment/patch.h"

namespace texbake {

using Json = nlohmann::ordered_json;

inline constexpr const char* kManifestName = "bundle.json";
inline constexpr const char* kBundleVersion = "1.0";

/// Another picture of the same surface, travelling with the color.
struct Map {
  std::string name;        ///< "normal", "roughness", ...: the NAME of --map NAME=FILE
  int channels = 1;        ///< 1 or 3
  int source_bits = 8;     ///< 8: stored HALF; above: stored FLOAT
  bool is_float = false;   ///< the source held floating point
  std::string convention;  ///< "opengl" (+Y up) or "directx" (+Y down) for normals, else ""
  Image<float> planes[3];  ///< `channels` of them, half-exact where stored HALF. Normals are decoded, in −1 … 1;
                           ///< other maps of integer sources are in 0 … 1
};

/// One tile with all that was found in it.
struct Scale {
  std::string name = "fine";            ///< stem of its EXR file
  Image<V3f> exemplar;                  ///< linear Rec.709, half-exact, ≥ 0
  bool stores_exemplar = true;          ///< false for --colour palette: exemplar is palette_exemplar(colors)
  std::optional<Image<V3f>> structure;  ///< the base where present
  std::vector<Image<float>> masks;      ///< K, where there is a structure: where each noise lives; see noise/masks.h
  std::optional<PrincipalVariation> colors;
  std::optional<FragmentMap> fragments;
  std::optional<PatchMap> patches;
  std::optional<ContentTable> contents;
  int soft_border_px = 0;              ///< over how many texels on either side of their borders patches blend; 0: hard
  std::optional<Image<float>> height;  ///< 0 … 1
  std::vector<Map> maps;
  std::optional<ScaleTransfer> transfer;  ///< from the scale before; of every scale but the coarsest
  std::optional<V2i> tile_from_source;    ///< offset of the tile in the source picture, when it is a crop

  int width() const { return exemplar.width(); }
  int height_px() const { return exemplar.height(); }
  V2i size() const { return {exemplar.width(), exemplar.height()}; }
  const Image<V3f>& base() const { return structure ? *structure : exemplar; }
};

inline constexpr const char* kColorRole = "color";    ///< of the picture
inline constexpr const char* kClicksRole = "clicks";  ///< of the heights that heightmap was given

/// A file that went into the bundle.
struct SourceFile {
  std::string role;  ///< "color", the name of a map, or kClicksRole
  std::string name;  ///< base name, no folder; bytes that need not be UTF-8
  std::string sha256;
  uint64_t size_bytes = 0;
  std::string scale = {};  ///< the scale that it went into; "" in a bundle of one scale
};

/// What one verb did.
struct Stage {
  std::string verb;
  int version = 1;
  Json parameters = {};    ///< every effective parameter, automatic values resolved; keys are long flags, in kebab-case
  Json figures = {};       ///< what was measured; never times; keys in camelCase
  std::string input = {};  ///< hash of what the stage read: formats/history.h
  std::string output = {};  ///< hash of what it wrote, as far as no later stage has replaced it
  std::string scale = {};   ///< the scale that it worked on; "" in a bundle of one scale, and for all scales
};

struct Bundle {
  std::vector<Scale> scales;        ///< coarse to fine
  std::optional<NoiseModel> noise;  ///< one for each mask of the finest scale; figures and warnings are not stored
  std::vector<SourceFile> sources;
  std::vector<Stage> stages;
  Json extensions = Json::object();
  Json extras = Json::object();
  Json unknown = Json::object();  ///< members of bundle.json that a newer minor version added; written back unchanged
  int semantics = kSemantics;  ///< another number only after reading with Semantics::any; such a bundle is not written
};

/// The exemplar of a bundle that stores only the paper's compact form: decode(index, variation), rounded to half.
Image<V3f> palette_exemplar(const PrincipalVariation& colors);

/// The mean of an image: each row summed in double from the left, the sums of the rows added from the top.
V3f mean_color(ImageView<const V3f> image);

}  // namespace texbake
