// A count of the OpenGL errors of a context.
#pragma once

#include <epoxy/gl.h>

#include <atomic>

namespace drench::viewer {

// Counts errors through the driver's debug messages if supported; otherwise asks after each frame.
class GlErrorCount {
  public:
    // Needs a current context; of several on one context the newest receives the driver's messages.
    GlErrorCount();
    ~GlErrorCount();
    GlErrorCount(const GlErrorCount&) = delete;
    GlErrorCount& operator=(const GlErrorCount&) = delete;

    // Asks the driver for errors that it has not reported yet.
    void poll();
    // Errors since construction.
    int count() const { return count_; }

  private:
    static void receive(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                        const GLchar* message, const void* self);

    bool hasMessages_ = false;
    std::atomic<int> count_{0};
};

}  // namespace drench::viewer
