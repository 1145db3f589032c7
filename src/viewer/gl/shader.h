#pragma once
#include <epoxy/gl.h>
#include <rayscope/vector.h>
#include <map>
#include <string>

namespace rayscope::viewer {

/// A vertex and a fragment shader, linked. `name` picks shaders/NAME.vert and shaders/NAME.frag, which are
/// compiled into the program. Throws std::runtime_error with the driver's message if they do not compile.
class Shader {
  public:
    explicit Shader(const std::string& name);
    ~Shader();
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    void use() const { glUseProgram(program_); }

    /// Uniforms of the program in use; names that the compiler optimised away are ignored.
    void set(const char* name, int value) { glUniform1i(location(name), value); }
    void set(const char* name, float value) { glUniform1f(location(name), value); }
    void set(const char* name, glm::vec2 v) { glUniform2f(location(name), v.x, v.y); }
    void set(const char* name, glm::vec3 v) { glUniform3f(location(name), v.x, v.y, v.z); }
    void set(const char* name, const glm::mat4& m) {
        glUniformMatrix4fv(location(name), 1, GL_FALSE, &m[0][0]);
    }
    void set(const char* name, const glm::mat3& m) {
        glUniformMatrix3fv(location(name), 1, GL_FALSE, &m[0][0]);
    }
    void set(const char* name, const glm::vec3* values, int count) {
        glUniform3fv(location(name), count, &values[0].x);
    }

  private:
    GLint location(const char* name);

    GLuint program_ = 0;
    std::map<std::string, GLint, std::less<>> locations_;
};

}  // namespace rayscope::viewer
