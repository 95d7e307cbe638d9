// The caption of a picture as plain data, for programs that draw nothing themselves.
#pragma once

#include <string>

namespace steplab::ui {

/// The text of a caption: that which is given; or, if it is empty, scene and time, and of each run method, dt and
/// precision.
struct Caption {
    std::string text = {};
};

}  // namespace steplab::ui
