#pragma once

#include "app/cli/scene_options.hpp"
#include "session/lesson.hpp"
#include "session/recording.hpp"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace steplab {

/// What --session names, a session to be played or a file to be written; or the trajectory that --trajectory names, or
/// the lesson of --lesson.
struct GivenSession {
    std::optional<Recording> film = {};
    std::string record_to = {};                     ///< empty: nowhere
    std::string trajectory = {};                    ///< empty: none
    std::optional<RunDescription> played_run = {};  ///< that wrote the trajectory
    std::vector<std::string> columns = {};          ///< that its frames have besides
    std::size_t particles = 0;                      ///< of them, where the run does not say how many; else 0
    std::optional<Lesson> lesson = {};
    std::string name = {};  ///< of the file or lesson that is played, as it was given

    /// What it plays, with its name, for messages; empty if the scene options say what runs.
    std::string played() const;
    /// The run with which the window begins, if it is not that of the scene options.
    std::optional<RunDescription> start() const {
        if (lesson) return lesson->session->start;
        return film ? std::optional(film->start) : played_run;
    }
};

/// The options --session, --trajectory and --lesson of the window. A session file that is there is never overwritten:
/// it is played.
class SessionOption {
public:
    void declare(CLI::App& app);
    /// Throws FileError if the file is there and cannot be played, UsageError if one of `scene` is given beside it, or
    /// both.
    GivenSession session(const SceneOptions& scene) const;

private:
    GivenSession trajectory(const SceneOptions& scene) const;
    GivenSession lesson(const SceneOptions& scene) const;

    std::string file_;
    std::string trajectory_;
    std::string lesson_;
};

}  // namespace steplab
