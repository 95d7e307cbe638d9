#pragma once

#include "app/cli/scene_options.hpp"
#include "session/recording.hpp"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace steplab {

/// What --session names, a session to be played or a file to be written; or the trajectory that --trajectory names.
struct GivenSession {
    std::optional<Recording> film = {};
    std::string record_to = {};                     ///< empty: nowhere
    std::string trajectory = {};                    ///< empty: none
    std::optional<RunDescription> played_run = {};  ///< that wrote the trajectory

    /// The run with which the window begins, if it is not that of the scene options.
    std::optional<RunDescription> start() const { return film ? std::optional(film->start) : played_run; }
};

/// The options --session and --trajectory of the window. A session file that is there is never overwritten: it is
/// played.
class SessionOption {
public:
    void declare(CLI::App& app);
    /// Throws FileError if the file is there and cannot be played, UsageError if one of `scene` is given beside it, or
    /// both.
    GivenSession session(const SceneOptions& scene) const;

private:
    GivenSession trajectory(const SceneOptions& scene) const;

    std::string file_;
    std::string trajectory_;
};

}  // namespace steplab
