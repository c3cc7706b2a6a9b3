#include "viewer/gl/gl_error_count.h"

namespace drench::viewer {

void GlErrorCount::receive(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar*, const void* self) {
    if (type == GL_DEBUG_TYPE_ERROR) {
        // OpenGL hands the pointer back as const, though it was given a non-const one.
        ++static_cast<GlErrorCount*>(const_cast<void*>(self))->count_;
    }
}

GlErrorCount::GlErrorCount() {
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    // Another context may take over the callback; this one then gets no messages.
    hasMessages_ = epoxy_has_gl_extension("GL_KHR_debug") && (flags & GL_CONTEXT_FLAG_DEBUG_BIT) != 0;
    if (hasMessages_) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(receive, this);
    }
}

GlErrorCount::~GlErrorCount() {
    if (hasMessages_) {
        void* receiver = nullptr;
        glGetPointerv(GL_DEBUG_CALLBACK_USER_PARAM, &receiver);
        if (receiver == this) glDebugMessageCallback(nullptr, nullptr);
    }
}

void GlErrorCount::poll() {
    // A lost context reports errors without end.
    constexpr int max = 16;
    for (int i = 0; i < max && glGetError() != GL_NO_ERROR; ++i)
        if (!hasMessages_) ++count_;
}

}  // namespace drench::viewer
