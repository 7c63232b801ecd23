#include "formats/evaluator_input.h"

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

}  // namespace

EvaluatorInput evaluator_input(const Scale& scale) {
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

EvaluatorInput evaluator_input(const Bundle& bundle) {
  EvaluatorInput input = evaluator_input(bundle.scales.back());
  if (bundle.noise) input.noise = noise_input(bundle.scales.back(), *bundle.noise);
  return input;
}

std::vector<StackScale> stack_input(const Bundle& bundle) {
  std::vector<StackScale> scales;
  for (const Scale& scale : bundle.scales) {
    scales.push_back({evaluator_input(scale), pointer_to(scale.transfer)});
    scales.back().input.base = scale.exemplar;
  }
  if (bundle.noise) scales.back().input = evaluator_input(bundle);
  return scales;
}

}  // namespace texbake
