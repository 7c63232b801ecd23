#include "pages/web_export.h"

#include <Imath/half.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>

#include "formats/base64.h"
#include "formats/bundle.h"
#include "formats/safe_file.h"
#include "libbake/base/error.h"
#include "libbake/base/half.h"
#include "libbake/planes/prepare.h"
#include "libbake/planes/prepare_stack.h"
#include "libbake/reference/semantics.h"
#include "pages/export_folder.h"
#include "pages/viewer_shaders.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

constexpr std::pair<std::string_view, std::string_view> kViewerFiles[] = {
#include "pages/embedded_viewer.inc"
};

constexpr std::string_view kTextureScript = "texbake.open(";  ///< how texture.js begins

constexpr float kMaxHalf = 65504;

static_assert(std::endian::native == std::endian::little, "planes are written as they lie in memory");

template <class T>
Json plane_json(const char* format, ImageView<const T> texels) {
  return {{"format", format},
          {"width", texels.width()},
          {"height", texels.height()},
          {"data", base64(texels.data(), texels.size() * sizeof(T))}};
}

bool is_half(float value) { return half_exact(value) == value; }
bool may_be_half(float value) { return std::abs(value) <= kMaxHalf; }

/// As halves, where the precision allows that of every value.
Json values_json(const Image<glsl::vec4>& texels, Precision precision) {
  const auto* values = reinterpret_cast<const float*>(texels.data());
  const size_t count = 4 * texels.size();
  if (precision == Precision::exact ||
      !std::all_of(values, values + count, precision == Precision::half ? may_be_half : is_half))
    return plane_json<glsl::vec4>(kTexelFormat<glsl::vec4>.name, texels);
  struct HalfTexel {
    uint16_t channels[4];
  };
  Image<HalfTexel> halves(texels.width(), texels.height());
  for (size_t i = 0; i < count; ++i) halves.data()[i / 4].channels[i % 4] = Imath::half(values[i]).bits();
  return plane_json<HalfTexel>("RGBA16F", halves);
}

/// What for_each_texture calls to add each texture to `json`.
auto texture_adder(Json& json) {
  return [&json]<class T>(const Texture& texture, const Image<T>& image, auto) {
    if constexpr (std::is_same_v<T, glsl::vec4>)
      json[texture.name] = values_json(image, texture.precision);
    else
      json[texture.name] = plane_json<T>(kTexelFormat<T>.name, image);
  };
}

Json json_of(float value) { return value; }
Json json_of(int value) { return value; }
Json json_of(const glsl::ivec2& v) { return {v.x, v.y}; }
Json json_of(const glsl::vec4& v) { return {v.x, v.y, v.z, v.w}; }

/// What fields() of a group of uniforms calls to add each to `json`, by its name after `prefix`.
auto uniform_adder(Json& json, std::string_view prefix = "") {
  return [&json, prefix](std::string_view name, const auto& value) {
    json[std::string(name.substr(prefix.size()))] = json_of(value);
  };
}

std::string shaders_script() {
  const auto language = ShaderLanguage::glsl_300_es;
  const Json shaders = {{"semantics", kSemantics},
                        {"vertex", reference_vertex_shader(language)},
                        {"reference", reference_fragment_shader(language)},
                        {"viewer", viewer_fragment_shader(language)},
                        {"stack_reference", stack_fragment_shader(language)},
                        {"stack_viewer", stack_viewer_fragment_shader(language)}};
  return "texbake.shaders = " + shaders.dump() + ";\n";
}

void write_files(const std::string& texture_script, const fs::path& folder) {
  const auto write = [&](std::string_view name, std::string_view text) {
    SafeFile file(folder / name);
    file.write(text);
    file.commit();
  };
  write("texture.js", texture_script);
  write("shaders.js", shaders_script());
  for (const auto& [name, text] : kViewerFiles) write(name, text);
}

/// Its texture.js, which is written first, tells.
void write_folder(const std::string& texture_script, const fs::path& target) {
  const auto may_own = [](std::string_view name) { return std::ranges::find(kWebFiles, name) != std::end(kWebFiles); };
  write_export(target, {"texture.js", kTextureScript, may_own},
               [&](const fs::path& folder) { write_files(texture_script, folder); });
}

/// The finest scale without its maps, which the page does not show.
EvaluatorInput drawn_color(const DrawnMaterial& material) {
  EvaluatorInput input = material.finest;
  input.maps.clear();
  return input;
}

}  // namespace

std::string web_texture_script(const EvaluatorPlanes& planes) {
  Json texture = {{"semantics", kSemantics},
                  {"size", {planes.size.x, planes.size.y}},
                  {"patch_count", planes.patch_count},
                  {"content_count", planes.content_count}};
  glsl::NoiseUniforms::fields(planes, uniform_adder(texture));
  glsl::LevelUniforms::fields(planes, uniform_adder(texture));
  Json& json = texture["planes"];
  for_each_texture(planes, planes.base, texture_adder(json));
  if (!planes.fragment_idx.empty())
    json["fragments"] = plane_json<uint32_t>(kTexelFormat<uint32_t>.name, planes.fragment_idx);
  return std::string(kTextureScript) + texture.dump() + ");\n";
}

std::string web_texture_script(const StackPlanes& planes, const ReliefPlanes* relief) {
  Json texture = {{"semantics", kSemantics}, {"scales", Json::array()}};
  glsl::NoiseUniforms::fields(planes, uniform_adder(texture));
  for (int s = 0; s < planes.scale_count(); ++s) {
    const V2i size = planes.sizes[static_cast<size_t>(s)];
    const ScaleTransfer& transfer = planes.transfers[static_cast<size_t>(s)];
    texture["scales"].push_back({{"size", {size.x, size.y}},
                                 {"ratio", transfer.ratio},
                                 {"variation_fade", transfer.variation_fade},
                                 {"level_count", planes.level_count(s)}});
  }
  Json& json = texture["planes"];
  for_each_texture(planes, texture_adder(json));
  const ReliefPlanes flat;
  for_each_texture(relief ? *relief : flat, texture_adder(json));
  if (relief) glsl::ReliefUniforms::fields(*relief, uniform_adder(texture["relief"], "relief_"));
  return std::string(kTextureScript) + texture.dump() + ");\n";
}

float default_relief_px(const EvaluatorInput& coarsest) {
  constexpr float kSharePerSide = 1.0f / 32;
  return has_heights(coarsest)
             ? kSharePerSide * static_cast<float>(std::min(coarsest.base.width(), coarsest.base.height()))
             : 0;
}

void export_web(const DrawnMaterial& material, std::optional<float> relief_px, const fs::path& folder) {
  const EvaluatorInput& coarsest = material.scales.front().input;
  ReliefOptions relief;
  relief.depth_px = relief_px.value_or(default_relief_px(coarsest));
  if (material.scales.size() == 1 && relief.depth_px == 0) return export_web(prepare(drawn_color(material)), folder);
  const StackPlanes planes = prepare_stack(material.scales);
  if (relief.depth_px == 0) return export_web(planes, nullptr, folder);
  const ReliefPlanes heights = relief_planes(coarsest, relief, kDefaultLight);
  export_web(planes, &heights, folder);
}

void export_web(const EvaluatorPlanes& planes, const fs::path& folder) {
  write_folder(web_texture_script(planes), folder);
}

void export_web(const StackPlanes& planes, const ReliefPlanes* relief, const fs::path& folder) {
  write_folder(web_texture_script(planes, relief), folder);
}

}  // namespace texbake
