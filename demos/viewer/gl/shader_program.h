// Compiled and linked shaders.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "viewer/gl/gl_object.h"

namespace drench::viewer {

// A linked vertex and fragment shader. Its uniform blocks Frame and Sheet have the bindings 0 and 1; its
// samplers sunShadow, scene, sunDepth, sceneDepth, sunPassing, sheetLayers, wetness and sheetNodes have the
// texture units 0 to 7.
class ShaderProgram {
  public:
    // Joins each list of source pieces behind a #version 330 line. Throws std::runtime_error with the
    // driver's log and the program's name when they do not compile or link.
    ShaderProgram(const std::string& name, std::initializer_list<std::string_view> vertexPieces,
                  std::initializer_list<std::string_view> fragmentPieces);
    // A program of a vertex shader alone that draws nothing: transform feedback captures these outputs of it,
    // interleaved. Throws likewise.
    static ShaderProgram capturing(const std::string& name,
                                   std::initializer_list<std::string_view> vertexPieces,
                                   std::initializer_list<const char*> outputs);

    // Makes the following draw calls use this program.
    void use() const { glUseProgram(program_.name()); }

  private:
    ShaderProgram() = default;

    void link(const std::string& name, std::initializer_list<GLuint> shaders) const;
    void bindInputs() const;
    void bindBlock(const char* name, GLuint binding) const;

    GlObject<ProgramKind> program_;
};

}  // namespace drench::viewer
