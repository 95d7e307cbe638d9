#pragma once

#include "render/gl.hpp"

#include <cstddef>
#include <span>
#include <utility>

namespace steplab::render {

/// Owner of one OpenGL object, which is created and destroyed while its context is current. Movable, not copyable.
template <class Kind>
class GlObject {
public:
    GlObject() : id_(Kind::create()) {}
    ~GlObject() {
        if (id_ != 0) Kind::destroy(id_);
    }
    GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    GLuint id() const { return id_; }

private:
    GLuint id_;
};

/// How each kind of object is created and destroyed.
struct BufferKind {
    static GLuint create();
    static void destroy(GLuint id);
};
struct VertexArrayKind {
    static GLuint create();
    static void destroy(GLuint id);
};
struct TextureKind {
    static GLuint create();
    static void destroy(GLuint id);
};
struct FramebufferKind {
    static GLuint create();
    static void destroy(GLuint id);
};
struct RenderbufferKind {
    static GLuint create();
    static void destroy(GLuint id);
};

using Buffer = GlObject<BufferKind>;
using VertexArray = GlObject<VertexArrayKind>;
using Texture = GlObject<TextureKind>;
using Framebuffer = GlObject<FramebufferKind>;
using Renderbuffer = GlObject<RenderbufferKind>;

/// Binds `buffer` to `target` and replaces its content by `data`, for use by the next draw.
template <class T>
void upload(const Buffer& buffer, GLenum target, std::span<const T> data) {
    glBindBuffer(target, buffer.id());
    glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STREAM_DRAW);
}

/// An offset in a bound buffer in the form that OpenGL expects.
const void* byte_offset(std::size_t offset);
/// Defines an attribute of the buffer bound to GL_ARRAY_BUFFER: `components` floats at `offset` bytes of each item.
void float_attribute(GLuint location, int components, std::size_t stride, std::size_t offset);
/// Defines an attribute of four bytes, read as numbers from 0 to 1.
void colour_attribute(GLuint location, std::size_t stride, std::size_t offset);
/// Draws vertices of the bound vertex array as points.
void draw_bound_points(std::size_t first, std::size_t count);
/// Makes the attribute advance per instance instead of per vertex.
void per_instance(GLuint location);

}  // namespace steplab::render
