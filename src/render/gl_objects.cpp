#include "render/gl_objects.hpp"

#include <algorithm>

namespace steplab::render {

const void* byte_offset(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr): OpenGL wants it so
}

GLuint BufferKind::create() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
}
void BufferKind::destroy(GLuint id) { glDeleteBuffers(1, &id); }

GLuint VertexArrayKind::create() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
}
void VertexArrayKind::destroy(GLuint id) { glDeleteVertexArrays(1, &id); }

GLuint TextureKind::create() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
}
void TextureKind::destroy(GLuint id) { glDeleteTextures(1, &id); }

GLuint FramebufferKind::create() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
}
void FramebufferKind::destroy(GLuint id) { glDeleteFramebuffers(1, &id); }

GLuint RenderbufferKind::create() {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return id;
}
void RenderbufferKind::destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }

void float_attribute(GLuint location, int components, std::size_t stride, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), byte_offset(offset));
}

void colour_attribute(GLuint location, std::size_t stride, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 4, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLsizei>(stride), byte_offset(offset));
}

void draw_bound_points(std::size_t first, std::size_t count) {
    // Each time its buffer is full, Mesa's software renderer goes over all vertices of the call: 32768 at once take a
    // fifth longer in a picture of 62 500 points.
    constexpr std::size_t most_at_once = 512;
    // So many are rasterised by its threads while this one prepares the next.
    constexpr std::size_t sent_at_once = 1 << 15;
    for (std::size_t begin = 0; begin < count; begin += most_at_once) {
        const std::size_t size = std::min(most_at_once, count - begin);
        glDrawArrays(GL_POINTS, static_cast<GLint>(first + begin), static_cast<GLsizei>(size));
        if ((begin + size) % sent_at_once == 0) glFlush();
    }
}

void per_instance(GLuint location) { glVertexAttribDivisor(location, 1); }

}  // namespace steplab::render
