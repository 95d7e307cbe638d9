#pragma once

#include "ui/context.hpp"
#include "ui/keys.hpp"

#include <string>

namespace steplab::ui {

/// Performs the action of a key or a button.
void perform(const Context& context, Action action);
/// Performs the actions whose keys were pressed in this frame, unless ImGui itself uses the keyboard.
void perform_pressed_keys(const Context& context);

/// Opens a scene of the page of scenes, unless it is the one that is shown.
void open_exhibit(const Context& context, const Exhibit& exhibit);
/// Asks the program to read a scene file, or a shipped scene by its name.
void open_file(const Context& context, const std::string& name);

/// Opens the page of scenes, or at the list of lessons.
void open_scenes_page(const Context& context, bool lessons = false);

/// Closes the lesson that is open. The plots and the speed that it chose give way to those before.
void close_lesson(const Context& context);

/// A run begins at the moment of a trajectory that is shown, in its place.
void continue_from_here(const Context& context);

/// The tooltip of a button: "one step forward (Right)".
std::string help_of(Action action);

/// Where the camera is when the scene opens: where its file says, else as suits the scene.
render::Camera home_camera(const Context& context);
/// Draws displacements from the rest positions so many times as large.
void magnify(const Context& context, double displacements);
/// Moves the camera there.
void reset_view(const Context& context);

}  // namespace steplab::ui
