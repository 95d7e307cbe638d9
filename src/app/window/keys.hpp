#pragma once

#include "ui/keys.hpp"

namespace steplab {

/// The key of the interface for a key of GLFW. Letters and signs follow the user's keyboard layout; signs without a key
/// of their own there follow the US layout.
ui::Key key_of(int glfw_key, int scancode);

}  // namespace steplab
