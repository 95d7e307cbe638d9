#pragma once

#include <GL/glew.h>

namespace steplab::render {

/// Loads the functions of OpenGL for the current context, once per process and module.
/// Throws GraphicsError if there is no OpenGL 3.3.
void load_opengl();

/// True if contexts of the current one's driver may draw on several threads at the same time. Mesa's llvmpipe breaks
/// down sooner or later: for each texture that is used it looks through what all contexts are drawing, which they free
/// meanwhile (lp_setup_is_resource_referenced() of Mesa 22.3).
bool draws_on_several_threads();

}  // namespace steplab::render
