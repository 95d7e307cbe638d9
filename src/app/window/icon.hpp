#pragma once

struct GLFWwindow;

namespace steplab {

/// Sets the icon of a window: three particles connected by springs.
void set_icon(GLFWwindow* window);

}  // namespace steplab
