#include "formats/drawn_bundle.h"

namespace texbake {

namespace {

template <class T>
const T* pointer_to(const std::optional<T>& part) {
  return part ? &*part : nullptr;
}

MapKind kind_of(const Map& map) {
  if (map.convention == "opengl") return MapKind::normal_opengl;
  if (map.convention == "directx") return MapKind::normal_directx;
  return MapKind::plain;
}

NoiseInput noise_input(const Scale& scale, const NoiseModel& model) {
  NoiseInput input;
  for (const Image<float>& mask : scale.masks) input.masks.push_back(mask);
  for (const Noise& noise : model.noises) input.tiles.push_back(noise.tile);
  input.row_step = model.lattice.row_step;
  input.space = model.space;
  return input;
}

/// Any scale by itself, without noise.
EvaluatorInput scale_input(const Scale& scale) {
  EvaluatorInput input;
  input.base = scale.base();
  input.patches = pointer_to(scale.patches);
  input.contents = pointer_to(scale.contents);
  input.fragments = pointer_to(scale.fragments);
  input.colors = pointer_to(scale.colors);
  input.soft_border_px = scale.soft_border_px;
  for (const Map& map : scale.maps)
    input.maps.push_back({map.name, kind_of(map), {map.planes, map.planes + map.channels}});
  if (scale.height) input.maps.push_back({"height", MapKind::height, {*scale.height}});
  return input;
}

}  // namespace

EvaluatorInput evaluator_input(const Bundle& bundle) {
  EvaluatorInput input = scale_input(bundle.scales.back());
  if (bundle.noise) input.noise = noise_input(bundle.scales.back(), *bundle.noise);
  return input;
}

std::vector<StackScale> stack_input(const Bundle& bundle) {
  std::vector<StackScale> scales;
  for (const Scale& scale : bundle.scales) {
    scales.push_back({scale_input(scale), pointer_to(scale.transfer)});
    scales.back().input.base = scale.exemplar;
  }
  if (bundle.noise) scales.back().input = evaluator_input(bundle);
  return scales;
}

DrawnMaterial drawn_material(const Bundle& bundle) { return {evaluator_input(bundle), stack_input(bundle)}; }

PictureRole picture_role(const Bundle& bundle, const std::string& name) {
  if (name.empty()) return PictureRole::color;
  for (const Map& map : bundle.scales.back().maps)
    if (map.name == name && kind_of(map) != MapKind::plain) return PictureRole::normal;
  return PictureRole::data;
}

}  // namespace texbake
