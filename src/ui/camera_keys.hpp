#pragma once

#include "ui/context.hpp"

namespace steplab::ui {

/// With Alt, arrows turn the camera, with Shift too they move it, and = and - zoom. True while Alt is held: no key has
/// its other meaning then.
bool use_camera_keys(const Context& context);

}  // namespace steplab::ui
