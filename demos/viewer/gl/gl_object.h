// Owners of OpenGL names. The context must be current at construction and destruction.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace drench::viewer {

// Owns one OpenGL name, created and deleted by `Kind`; movable, not copyable.
template <typename Kind>
class GlObject {
  public:
    GlObject() : name_(Kind::create()) {}
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;
    ~GlObject() {
        if (name_ != 0) Kind::destroy(name_);
    }
    // The name to pass to OpenGL.
    GLuint name() const { return name_; }

  private:
    GLuint name_;
};

// Names that OpenGL creates and deletes in groups.
template <auto& generate, auto& release>
struct ListedKind {
    static GLuint create() {
        GLuint name = 0;
        generate(1, &name);
        return name;
    }
    static void destroy(GLuint name) { release(1, &name); }
};

template <GLenum stage>
struct ShaderKind {
    static GLuint create() { return glCreateShader(stage); }
    static void destroy(GLuint name) { glDeleteShader(name); }
};

struct ProgramKind {
    static GLuint create() { return glCreateProgram(); }
    static void destroy(GLuint name) { glDeleteProgram(name); }
};

using Buffer = GlObject<ListedKind<glGenBuffers, glDeleteBuffers>>;
using VertexArray = GlObject<ListedKind<glGenVertexArrays, glDeleteVertexArrays>>;
using Texture = GlObject<ListedKind<glGenTextures, glDeleteTextures>>;
using Sampler = GlObject<ListedKind<glGenSamplers, glDeleteSamplers>>;
using Renderbuffer = GlObject<ListedKind<glGenRenderbuffers, glDeleteRenderbuffers>>;
using Framebuffer = GlObject<ListedKind<glGenFramebuffers, glDeleteFramebuffers>>;

// Size and format of a texture: arguments of glTexImage2D.
struct TextureFormat {
    int width, height;
    GLint texel;
    GLenum channels, type;
};

// Binds a texture, allocates it without contents, and sets its filtering.
inline void store(const Texture& texture, const TextureFormat& format, GLint minFilter, GLint magFilter,
                  GLint wrap, const void* values = nullptr) {
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, format.texel, format.width, format.height, 0, format.channels, format.type,
                 values);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minFilter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magFilter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
}

}  // namespace drench::viewer
