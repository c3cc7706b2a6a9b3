// Part of offscreen_context.cpp for Linux, with EGL.
#pragma once

#include <epoxy/egl.h>

#include <array>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "viewer/gl/offscreen_context.h"

namespace drench::viewer {

inline std::runtime_error eglError(const std::string& what) {
    std::ostringstream code;
    code << "0x" << std::hex << std::setw(4) << std::setfill('0') << eglGetError();
    return std::runtime_error(
        "viewer: no off-screen OpenGL: " + what + " (EGL error " + code.str() +
        "); install EGL and Mesa's drivers (Debian: libegl1 libegl-mesa0 libgl1-mesa-dri)");
}

inline bool lists(const char* extensions, std::string_view wanted) {
    std::string_view rest = extensions == nullptr ? "" : extensions;
    while (!rest.empty()) {
        const std::size_t end = rest.find(' ');
        if (rest.substr(0, end) == wanted) return true;
        rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
    }
    return false;
}

inline bool initialised(EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
}

inline EGLDisplay openDisplay() {
    const char* const extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (lists(extensions, "EGL_EXT_platform_base") && lists(extensions, "EGL_MESA_platform_surfaceless")) {
        const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (initialised(display)) return display;
    }
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (!initialised(display)) throw eglError("no EGL display can be opened");
    return display;
}

inline EGLConfig chooseConfig(EGLDisplay display, bool surfaceless) {
    const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                       surfaceless ? 0 : EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &found) != EGL_TRUE || found < 1)
        throw eglError("the EGL display offers no OpenGL");
    return config;
}

class OffscreenContext::Platform {
  public:
    Platform() {
        // Without this check libepoxy would end the program if libEGL.so.1 is missing.
        if (!epoxy_has_egl()) {
            throw std::runtime_error(
                "viewer: no off-screen OpenGL: libEGL.so.1 is missing; install EGL (Debian: libegl1 "
                "libgl1-mesa-dri)");
        }
        display_ = openDisplay();
        const bool surfaceless = epoxy_has_egl_extension(display_, "EGL_KHR_surfaceless_context");
        if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) throw eglError("EGL knows no desktop OpenGL");
        const EGLConfig config = chooseConfig(display_, surfaceless);
        try {
            create(config, surfaceless);
        } catch (...) {
            release();
            throw;
        }
    }
    ~Platform() { release(); }
    Platform(const Platform&) = delete;
    Platform& operator=(const Platform&) = delete;

    void makeCurrent() const {
        if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE ||
            eglMakeCurrent(display_, surface_, surface_, context_) != EGL_TRUE) {
            throw eglError(
                "the context cannot be made current; close the Window of this thread first, if there is one");
        }
    }

  private:
    void create(EGLConfig config, bool surfaceless) {
        constexpr std::array<EGLint, 9> version{EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                3,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_CONTEXT_OPENGL_DEBUG,
                                                EGL_TRUE,
                                                EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version.data());
        if (context_ == EGL_NO_CONTEXT) throw eglError("OpenGL 3.3 core is not available");
        if (!surfaceless) {
            constexpr std::array<EGLint, 5> size{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface_ = eglCreatePbufferSurface(display_, config, size.data());
            if (surface_ == EGL_NO_SURFACE) throw eglError("no off-screen surface can be made");
        }
        makeCurrent();
    }

    // The display stays open: EGL shares it with all code in the process, and closing it would end other
    // contexts, too.
    void release() {
        if (context_ != EGL_NO_CONTEXT && eglGetCurrentContext() == context_)
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

}  // namespace drench::viewer
