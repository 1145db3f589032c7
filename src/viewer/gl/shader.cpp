#include "viewer/gl/shader.h"

#include <fmt/format.h>

#include <stdexcept>

#include "embedded_shaders.h"

namespace rayscope::viewer {

namespace {

std::string_view embeddedSource(const std::string& name) {
    for (const auto& file : shaders::files())
        if (file.name == name) return file.content;
    throw std::runtime_error(fmt::format("no shader is called '{}'", name));
}

template <class GetLog>
std::string logOf(GLint length, GetLog&& getLog) {
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    getLog(length, log.data());
    return log;
}

GLuint compile(GLenum stage, const std::string& name) {
    const std::string_view source = embeddedSource(name);
    const GLuint shader = glCreateShader(stage);
    const char* text = source.data();
    const GLint length = static_cast<GLint>(source.size());
    glShaderSource(shader, 1, &text, &length);
    glCompileShader(shader);
    GLint compiled = 0, logLength = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &logLength);
    const std::string log = logOf(
        logLength, [&](GLint capacity, char* out) { glGetShaderInfoLog(shader, capacity, nullptr, out); });
    glDeleteShader(shader);
    throw std::runtime_error(fmt::format("shader {} does not compile:\n{}", name, log));
}

}  // namespace

Shader::Shader(const std::string& name) {
    const GLuint vertex = compile(GL_VERTEX_SHADER, name + ".vert");
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, name + ".frag");
    program_ = glCreateProgram();
    glAttachShader(program_, vertex);
    glAttachShader(program_, fragment);
    glLinkProgram(program_);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint linked = 0, logLength = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (linked) return;
    glGetProgramiv(program_, GL_INFO_LOG_LENGTH, &logLength);
    const std::string log = logOf(
        logLength, [&](GLint capacity, char* out) { glGetProgramInfoLog(program_, capacity, nullptr, out); });
    glDeleteProgram(program_);
    throw std::runtime_error(fmt::format("shader {} does not link:\n{}", name, log));
}

Shader::~Shader() { glDeleteProgram(program_); }

GLint Shader::location(const char* name) {
    const auto known = locations_.find(name);
    if (known != locations_.end()) return known->second;
    const GLint found = glGetUniformLocation(program_, name);
    locations_.emplace(name, found);
    return found;
}

}  // namespace rayscope::viewer
