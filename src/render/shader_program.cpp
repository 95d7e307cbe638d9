#include "render/shader_program.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

namespace steplab::render {
namespace {

struct VertexShaderKind {
    static GLuint create() { return glCreateShader(GL_VERTEX_SHADER); }
    static void destroy(GLuint id) { glDeleteShader(id); }
};
struct FragmentShaderKind {
    static GLuint create() { return glCreateShader(GL_FRAGMENT_SHADER); }
    static void destroy(GLuint id) { glDeleteShader(id); }
};

std::string shader_log(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

std::string program_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

void compile(GLuint shader, const ShaderSource& source) {
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == GL_TRUE) return;
    throw GraphicsError(fmt::format("the shader {} does not compile:\n{}", source.files.front(),
                                    named_log(shader_log(shader), source.files)));
}

}  // namespace

GLuint ProgramKind::create() { return glCreateProgram(); }
void ProgramKind::destroy(GLuint id) { glDeleteProgram(id); }

ShaderProgram::ShaderProgram(const std::string& name, const std::vector<std::filesystem::path>& folders)
    : ShaderProgram(name + ".vert", name + ".frag", folders) {}

ShaderProgram::ShaderProgram(const std::string& vertex_file, const std::string& fragment_file,
                             const std::vector<std::filesystem::path>& folders) {
    const GlObject<VertexShaderKind> vertex;
    const GlObject<FragmentShaderKind> fragment;
    compile(vertex.id(), read_shader(vertex_file, folders));
    compile(fragment.id(), read_shader(fragment_file, folders));
    glAttachShader(program_.id(), vertex.id());
    glAttachShader(program_.id(), fragment.id());
    glLinkProgram(program_.id());
    GLint done = GL_FALSE;
    glGetProgramiv(program_.id(), GL_LINK_STATUS, &done);
    if (done == GL_TRUE) return;
    throw GraphicsError(
        fmt::format("cannot link the shaders {} and {}:\n{}", vertex_file, fragment_file, program_log(program_.id())));
}

GLint ShaderProgram::location(const char* name) const { return glGetUniformLocation(program_.id(), name); }

void ShaderProgram::use() const { glUseProgram(program_.id()); }

void ShaderProgram::set(const char* name, int value) const { glUniform1i(location(name), value); }
void ShaderProgram::set(const char* name, float value) const { glUniform1f(location(name), value); }
void ShaderProgram::set(const char* name, const glm::vec2& value) const {
    glUniform2fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::vec3& value) const {
    glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::vec4& value) const {
    glUniform4fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::mat3& value) const {
    glUniformMatrix3fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::mat4& value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, std::span<const glm::vec2> values) const {
    if (!values.empty()) glUniform2fv(location(name), static_cast<GLsizei>(values.size()), glm::value_ptr(values[0]));
}

}  // namespace steplab::render
