#include "viewer/gl/shader_program.h"

#include <stdexcept>
#include <vector>

namespace drench::viewer {

namespace {

std::runtime_error shaderError(const std::string& name, const std::string& step,
                               const std::vector<char>& log) {
    return std::runtime_error("viewer: the graphics driver does not " + step + " the shader '" + name +
                              "'; update the driver, or report this log: " + log.data());
}

std::string joined(std::initializer_list<std::string_view> pieces) {
    std::string source = "#version 330 core\n";
    for (const std::string_view piece : pieces) source += piece;
    return source;
}

void compile(GLuint shader, const std::string& name, const std::string& source) {
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        std::vector<char> log(4096, '\0');
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()) - 1, nullptr, log.data());
        throw shaderError(name, "compile", log);
    }
}

}  // namespace

ShaderProgram::ShaderProgram(const std::string& name, std::initializer_list<std::string_view> vertexPieces,
                             std::initializer_list<std::string_view> fragmentPieces) {
    const GlObject<ShaderKind<GL_VERTEX_SHADER>> vertexShader;
    const GlObject<ShaderKind<GL_FRAGMENT_SHADER>> fragmentShader;
    compile(vertexShader.name(), name, joined(vertexPieces));
    compile(fragmentShader.name(), name, joined(fragmentPieces));
    link(name, {vertexShader.name(), fragmentShader.name()});
}

ShaderProgram ShaderProgram::capturing(const std::string& name,
                                       std::initializer_list<std::string_view> vertexPieces,
                                       std::initializer_list<const char*> outputs) {
    const GlObject<ShaderKind<GL_VERTEX_SHADER>> vertexShader;
    compile(vertexShader.name(), name, joined(vertexPieces));
    ShaderProgram result;
    glTransformFeedbackVaryings(result.program_.name(), static_cast<GLsizei>(outputs.size()), outputs.begin(),
                                GL_INTERLEAVED_ATTRIBS);
    result.link(name, {vertexShader.name()});
    return result;
}

void ShaderProgram::link(const std::string& name, std::initializer_list<GLuint> shaders) const {
    for (const GLuint shader : shaders) glAttachShader(program_.name(), shader);
    glLinkProgram(program_.name());
    for (const GLuint shader : shaders) glDetachShader(program_.name(), shader);
    GLint linked = GL_FALSE;
    glGetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        std::vector<char> log(4096, '\0');
        glGetProgramInfoLog(program_.name(), static_cast<GLsizei>(log.size()) - 1, nullptr, log.data());
        throw shaderError(name, "link", log);
    }
    bindInputs();
}

void ShaderProgram::bindInputs() const {
    use();
    bindBlock("Frame", 0);
    bindBlock("Sheet", 1);
    glUniform1i(glGetUniformLocation(program_.name(), "sunShadow"), 0);
    glUniform1i(glGetUniformLocation(program_.name(), "scene"), 1);
    glUniform1i(glGetUniformLocation(program_.name(), "sunDepth"), 2);
    glUniform1i(glGetUniformLocation(program_.name(), "sceneDepth"), 3);
    glUniform1i(glGetUniformLocation(program_.name(), "sunPassing"), 4);
    glUniform1i(glGetUniformLocation(program_.name(), "sheetLayers"), 5);
    glUniform1i(glGetUniformLocation(program_.name(), "wetness"), 6);
    glUniform1i(glGetUniformLocation(program_.name(), "sheetNodes"), 7);
    glUseProgram(0);
}

void ShaderProgram::bindBlock(const char* name, GLuint binding) const {
    const GLuint block = glGetUniformBlockIndex(program_.name(), name);
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(program_.name(), block, binding);
}

}  // namespace drench::viewer
