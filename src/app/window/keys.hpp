#pragma once

#include "ui/keys.hpp"

namespace steplab {

/// The interface's key for one of GLFW. Letters and signs go by what is printed on the keyboard of the person; signs
/// that this keyboard has on no key of their own go by their place on an American one.
ui::Key key_of(int glfw_key, int scancode);

}  // namespace steplab
