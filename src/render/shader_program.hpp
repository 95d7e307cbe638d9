#pragma once

#include "render/gl_objects.hpp"
#include "render/shader_files.hpp"

#include <glm/fwd.hpp>

#include <span>
#include <string>

namespace steplab::render {

struct ProgramKind {
    static GLuint create();
    static void destroy(GLuint id);
};

/// A vertex and a fragment shader, compiled and linked.
class ShaderProgram {
public:
    /// Reads `name`.vert and `name`.frag. Throws GraphicsError that names a missing file, or with the message of the
    /// compiler, its file and line.
    explicit ShaderProgram(const std::string& name,
                           const std::vector<std::filesystem::path>& folders = shader_folders());
    ShaderProgram(const std::string& vertex_file, const std::string& fragment_file,
                  const std::vector<std::filesystem::path>& folders);

    /// Makes this the current program.
    void use() const;
    /// Sets a uniform of the current program. Unknown names are ignored, as the compiler removes unused uniforms.
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, const glm::vec2& value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::vec4& value) const;
    void set(const char* name, const glm::mat3& value) const;
    void set(const char* name, const glm::mat4& value) const;
    void set(const char* name, std::span<const glm::vec2> values) const;

private:
    GLint location(const char* name) const;

    GlObject<ProgramKind> program_;
};

}  // namespace steplab::render
