#include "libbake/gl/gl_context.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <string_view>
#include <vector>

// No window system: their headers define words such as `None`.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "libbake/base/error.h"
#include "libbake/gl/gl_functions.h"

namespace texbake {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw Error(ErrorKind::unsupported, fmt::format("OpenGL: {}; on Debian, \"apt-get install libegl1 libegl-mesa0 "
                                                  "libgl1-mesa-dri\" installs a software driver that needs no display",
                                                  what));
}

struct EglFunctions {
  PFNEGLGETPROCADDRESSPROC GetProcAddress = nullptr;
  PFNEGLQUERYSTRINGPROC QueryString = nullptr;
  PFNEGLGETDISPLAYPROC GetDisplay = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay = nullptr;
  PFNEGLQUERYDEVICESEXTPROC QueryDevices = nullptr;
  PFNEGLINITIALIZEPROC Initialize = nullptr;
  PFNEGLTERMINATEPROC Terminate = nullptr;
  PFNEGLBINDAPIPROC BindAPI = nullptr;
  PFNEGLCHOOSECONFIGPROC ChooseConfig = nullptr;
  PFNEGLCREATECONTEXTPROC CreateContext = nullptr;
  PFNEGLDESTROYCONTEXTPROC DestroyContext = nullptr;
  PFNEGLMAKECURRENTPROC MakeCurrent = nullptr;
};

EglFunctions load_egl() {
  // Never closed: drivers do not survive it.
  static void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!library) fail("libEGL.so.1 was not found");
  EglFunctions egl;
  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::decay_t<decltype(function)>>(dlsym(library, name));
    if (!function) fail(fmt::format("libEGL.so.1 has no {}", name));
  };
  load(egl.GetProcAddress, "eglGetProcAddress");
  load(egl.QueryString, "eglQueryString");
  load(egl.GetDisplay, "eglGetDisplay");
  load(egl.Initialize, "eglInitialize");
  load(egl.Terminate, "eglTerminate");
  load(egl.BindAPI, "eglBindAPI");
  load(egl.ChooseConfig, "eglChooseConfig");
  load(egl.CreateContext, "eglCreateContext");
  load(egl.DestroyContext, "eglDestroyContext");
  load(egl.MakeCurrent, "eglMakeCurrent");
  egl.GetPlatformDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl.GetProcAddress("eglGetPlatformDisplayEXT"));
  egl.QueryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.GetProcAddress("eglQueryDevicesEXT"));
  return egl;
}

EGLDisplay device_display(const EglFunctions& egl, int number) {
  std::vector<EGLDeviceEXT> devices(64);
  EGLint count = 0;
  if (!egl.QueryDevices || !egl.GetPlatformDisplay ||
      !egl.QueryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count))
    fail("this EGL cannot list devices");
  if (number < 0 || number >= count) fail(fmt::format("expected EGL device 0 to {}, found {}", count - 1, number));
  return egl.GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<size_t>(number)], nullptr);
}

EGLDisplay open_display(const EglFunctions& egl, std::optional<int> device) {
  if (device) {
    const EGLDisplay display = device_display(egl, *device);
    if (display && egl.Initialize(display, nullptr, nullptr)) return display;
    fail(fmt::format("EGL device {} could not be opened", *device));
  }
  const EGLDisplay surfaceless =
      egl.GetPlatformDisplay ? egl.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                             : EGL_NO_DISPLAY;
  if (surfaceless && egl.Initialize(surfaceless, nullptr, nullptr)) return surfaceless;
  const EGLDisplay any = egl.GetDisplay(EGL_DEFAULT_DISPLAY);
  if (any && egl.Initialize(any, nullptr, nullptr)) return any;
  fail("no EGL display could be opened");
}

EGLContext create_context(const EglFunctions& egl, EGLDisplay display, ShaderLanguage language) {
  const bool es = language == ShaderLanguage::glsl_300_es;
  const EGLint config_wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT,
                                  EGL_NONE};
  const EGLint core[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  const EGLint embedded[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!egl.BindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) ||
      !egl.ChooseConfig(display, config_wanted, &config, 1, &count) || count < 1)
    return EGL_NO_CONTEXT;
  return egl.CreateContext(display, config, EGL_NO_CONTEXT, es ? embedded : core);
}

}  // namespace

struct GlContext::State {
  EglFunctions egl;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  ShaderLanguage language = ShaderLanguage::glsl_330;
  GlFunctions gl;

  ~State() {
    if (context != EGL_NO_CONTEXT) {
      egl.MakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      egl.DestroyContext(display, context);
    }
    if (display != EGL_NO_DISPLAY) egl.Terminate(display);
  }
};

GlContext::GlContext(const GlContextOptions& options) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.language = options.language;
  s.egl = load_egl();
  s.display = open_display(s.egl, options.device);
  const char* const version = options.language == ShaderLanguage::glsl_330 ? "OpenGL 3.3 core" : "OpenGL ES 3.0";
  s.context = create_context(s.egl, s.display, options.language);
  if (s.context == EGL_NO_CONTEXT || !s.egl.MakeCurrent(s.display, EGL_NO_SURFACE, EGL_NO_SURFACE, s.context))
    fail(fmt::format("expected a driver for {} that needs no surface, found {}", version,
                     s.egl.QueryString(s.display, EGL_VENDOR)));
  for_each_gl_function(s.gl, [&](auto& function, const char* name) {
    function = reinterpret_cast<std::decay_t<decltype(function)>>(s.egl.GetProcAddress(name));
    if (!function) fail(fmt::format("the driver lacks {}", name));
  });
}

GlContext::~GlContext() = default;

ShaderLanguage GlContext::language() const { return state_->language; }
const GlFunctions& GlContext::functions() const { return state_->gl; }

std::string GlContext::description() const {
  const auto text = [&](GLenum name) { return reinterpret_cast<const char*>(state_->gl.GetString(name)); };
  return fmt::format("{}, {}", text(GL_RENDERER), text(GL_VERSION));
}

}  // namespace texbake
