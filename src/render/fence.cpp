#include "render/fence.hpp"

#include "core/error.hpp"

namespace steplab::render {

void Fence::Deleter::operator()(GLsync sync) const { glDeleteSync(sync); }

Fence Fence::after_commands() {
    Fence fence;
    fence.sync_.reset(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
    glFlush();
    return fence;
}

void Fence::wait() const {
    constexpr GLuint64 nanoseconds = 1'000'000'000;
    GLenum result = sync_ ? GL_TIMEOUT_EXPIRED : GL_ALREADY_SIGNALED;
    while (result == GL_TIMEOUT_EXPIRED) result = glClientWaitSync(sync_.get(), 0, nanoseconds);
    if (result == GL_WAIT_FAILED) throw GraphicsError("OpenGL cannot wait for a picture to be finished");
}

void Fence::delay_commands() const {
    if (sync_) glWaitSync(sync_.get(), 0, GL_TIMEOUT_IGNORED);
}

}  // namespace steplab::render
