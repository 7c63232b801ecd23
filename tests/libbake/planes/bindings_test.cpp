// What C++ lists of textures and uniforms, and what the shader texts declare: the same names, of the same types.
#include "libbake/reference/bindings.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <map>
#include <memory>
#include <regex>
#include <string>
#include <type_traits>
#include <typeindex>
#include <typeinfo>

#include "libbake/planes/evaluator_planes.h"
#include "libbake/planes/program_of.h"
#include "libbake/planes/relief_planes.h"
#include "libbake/planes/stack_planes.h"
#include "libbake/reference/perspective_program.h"
#include "shaders/shader_texts.h"

namespace texbake {
namespace {

/// GLSL types by name; arrays as "uvec4[8]".
using Bindings = std::map<std::string, std::string>;

template <class T>
std::string type_name() {
  static const std::map<std::type_index, std::string> names = {
      {typeid(int), "int"},           {typeid(glsl::uint), "uint"},   {typeid(float), "float"},
      {typeid(glsl::ivec2), "ivec2"}, {typeid(glsl::uvec2), "uvec2"}, {typeid(glsl::ivec4), "ivec4"},
      {typeid(glsl::uvec4), "uvec4"}, {typeid(glsl::vec3), "vec3"},   {typeid(glsl::vec4), "vec4"}};
  using Element = std::remove_extent_t<T>;
  const std::string name = names.at(typeid(Element));
  return std::is_array_v<T> ? name + "[" + std::to_string(std::extent_v<T>) + "]" : name;
}

Bindings declared(std::initializer_list<const char*> texts) {
  static const std::regex declaration(R"(uniform (\w+) (\w+)(\[\d+\])?;)");
  Bindings found;
  for (const char* name : texts) {
    const std::string text(shader_text(name));
    for (std::sregex_iterator at(text.begin(), text.end(), declaration), end; at != end; ++at)
      found[(*at)[2]] = std::string((*at)[1]) + std::string((*at)[3]);
  }
  return found;
}

/// Adds what it is called with to the bindings.
struct Collector {
  Bindings& bindings;

  template <class T>
  void operator()(const char* name, const T&) const {
    EXPECT_TRUE(bindings.emplace(name, type_name<T>()).second) << name << " is listed twice";
  }
  template <class T, class S>
  void operator()(const Texture& texture, const Image<T>&, S glsl::Samplers::*) const {
    EXPECT_TRUE(bindings.emplace(texture.name, kTexelFormat<T>.sampler).second) << texture.name << " is listed twice";
  }
};

template <class... Groups>
Bindings listed() {
  Bindings bindings;
  (Groups::fields(*std::make_unique<const Groups>(), Collector{bindings}), ...);
  return bindings;
}

Bindings operator+(Bindings a, const Bindings& b) {
  a.insert(b.begin(), b.end());
  return a;
}

Bindings textures_of_tile() {
  Bindings bindings;
  const EvaluatorPlanes planes;
  for_each_texture(planes, planes.base, Collector{bindings});
  return bindings;
}

Bindings textures_of_stack() {
  Bindings bindings;
  for_each_texture(StackPlanes(), Collector{bindings});
  for_each_texture(ReliefPlanes(), Collector{bindings});
  return bindings;
}

TEST(Bindings, ATileBindsWhatItsTextDeclares) {
  const Bindings uniforms =
      listed<glsl::NoiseUniforms, glsl::LevelUniforms, glsl::TileUniforms, glsl::DeformUniforms>();
  EXPECT_EQ(declared({"bindings.glsl"}), textures_of_tile() + uniforms);
}

TEST(Bindings, AStackBindsWhatItsTextsDeclare) {
  // Of the noises, whose step depends on the scale in use, what does not.
  Bindings expected = textures_of_stack() + listed<glsl::NoiseUniforms, glsl::StackUniforms, glsl::ReliefUniforms>();
  expected.erase("noise_step");
  EXPECT_EQ(declared({"stack_bindings.glsl", "relief_bindings.glsl"}), expected);
}

TEST(Bindings, ACameraIsWhatItsTextDeclares) {
  EXPECT_EQ(declared({"perspective_bindings.glsl"}), listed<glsl::CameraUniforms>());
}

TEST(Bindings, MainReadsWhatItsTextsDeclare) {
  EXPECT_EQ(declared({"reference.frag", "perspective.frag", "stack.frag", "stack_perspective.frag"}),
            listed<glsl::MainUniforms>());
}

TEST(Bindings, AProgramListsEveryGroup) {
  Bindings all;
  const glsl::PerspectiveProgram program;
  glsl::for_each_uniform(program, Collector{all});
  const Bindings groups = listed<glsl::NoiseUniforms, glsl::LevelUniforms, glsl::TileUniforms, glsl::DeformUniforms,
                                 glsl::StackUniforms, glsl::ReliefUniforms, glsl::CameraUniforms>();
  EXPECT_EQ(all, groups);
}

TEST(Bindings, ABoundProgramHasEveryTextureAndGroupOfItsPlanes) {
  EvaluatorPlanes planes;
  planes.masks = Image<glsl::MaskTexel>(3, 2);
  planes.base.level_values = Image<glsl::vec4>(5, 1);
  planes.noise_root = 1;
  planes.level_count = 7;
  const glsl::Program program = program_of(planes, 0);
  EXPECT_EQ(program.masks.texels, planes.masks.data());
  EXPECT_EQ(program.masks.width, 3);
  EXPECT_EQ(program.base_levels.texels, planes.base.level_values.data());
  EXPECT_EQ(program.noise_root, 1);
  EXPECT_EQ(program.level_count, 7);
}

}  // namespace
}  // namespace texbake
