#pragma once

#include <GL/glew.h>

namespace steplab::render {

/// Loads OpenGL's functions for the current context, once per process and module; called after the context was made.
/// Throws GraphicsError if there is no OpenGL 3.3.
void load_opengl();

}  // namespace steplab::render
