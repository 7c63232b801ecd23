#include "pages/plane_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "formats/bundle.h"
#include "formats/exr_planes.h"
#include "formats/json_text.h"
#include "formats/safe_file.h"
#include "libbake/base/half.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/prepare_stack.h"
#include "libbake/planes/program_of.h"
#include "libbake/planes/relief_planes.h"
#include "libbake/reference/perspective_program.h"
#include "libbake/reference/semantics.h"
#include "pages/export_folder.h"
#include "pages/web_export.h"
#include "shaders/shader_texts.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPlanesBegin = R"({"kind":"texbake.planes",)";  ///< how planes.json begins
constexpr std::string_view kExr = ".exr";

const std::vector<std::string>& channel_names() {
  static const std::vector<std::string> names{"R", "G", "B", "A"};
  return names;
}

/// The numbers of a texel, each as the 32 bits that OpenEXR stores: integers are widened, with their sign.
template <class Number>
uint32_t bits_of(Number number) {
  if constexpr (std::is_same_v<Number, float>)
    return std::bit_cast<uint32_t>(number);
  else
    return static_cast<uint32_t>(number);
}
template <class T>
struct Numbers;
template <>
struct Numbers<glsl::PatchTexel> {
  using Type = uint16_t;
};
template <>
struct Numbers<glsl::MaskTexel> {
  using Type = uint16_t;
};
template <>
struct Numbers<glsl::LevelBlock> {
  using Type = uint32_t;
};
template <>
struct Numbers<glsl::FragmentTexel> {
  using Type = int16_t;
};
template <>
struct Numbers<glsl::ivec4> {
  using Type = int32_t;
};
template <>
struct Numbers<glsl::vec4> {
  using Type = float;
};

/// Whether a texture that may be stored in halves loses nothing by that.
bool fits_half(const Image<glsl::vec4>& image) {
  const auto is_half = [](float value) { return half_exact(value) == value; };
  return std::ranges::all_of(
      image, [&](const glsl::vec4& v) { return is_half(v.x) && is_half(v.y) && is_half(v.z) && is_half(v.w); });
}

/// Fills the bytes of a row, channel by channel.
template <class T>
void fill_row(const T* texels, int width, PixelType type, std::byte* row) {
  using Number = typename Numbers<T>::Type;
  constexpr size_t kChannels = sizeof(T) / sizeof(Number);
  for (size_t c = 0; c < kChannels; ++c)
    for (int x = 0; x < width; ++x) {
      Number number;
      std::memcpy(&number, reinterpret_cast<const std::byte*>(texels + x) + c * sizeof(Number), sizeof number);
      if (type == PixelType::half) {
        const uint16_t half = Imath::half(static_cast<float>(number)).bits();
        std::memcpy(row, &half, sizeof half);
      } else {
        const uint32_t bits = bits_of(number);
        std::memcpy(row, &bits, sizeof bits);
      }
      row += bytes_of(type);
    }
}

Json uniform_json(float value) { return json_number(value); }
Json uniform_json(int value) { return value; }
Json uniform_json(glsl::uint value) { return value; }
Json uniform_json(const glsl::ivec2& v) { return {v.x, v.y}; }
Json uniform_json(const glsl::uvec2& v) { return {v.x, v.y}; }
Json uniform_json(const glsl::ivec4& v) { return {v.x, v.y, v.z, v.w}; }
Json uniform_json(const glsl::uvec4& v) { return {v.x, v.y, v.z, v.w}; }
Json uniform_json(const glsl::vec3& v) { return {json_number(v.x), json_number(v.y), json_number(v.z)}; }
Json uniform_json(const glsl::vec4& v) {
  return {json_number(v.x), json_number(v.y), json_number(v.z), json_number(v.w)};
}
template <class T, size_t N>
Json uniform_json(const T (&values)[N]) {
  Json json = Json::array();
  for (const T& value : values) json.push_back(uniform_json(value));
  return json;
}

/// The names of the uniforms that some fragment shaders declare.
std::set<std::string> declared_in(const std::vector<std::string>& shaders) {
  constexpr std::string_view kUniform = "\nuniform ";
  std::set<std::string> names;
  for (const std::string& text : shaders)
    for (size_t at = text.find(kUniform); at != std::string::npos; at = text.find(kUniform, at + 1)) {
      const size_t end = text.find_first_of(";[", at);
      const size_t begin = text.rfind(' ', end) + 1;
      names.insert(text.substr(begin, end - begin));
    }
  return names;
}

/// The programs of one scale, and those of several.
struct Programs {
  Json names;
  std::set<std::string> uniforms;
};
Programs tile_programs() {
  const auto language = ShaderLanguage::glsl_330;
  return {{"window", "plane"},
          declared_in({reference_fragment_shader(language), perspective_fragment_shader(language)})};
}
Programs stack_programs() {
  const auto language = ShaderLanguage::glsl_330;
  return {{"stack", "stack plane"},
          declared_in({stack_fragment_shader(language), stack_perspective_fragment_shader(language)})};
}

/// The folder while it is filled.
class PlaneFolder {
 public:
  explicit PlaneFolder(const fs::path& folder) : folder_(folder) {}

  /// What `for_each` lists and `program` has, for `programs`. Images that are bound once more are not written again.
  template <class ForEachTexture>
  void add(const std::string& name, const Json& map, const Programs& programs, const glsl::Program& bound, int kind,
           const ForEachTexture& for_each) {
    Json binding = {{"name", name}, {"programs", programs.names}, {"map", map}};
    for_each([&]<class T>(const Texture& texture, const Image<T>& image, auto) {
      binding["textures"][texture.name] = texture_json(name, texture, image);
    });
    const auto add_uniform = [&](const char* uniform, const auto& value) {
      if (programs.uniforms.contains(uniform)) binding["uniforms"][uniform] = uniform_json(value);
    };
    glsl::PerspectiveProgram program;
    static_cast<glsl::Program&>(program) = bound;
    glsl::MainUniforms main;
    main.plane_kind = kind;
    for_each_uniform(program, add_uniform);
    glsl::MainUniforms::fields(main, add_uniform);
    bindings_.push_back(std::move(binding));
  }

  /// Writes planes.json, and removes what only an earlier export had. Images must live until then.
  void finish() {
    const Json json = {
        {"kind", "texbake.planes"}, {"version", "1.0"}, {"semantics", kSemantics}, {"bindings", bindings_}};
    SafeFile file(folder_ / kPlanesFile);
    file.write(compact_json(json) + "\n");
    file.commit();
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error))
      if (entry.path().extension() == kExr && !names_.contains(entry.path().filename().string()))
        fs::remove(entry.path(), error);
  }

 private:
  template <class T>
  Json texture_json(const std::string& binding, const Texture& texture, const Image<T>& image) {
    if (const auto known = written_.find(&image); known != written_.end()) return known->second;
    if (image.empty()) return written_[&image] = write(binding, texture, Image<T>(1, 1, zeros<T>()));
    return written_[&image] = write(binding, texture, image);
  }

  /// One texel of zeros stands for what is empty.
  template <class T>
  static T zeros() {
    T texel;
    std::memset(static_cast<void*>(&texel), 0, sizeof texel);
    return texel;
  }

  template <class T>
  Json write(const std::string& binding, const Texture& texture, const Image<T>& image) {
    std::string format = kTexelFormat<T>.name;
    PixelType type = PixelType::uint;
    if constexpr (std::is_same_v<T, glsl::vec4>) {
      const bool halves = texture.precision != Precision::exact && fits_half(image);
      type = halves ? PixelType::half : PixelType::float32;
      if (halves) format = "RGBA16F";
    }
    const size_t channels = sizeof(T) / sizeof(typename Numbers<T>::Type);
    const auto& all = channel_names();
    const PlaneShape shape{texture.name,
                           {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(channels)},
                           type,
                           image.width(),
                           image.height()};
    const std::string name = fmt::format("{}.{}{}", binding, texture.name, kExr);
    SafeFile file(folder_ / name);
    write_exr(file, {image.width(), image.height()},
              {{shape, [&](int y, std::byte* row) { fill_row(image.row(y), image.width(), type, row); }}});
    file.commit();
    names_.insert(name);
    return {{"file", name}, {"format", format}, {"width", image.width()}, {"height", image.height()}};
  }

  fs::path folder_;
  Json bindings_ = Json::array();
  std::map<const void*, Json> written_;  ///< by their images
  std::set<std::string> names_;
};

void add_tile(PlaneFolder& folder, const Programs& programs, const EvaluatorPlanes& planes) {
  const auto add = [&](const std::string& name, const Json& map, const Plane& drawn) {
    folder.add(name, map, programs, program_of(planes, 0), plane_kind(drawn.kind),
               [&](const auto& visit) { for_each_texture(planes, drawn, visit); });
  };
  add("color", nullptr, planes.base);
  for (size_t i = 0; i < planes.maps.size(); ++i) add(fmt::format("map{}", i), planes.maps[i].name, planes.maps[i]);
}

/// Deformed windows read other levels, where there is noise.
void add_deformed(PlaneFolder& folder, const Programs& programs, const EvaluatorPlanes& planes) {
  folder.add("deformed", nullptr, programs, program_of(planes, 0), plane_kind(planes.base.kind),
             [&](const auto& visit) { for_each_texture(planes, planes.base, visit); });
}

void add_stack(PlaneFolder& folder, const Programs& programs, const StackPlanes& planes, const ReliefPlanes& relief) {
  glsl::Program bound = program_of(planes, 0, {0, 0});
  bind_relief(bound, relief);
  folder.add("stack", nullptr, programs, bound, glsl::kPlanePlain, [&](const auto& visit) {
    for_each_texture(planes, visit);
    for_each_texture(relief, visit);
  });
}

void fill(const DrawnMaterial& material, const ReliefOptions& relief, const fs::path& path) {
  PlaneFolder folder(path);
  const Programs tile = tile_programs();
  const EvaluatorPlanes planes = prepare(material.finest);
  add_tile(folder, tile, planes);
  EvaluatorPlanes deformed;
  if (material.finest.noise) {
    EvaluatorInput input = material.finest;
    input.maps.clear();
    input.grain_apart = true;
    deformed = prepare(input);
    add_deformed(folder, tile, deformed);
  }
  StackPlanes stack;
  ReliefPlanes heights;
  if (material.scales.size() > 1 || relief.depth_px > 0) {
    stack = prepare_stack(material.scales);
    if (relief.depth_px > 0) heights = relief_planes(material.scales.front().input, relief, kDefaultLight);
    add_stack(folder, stack_programs(), stack, heights);
  }
  folder.finish();
}

}  // namespace

void export_planes(const DrawnMaterial& material, std::optional<float> relief_px, const fs::path& folder) {
  ReliefOptions relief;
  relief.depth_px = relief_px.value_or(default_relief_px(material.scales.front().input));
  const auto may_own = [](std::string_view name) { return name == kPlanesFile || name.ends_with(kExr); };
  write_export(folder, {kPlanesFile, kPlanesBegin, may_own},
               [&](const fs::path& path) { fill(material, relief, path); });
}

}  // namespace texbake
