#pragma once

#include "ui/context.hpp"

namespace steplab::ui {

/// With Ctrl, arrows pull the selected particle in the plane of the view, with Shift too by larger steps; the hold ends
/// with Ctrl. True where an arrow did.
bool use_pull_keys(const Context& context);

}  // namespace steplab::ui
