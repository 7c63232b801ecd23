// A context for a test, or nothing, said loudly, where there is no OpenGL.
#pragma once

#include <cstdio>
#include <memory>

#include "libbake/base/error.h"
#include "libbake/gl/gl_context.h"

namespace texbake {

inline std::unique_ptr<GlContext> test_context(ShaderLanguage language) {
  try {
    return std::make_unique<GlContext>(GlContextOptions{language, std::nullopt});
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::unsupported) throw;
    std::printf("SKIPPED, no OpenGL: %s\n", error.what());
    return nullptr;
  }
}

}  // namespace texbake
