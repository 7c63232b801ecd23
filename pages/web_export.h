// Writes a self-contained folder that shows a bundle as an endless plane in a browser: no server, no network.
#pragma once

#include <filesystem>
#include <optional>

#include "libbake/planes/drawn_material.h"
#include "libbake/planes/relief_planes.h"
#include "libbake/planes/stack_planes.h"

namespace texbake {

/// The files of the folder; index.html is what a person opens. Browsers let a page opened from a disk read scripts and
/// nothing else, so the planes travel as base64 in texture.js beside their sizes and formats:
///   texbake.open({"semantics": 1, "size": [W, H], "patch_count": P, "content_count": N_t,
///                 …, every uniform of glsl::NoiseUniforms and glsl::LevelUniforms by its name,
///                 "planes": {"patch_plane": {"format": "RG16UI", "width": W, "height": H, "data": "…"}, …}})
/// with the planes and formats of shaders/README.md §2, little-endian, rows from the top; `fragments` (R32UI, the idx
/// of each texel) where there are any; `base` is RGBA16F where that is exact, else RGBA32F; `base_levels` is rounded
/// to RGBA16F, once.
/// A stack has, in place of what stands before the planes,
///   "scales": [{"size": [W, H], "ratio": r, "variation_fade": f, "level_count": L}, …], coarse to fine,
/// and the planes of "Several scales"; with relief also
///   "relief": {"depth": d, "range": [most, least, drawn, 0], "light": [x, y, ambient, 0], "steps": [s, r], "kind": k}
/// and its planes, in place of which there is else one texel of zeros each.
inline constexpr const char* kWebFiles[] = {"index.html", "infinite_texture.js", "infinite_stack.js",
                                            "viewer.js",  "shaders.js",          "texture.js"};

/// The depth of the relief where nothing else is asked for, in texels of the coarsest scale: as deep as the stones of a
/// wall are, seen from far enough to see several; 0 without heights. A guess that a person may correct.
float default_relief_px(const EvaluatorInput& coarsest);

/// Makes `folder`, or replaces those files in one that an earlier export made. A material of several scales, or with
/// relief, is a stack. `relief_px` is the depth of the relief in texels of the coarsest scale, 0 for none; nothing:
/// 1/32 of that scale's shorter side, where it has heights. Throws Error(io) when the folder holds other things, or
/// cannot be written; then nothing of an earlier export is lost; Error(usage) for relief without heights.
void export_web(const DrawnMaterial& material, std::optional<float> relief_px, const std::filesystem::path& folder);

/// The same of planes that are at hand; `relief` may be nullptr.
void export_web(const EvaluatorPlanes& planes, const std::filesystem::path& folder);
void export_web(const StackPlanes& planes, const ReliefPlanes* relief, const std::filesystem::path& folder);

/// texture.js alone.
std::string web_texture_script(const EvaluatorPlanes& planes);
std::string web_texture_script(const StackPlanes& planes, const ReliefPlanes* relief);

}  // namespace texbake
