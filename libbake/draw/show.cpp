#include "libbake/draw/show.h"

#include <fmt/format.h>

#include <algorithm>

#include "libbake/base/error.h"
#include "libbake/base/parallel.h"
#include "libbake/draw/window_program.h"
#include "libbake/draw/window_rows.h"

namespace texbake {
namespace {

using glsl::Decision;
using glsl::Program;
using glsl::Texel;

constexpr float kBorder = 0.02f;        ///< dark beside every hue of hue_color
constexpr float kMiddleGray = 0.2159f;  ///< half of the codes of sRGB
constexpr float kVariationSpan = 60;    ///< ΔE from middle gray to black or white: a wide class reaches ±50

/// A saturated color for a label: hues by the golden ratio, so that neighbors in number are far apart in hue.
V3f hue_color(uint32_t label) {
  const uint32_t turn = label * 2654435769u;  // 2^32 / golden ratio: the top bits step around the circle
  const float hue = static_cast<float>(turn >> 8) * 0x1p-24f * 6.0f;
  const auto channel = [&](float peak) {
    float away = std::abs(hue - peak);
    away = std::min(away, 6.0f - away);
    return std::clamp(2.0f - away, 0.0f, 1.0f);
  };
  const float light = 0.35f + 0.45f * static_cast<float>((label * 5u) % 3u) * 0.5f;
  return V3f(channel(0), channel(2), channel(4)) * light + V3f(0.08f);
}

/// A texel of the view, and those that the view shows to its right and below.
struct Shown {
  Texel texel, right, lower;
};

/// True where what is shown to the right or below belongs to another patch, or to another repetition of the same one.
bool on_border(Program& program, const Shown& at, const Decision& decision) {
  const auto differs = [&](const Texel& other) {
    const Decision there = program.decide(other);
    const auto owner = [](const Texel& t, const Decision& d) {
      return std::pair(t.tile.x + static_cast<uint32_t>(d.owner.x), t.tile.y + static_cast<uint32_t>(d.owner.y));
    };
    return there.patch_idx != decision.patch_idx || owner(other, there) != owner(at.texel, decision);
  };
  return differs(at.right) || differs(at.lower);
}

V3f content_color(int content) { return content == 0 ? V3f(0.4f) : hue_color(static_cast<uint32_t>(content)); }

V3f color_of(const glsl::vec4& value) { return {value.x, value.y, value.z}; }

/// What the two layers hold at a texel.
V3f shown_layer(Program& program, Show show, const Texel& texel, const glsl::Source& source) {
  const V3f structure = color_of(program.source_value(program.base, source));
  if (show == Show::structure) return structure;
  if (show == Show::noise)
    return V3f(kMiddleGray) + color_of(program.layered_value(program.base, texel, source)) - structure;
  const glsl::uvec4 weights = program.source_weights(source);
  return (hue_color(1) * static_cast<float>(weights.x) + hue_color(2) * static_cast<float>(weights.y) +
          hue_color(3) * static_cast<float>(weights.z) + hue_color(4) * static_cast<float>(weights.w)) /
         2048.0f;
}

/// The color of one texel of the view.
V3f shown(const EvaluatorPlanes& planes, Program& program, Show show, const Shown& at) {
  const Decision decision = program.decide(at.texel);
  const glsl::Source from = program.source_of(at.texel, decision);
  const glsl::ivec2 source = from.nearest;
  switch (show) {
    case Show::patches:
      return on_border(program, at, decision) ? V3f(kBorder) : hue_color(static_cast<uint32_t>(decision.patch_idx));
    case Show::contents:
      return on_border(program, at, decision) ? V3f(kBorder) : content_color(decision.content);
    case Show::fragments:
      return hue_color(planes.fragment_idx(source.x, source.y));
    case Show::index:
      return planes.dominant(source.x, source.y);
    case Show::variation:
      return V3f(std::clamp(0.5f + planes.variation(source.x, source.y) * (0.5f / kVariationSpan), 0.0f, 1.0f));
    case Show::structure:
    case Show::noise:
    case Show::masks:
      return shown_layer(program, show, at.texel, from);
    case Show::color:
      break;
  }
  return V3f(0);
}

}  // namespace

void check_show(const EvaluatorInput& input, Show show) {
  const bool lacks_fragments = show == Show::fragments && !input.fragments;
  const bool lacks_colors = (show == Show::index || show == Show::variation) && !input.colors;
  const bool lacks_noise = (show == Show::structure || show == Show::noise || show == Show::masks) && !input.noise;
  if (lacks_noise)
    throw Error(
        ErrorKind::usage,
        fmt::format(
            "--show {}: the bundle has no noise; run \"texbake decompose\" and \"texbake estimate-psd\" on it first",
            enum_name(show)));
  if (lacks_fragments || lacks_colors)
    throw Error(ErrorKind::usage, fmt::format("--show {}: the bundle has none; run \"texbake {}\" on it first",
                                              enum_name(show), lacks_fragments ? "fragment" : "convert"));
}

Image<V3f> show_rows(const EvaluatorPlanes& planes, const Window& window, Show show, int row_begin, int row_end) {
  if (show == Show::color) return render_rows(planes, window, row_begin, row_end);
  check_window(window, planes.size);
  Image<V3f> rows(window.width, row_end - row_begin);
  const glsl::Position origin = origin_of(window);
  parallel_for(0, rows.height(), [&](int j) {
    Program program = program_of(planes, window.seed);
    const auto texel_of = [&](int x, int y) {
      const glsl::uvec2 pixel{static_cast<uint32_t>(x), static_cast<uint32_t>(y)};
      return program.texel_at(program.pixel_position(origin, window.step_256, pixel));
    };
    const int y = row_begin + j;
    for (int i = 0; i < rows.width(); ++i) {
      const Texel texel = texel_of(i, y);
      // Borders are one pixel wide, one texel where texels are larger.
      const bool small = window.step_256 > 256;
      const Texel right = small ? texel_of(i + 1, y) : program.right_of(texel);
      const Texel lower = small ? texel_of(i, y + 1) : program.below(texel);
      rows(i, j) = shown(planes, program, show, {texel, right, lower});
    }
  });
  return rows;
}

}  // namespace texbake
