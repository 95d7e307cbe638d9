// Where a window keeps what a person chose about it.
#pragma once

#include "ui/view_choices.hpp"

#include <optional>
#include <string>

namespace steplab {

/// The file in which choices are remembered: `$XDG_CONFIG_HOME/steplab/view.toml`, or in `~/.config`. Empty where there
/// is no such folder to name, or where `config` says `none`; any other text names a file in its place.
std::string view_choices_path(const std::string& config);

/// What was read of such a file.
struct ReadViewChoices {
    ui::ViewChoices choices;             ///< the usual ones where it has none that can be used
    std::optional<std::string> problem;  ///< what could not be used, in one line
    bool newer = false;                  ///< it was written by a newer version, and is to stay as it is
};
/// No file and an empty path give the usual choices. Never throws for what the file holds.
ReadViewChoices read_view_choices(const std::string& path);

/// Writes what differs from when the window was opened into the file, which another window may have written meanwhile;
/// without a difference nothing. What could not be used is kept as `PATH.unreadable`. Throws FileError.
void remember_view_choices(const std::string& path, const ui::ViewChoices& opened, const ui::ViewChoices& now);

}  // namespace steplab
