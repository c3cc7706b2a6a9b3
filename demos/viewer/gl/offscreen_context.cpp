#include "viewer/gl/offscreen_context.h"

#if defined(__linux__)
#include "viewer/gl/offscreen_context_egl.h"
#else
#include "viewer/gl/offscreen_context_glfw.h"
#endif

namespace drench::viewer {

OffscreenContext::OffscreenContext() : platform_(std::make_unique<Platform>()) {}

OffscreenContext::~OffscreenContext() = default;

void OffscreenContext::makeCurrent() const {
    platform_->makeCurrent();
}

}  // namespace drench::viewer
