#include "pages/web_export.h"

#include <Imath/half.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "formats/base64.h"
#include "formats/bundle.h"
#include "formats/safe_file.h"
#include "libbake/base/error.h"
#include "libbake/base/half.h"
#include "libbake/reference/semantics.h"
#include "pages/viewer_shaders.h"

namespace texbake {
namespace {

namespace fs = std::filesystem;

constexpr std::pair<std::string_view, std::string_view> kViewerFiles[] = {
#include "pages/embedded_viewer.inc"
};

constexpr float kMaxHalf = 65504;

static_assert(std::endian::native == std::endian::little, "planes are written as they lie in memory");

template <class T>
Json plane_json(const char* format, ImageView<const T> texels) {
  return {{"format", format},
          {"width", texels.width()},
          {"height", texels.height()},
          {"data", base64(texels.data(), texels.size() * sizeof(T))}};
}

/// As halves, where `fits` says that every value may be one.
template <class Fits>
Json values_json(const Image<glsl::vec4>& texels, const Fits& fits) {
  const auto* values = reinterpret_cast<const float*>(texels.data());
  const size_t count = 4 * texels.size();
  if (!std::all_of(values, values + count, fits)) return plane_json<glsl::vec4>("RGBA32F", texels);
  struct HalfTexel {
    uint16_t channels[4];
  };
  Image<HalfTexel> halves(texels.width(), texels.height());
  for (size_t i = 0; i < count; ++i) halves.data()[i / 4].channels[i % 4] = Imath::half(values[i]).bits();
  return plane_json<HalfTexel>("RGBA16F", halves);
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

void check_folder(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return;
  const auto refuse = [&](const std::string& found) {
    throw Error(ErrorKind::io,
                fmt::format("{}: expected a new folder or one that an earlier export made, found {}: give "
                            "another -o",
                            folder.string(), found));
  };
  if (!fs::is_directory(status)) refuse("a file");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool ours =
        std::any_of(std::begin(kWebFiles), std::end(kWebFiles), [&](const char* file) { return name == file; });
    if (!ours && !is_temporary_name(name)) refuse(fmt::format("\"{}\" in it", name));
  }
}

bool is_half(float value) { return half_exact(value) == value; }
bool may_be_half(float value) { return std::abs(value) <= kMaxHalf; }

Json relief_json(const ReliefPlanes& relief) {
  const auto four = [](const glsl::vec4& v) { return Json{v.x, v.y, v.z, v.w}; };
  return {{"depth", relief.depth_px},
          {"range", four(relief.range)},
          {"light", four(relief.light)},
          {"steps", {relief.steps.x, relief.steps.y}},
          {"kind", relief.kind}};
}

void write_folder(const std::string& texture_script, const fs::path& folder) {
  check_folder(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Error(ErrorKind::io, fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
  const auto write = [&](std::string_view name, std::string_view text) {
    SafeFile file(folder / name);
    file.write(text);
    file.commit();
  };
  write("texture.js", texture_script);
  write("shaders.js", shaders_script());
  for (const auto& [name, text] : kViewerFiles) write(name, text);
}

}  // namespace

std::string web_texture_script(const EvaluatorPlanes& planes) {
  Json texture = {{"semantics", kSemantics},
                  {"size", {planes.size.x, planes.size.y}},
                  {"patch_count", planes.patch_count},
                  {"content_count", planes.content_count},
                  {"noise_step", planes.noise_step},
                  {"noise_root", planes.noise_root},
                  {"noise_log2", {planes.noise_log2.x, planes.noise_log2.y}},
                  {"level_count", planes.level_count},
                  {"first_level", planes.first_level}};
  Json& json = texture["planes"];
  json["patch_plane"] = plane_json<glsl::PatchTexel>("RG16UI", planes.patch_plane);
  json["contents"] = plane_json<glsl::ivec4>("RGBA32I", planes.contents);
  json["centers"] = plane_json<glsl::ivec4>("RGBA32I", planes.centers);
  json["base"] = values_json(planes.base.texels, is_half);
  json["masks"] = plane_json<glsl::MaskTexel>("RGBA16UI", planes.masks);
  json["noise_tiles"] = values_json(planes.noise_tiles, is_half);
  json["level_table"] = plane_json<glsl::ivec4>("RGBA32I", planes.level_table);
  json["level_blocks"] = plane_json<glsl::LevelBlock>("RG32UI", planes.level_blocks);
  json["level_entries"] = plane_json<glsl::PatchTexel>("RG16UI", planes.level_entries);
  json["level_weights"] = plane_json<glsl::MaskTexel>("RGBA16UI", planes.level_weights);
  json["base_levels"] = values_json(planes.base.level_values, may_be_half);
  if (!planes.fragment_idx.empty()) json["fragments"] = plane_json<uint32_t>("R32UI", planes.fragment_idx);
  return "texbake.open(" + texture.dump() + ");\n";
}

std::string web_texture_script(const StackPlanes& planes, const ReliefPlanes* relief) {
  Json texture = {{"semantics", kSemantics},
                  {"scales", Json::array()},
                  {"noise_step", planes.noise_step},
                  {"noise_root", planes.noise_root},
                  {"noise_log2", {planes.noise_log2.x, planes.noise_log2.y}}};
  for (int s = 0; s < planes.scale_count(); ++s) {
    const V2i size = planes.sizes[static_cast<size_t>(s)];
    const ScaleTransfer& transfer = planes.transfers[static_cast<size_t>(s)];
    texture["scales"].push_back({{"size", {size.x, size.y}},
                                 {"ratio", transfer.ratio},
                                 {"variation_fade", transfer.variation_fade},
                                 {"level_count", planes.level_count(s)}});
  }
  Json& json = texture["planes"];
  json["patch_plane"] = plane_json<glsl::PatchTexel>("RG16UI", planes.patch_plane);
  json["contents"] = plane_json<glsl::ivec4>("RGBA32I", planes.contents);
  json["base"] = values_json(planes.base, is_half);
  json["masks"] = plane_json<glsl::MaskTexel>("RGBA16UI", planes.masks);
  json["noise_tiles"] = values_json(planes.noise_tiles, is_half);
  json["fragment_plane"] = plane_json<glsl::FragmentTexel>("RGBA16I", planes.fragment_plane);
  json["local_mean"] = plane_json<glsl::vec4>("RGBA32F", planes.local_mean);
  json["scale_table"] = plane_json<glsl::ivec4>("RGBA32I", planes.scale_table);
  json["color_table"] = plane_json<glsl::vec4>("RGBA32F", planes.color_table);
  json["level_blocks"] = plane_json<glsl::LevelBlock>("RG32UI", planes.level_blocks);
  json["level_entries"] = plane_json<glsl::PatchTexel>("RG16UI", planes.level_entries);
  json["base_levels"] = values_json(planes.base_levels, may_be_half);
  json["level_weights"] = plane_json<glsl::MaskTexel>("RGBA16UI", planes.level_weights);
  json["fragment_shares"] = plane_json<glsl::ivec4>("RGBA32I", planes.fragment_shares);
  const Image<glsl::vec4> none(1, 1, {0, 0, 0, 0});
  json["height_plane"] = plane_json<glsl::vec4>("RGBA32F", relief ? relief->height_plane : none);
  json["height_levels"] = values_json(relief ? relief->height_levels : none, may_be_half);
  if (relief) texture["relief"] = relief_json(*relief);
  return "texbake.open(" + texture.dump() + ");\n";
}

void export_web(const EvaluatorPlanes& planes, const fs::path& folder) {
  write_folder(web_texture_script(planes), folder);
}

void export_web(const StackPlanes& planes, const ReliefPlanes* relief, const fs::path& folder) {
  write_folder(web_texture_script(planes, relief), folder);
}

}  // namespace texbake
