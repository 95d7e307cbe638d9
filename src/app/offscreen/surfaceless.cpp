#include "app/offscreen/context.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace steplab {
namespace {

[[noreturn]] void fail(const char* what) {
    throw GraphicsError(fmt::format("EGL {} (error {:#x})", what, static_cast<unsigned>(eglGetError())));
}

EGLDisplay open_display() {
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!platform_display) fail("has no platform displays");
    const EGLDisplay display = platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display == EGL_NO_DISPLAY) fail("has no surfaceless platform");
    if (!eglInitialize(display, nullptr, nullptr)) fail("cannot be initialised");
    return display;
}

EGLContext create_context(EGLDisplay display) {
    if (!eglBindAPI(EGL_OPENGL_API)) fail("does not support OpenGL");
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) fail("has no configuration for OpenGL");
    const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) fail("cannot create an OpenGL 3.3 core context");
    return context;
}

}  // namespace

OffscreenContext::OffscreenContext() {
    const EGLDisplay display = open_display();
    context_ = create_context(display);
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return;
    eglDestroyContext(display, context_);
    fail("cannot make a context current without a surface");
}

OffscreenContext::~OffscreenContext() {
    const EGLDisplay display = eglGetCurrentDisplay();
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context_);
}

}  // namespace steplab
