#pragma once

namespace steplab {

/// An OpenGL 3.3 core context without a display, current on the thread that made it, its functions not yet loaded.
/// Each off-screen module has its own kind.
class OffscreenContext {
public:
    /// Throws GraphicsError with the step that failed.
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

private:
    void* context_ = nullptr;
};

}  // namespace steplab
