#pragma once

namespace steplab {

/// An OpenGL 3.3 core context without a display, current on the thread that created it; its functions are not loaded
/// yet. Each off-screen module implements it in its own way; the window has that of EGL.
class OffscreenContext {
public:
    /// Throws GraphicsError that names the failed step.
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

private:
    void* context_ = nullptr;
};

}  // namespace steplab
