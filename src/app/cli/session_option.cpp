#include "app/cli/session_option.hpp"

#include "app/cli/command_line.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/output_file.hpp"
#include "session/playback.hpp"
#include "session/session_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

namespace steplab {

void SessionOption::declare(CLI::App& app) {
    text_option(app, "--session", file_, "FILE",
                "Record what happens into this new file; a session file that is there is played", "Window");
    text_option(app, "--trajectory", trajectory_, "FILE",
                "Play the frames of a trajectory, CSV, extended XYZ or LAMMPS dump", "Window");
    text_option(app, "--lesson", lesson_, "NAME|FILE", "Open a guided experiment (`steplab list lessons`)", "Window");
}

std::string GivenSession::played() const {
    if (!trajectory.empty()) return fmt::format("the trajectory '{}'", shown(name));
    if (film) return fmt::format("the session '{}'", shown(name));
    return lesson ? fmt::format("the lesson '{}'", shown(name)) : "";
}

GivenSession SessionOption::session(const SceneOptions& scene) const {
    if (!lesson_.empty()) return lesson(scene);
    if (!trajectory_.empty()) return trajectory(scene);
    std::error_code error;
    if (file_.empty() || written_directly(file_) || !std::filesystem::exists(file_, error)) return {.record_to = file_};
    if (scene.any_given())
        throw UsageError(
            fmt::format("'{}' is there: its session has a scene of its own. To record another one, give "
                        "the name of a new file",
                        shown(file_)));
    return {.film = read_session_file(file_), .name = file_};
}

GivenSession SessionOption::lesson(const SceneOptions& scene) const {
    if (!file_.empty() || !trajectory_.empty())
        throw UsageError("--lesson opens a session of its own: it goes with neither --session nor --trajectory");
    if (scene.any_given())
        throw UsageError(
            fmt::format("the lesson '{}' has a scene of its own: no options of a scene go with it", shown(lesson_)));
    return {.lesson = find_lesson(lesson_), .name = lesson_};
}

GivenSession SessionOption::trajectory(const SceneOptions& scene) const {
    if (!file_.empty()) throw UsageError("--trajectory plays a file: nothing happens that --session could record");
    if (scene.any_given())
        throw UsageError(
            fmt::format("the frames of '{}' are played: the scene is that of its run", shown(trajectory_)));
    PlayedStart start = played_start(trajectory_);
    return {.trajectory = trajectory_,
            .played_run = std::move(start.run),
            .columns = std::move(start.columns),
            .particles = start.particles,
            .name = trajectory_};
}

}  // namespace steplab
