#include "render/gl.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <string>

namespace steplab::render {
namespace {

// Not in every glew.h: the result of glewInit on Wayland after it has loaded everything.
constexpr GLenum no_glx_display = 4;

std::string text_of(GLenum name) {
    const auto* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "none";
}

}  // namespace

void load_opengl() {
    glewExperimental = GL_TRUE;
    const GLenum status = glewInit();
    const bool loaded = status == GLEW_OK || status == GLEW_ERROR_GLX_VERSION_11_ONLY || status == no_glx_display;
    if (!loaded) throw GraphicsError(fmt::format("cannot load OpenGL (GLEW error {})", status));
    if (!GLEW_VERSION_3_3) {
        throw GraphicsError(fmt::format("OpenGL 3.3 is required (this system has \"{}\")", text_of(GL_VERSION)));
    }
}

bool draws_on_several_threads() { return text_of(GL_RENDERER).find("llvmpipe") == std::string::npos; }

}  // namespace steplab::render
