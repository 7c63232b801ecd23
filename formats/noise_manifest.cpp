#include "formats/noise_manifest.h"

#include <fmt/format.h>

#include "formats/json_text.h"
#include "formats/noise_planes.h"

namespace texbake {
namespace {

constexpr const char* kPointer = "/noise";

/// Lobes are rounded to 20 significant bits: a float holds them.
Json number(double value) { return json_number(static_cast<float>(value)); }
double value_of(const Json& json) { return static_cast<double>(json.get<float>()); }

Json lobe_json(const Lobe& lobe) {
  return {{"power", number(lobe.power)},
          {"center", Json::array({number(lobe.center_x_cpp), number(lobe.center_y_cpp)})},
          {"factor", Json::array({number(lobe.l_xx), number(lobe.l_xy), number(lobe.l_yy)})}};
}

Lobe lobe_of(const Json& json) {
  return {.power = value_of(json["power"]),
          .center_x_cpp = value_of(json["center"][0]),
          .center_y_cpp = value_of(json["center"][1]),
          .l_xx = value_of(json["factor"][0]),
          .l_xy = value_of(json["factor"][1]),
          .l_yy = value_of(json["factor"][2])};
}

Json channel_json(const NoiseChannel& channel) {
  Json lobes = Json::array();
  for (const Lobe& lobe : channel.lobes.lobes) lobes.push_back(lobe_json(lobe));
  return {{"lobes", lobes}, {"lobeError", number(channel.lobes.error)}};
}

Json one_noise_json(const Noise& noise, const PlaneRef& spectrum, const PlaneRef& tile) {
  Json channels = Json::array(), axes = Json::array();
  for (const NoiseChannel& channel : noise.channels) channels.push_back(channel_json(channel));
  for (const V3f& axis : noise.basis.axis) axes.push_back(vector_json(axis));
  return {{"mean", vector_json(noise.basis.mean)},
          {"axes", axes},
          {"spectrumSize", noise.spectrum_size()},
          {"spectrum", plane_json(spectrum)},
          {"tile", plane_json(tile)},
          {"channels", channels}};
}

Noise noise_of(const Json& json) {
  Noise noise;
  noise.basis.mean = vector_of(json["mean"]);
  for (size_t c = 0; c < 3; ++c) {
    noise.basis.axis[c] = vector_of(json["axes"][c]);
    const Json& channel = json["channels"][c];
    noise.channels[c].lobes.error = value_of(channel["lobeError"]);
    for (const Json& lobe : channel["lobes"]) noise.channels[c].lobes.lobes.push_back(lobe_of(lobe));
  }
  return noise;
}

void read_refs(const Json& json, NoiseRefs& refs, IssueLog& log) {
  const Json& noises = json["noises"];
  const int side = json["tileSize"].get<int>();
  for (size_t k = 0; k < noises.size(); ++k) {
    const std::string pointer = fmt::format("{}/noises/{}", kPointer, k);
    const int size = noises[k]["spectrumSize"].get<int>();
    refs.spectra.push_back(
        plane_ref(kSpectrumKey + std::to_string(k), noises[k]["spectrum"], pointer + "/spectrum", {size, size}, log));
    refs.tiles.push_back(
        plane_ref(kTileKey + std::to_string(k), noises[k]["tile"], pointer + "/tile", {side, side}, log));
  }
  const V2i table(Equalization::kEntries, static_cast<int>(3 * noises.size()));
  refs.spectra.push_back(plane_ref(kHistogramKey, json["histogram"], std::string(kPointer) + "/histogram", table, log));
  check_payload_name(kSpectraName, refs.spectra, std::string(kPointer) + "/noises", log);
  check_payload_name(kTilesName, refs.tiles, std::string(kPointer) + "/noises", log);
}

}  // namespace

NoiseRefs noise_refs(const NoiseModel& noise) {
  return {hash_planes(spectrum_planes(noise), kSpectraName), hash_planes(tile_planes(noise), kTilesName)};
}

Json noise_json(const NoiseModel& noise, const NoiseRefs& refs) {
  Json noises = Json::array();
  for (size_t k = 0; k < noise.noises.size(); ++k)
    noises.push_back(one_noise_json(noise.noises[k], refs.spectra[k], refs.tiles[k]));
  return {{"tileSize", tiles_size(noise).x},
          {"rowStep", noise.lattice.row_step},
          {"space", enum_name(noise.space)},
          {"histogram", plane_json(refs.spectra.back())},
          {"noises", noises}};
}

void read_noise(const Json& json, size_t mask_count, NoiseModel& model, NoiseRefs& refs, IssueLog& log) {
  warn_unknown_members(json, kPointer, {"tileSize", "rowStep", "space", "histogram", "noises"}, log);
  if (json["noises"].size() != mask_count)
    log.add({IssueId::count_mismatch,
             {.pointer = std::string(kPointer) + "/noises"},
             fmt::format("expected {} noises, one for each mask of the finest scale, found {}", mask_count,
                         json["noises"].size())});
  const int side = json["tileSize"].get<int>();
  model.lattice = {side * side, json["rowStep"].get<int>()};
  model.space = enum_value<NoiseSpace>(json["space"].get<std::string>()).value();
  for (size_t k = 0; k < json["noises"].size(); ++k) {
    const Json& one = json["noises"][k];
    warn_unknown_members(one, fmt::format("{}/noises/{}", kPointer, k),
                         {"mean", "axes", "spectrumSize", "spectrum", "tile", "channels"}, log);
    model.noises.push_back(noise_of(one));
  }
  read_refs(json, refs, log);
  if (log.error_below(kPointer)) refs = {};
}

}  // namespace texbake
