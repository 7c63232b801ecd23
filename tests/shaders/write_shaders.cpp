// Writes every assembled shader into the folder given, for glslangValidator.
#include <fstream>
#include <string>

#include "pages/viewer_shaders.h"

int main(int argc, char** argv) {
  using texbake::ShaderLanguage;
  if (argc != 2) return 4;
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream file(std::string(argv[1]) + "/" + name);
    return static_cast<bool>(file << text << std::flush);
  };
  bool done = true;
  for (const auto& [language, name] :
       {std::pair(ShaderLanguage::glsl_330, "330"), {ShaderLanguage::glsl_300_es, "300es"}}) {
    done = write(std::string(name) + ".vert", texbake::reference_vertex_shader(language)) && done;
    done = write(std::string(name) + ".frag", texbake::reference_fragment_shader(language)) && done;
    done = write(std::string(name) + "_perspective.frag", texbake::perspective_fragment_shader(language)) && done;
    done = write(std::string(name) + "_viewer.frag", texbake::viewer_fragment_shader(language)) && done;
    done = write(std::string(name) + "_stack.frag", texbake::stack_fragment_shader(language)) && done;
    done = write(std::string(name) + "_stack_perspective.frag", texbake::stack_perspective_fragment_shader(language)) &&
           done;
    done = write(std::string(name) + "_stack_viewer.frag", texbake::stack_viewer_fragment_shader(language)) && done;
  }
  return done ? 0 : 4;
}
