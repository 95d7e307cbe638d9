#pragma once

#include <GL/glew.h>

namespace steplab::render {

/// Loads the functions of OpenGL for the current context, once per process and module.
/// Throws GraphicsError if there is no OpenGL 3.3.
void load_opengl();

}  // namespace steplab::render
