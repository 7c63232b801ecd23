// Writes what the shader texts bind, so that a port needs none of texbake's preparation.
#pragma once

#include <filesystem>
#include <optional>

#include "libbake/planes/drawn_material.h"

namespace texbake {

inline constexpr const char* kPlanesFile = "planes.json";  ///< follows pages/planes.schema.json

/// Makes `folder`, or replaces what an earlier export of planes made there: an OpenEXR file for each texture, and
/// planes.json, which lists what each program binds. The textures and uniforms are those of for_each_texture,
/// for_each_uniform and MainUniforms, as far as the program's text declares them. `relief_px` is as for export_web.
/// Throws Error(io) when the folder holds other things, or cannot be written; Error(usage) for relief without heights.
void export_planes(const DrawnMaterial& material, std::optional<float> relief_px, const std::filesystem::path& folder);

}  // namespace texbake
