#pragma once

struct GLFWwindow;

namespace steplab {

/// Gives a window the program's icon: three particles on a spring.
void set_icon(GLFWwindow* window);

}  // namespace steplab
