#pragma once

#include "ui/context.hpp"

#include <string>

namespace steplab::ui {

/// The command line that opens a window with what this one shows: scene, moment, camera, style, ensemble, speed and
/// size, whatever is remembered by then. Options at their defaults are left out, but method and dt are always named.
std::string window_command(const Context& context);

/// False if the run was changed or a particle pulled after its start: window_command() then opens the start of the
/// scene as it is now.
bool command_repeats_run(const Context& context);

}  // namespace steplab::ui
