#include "app/cli/session_option.hpp"

#include "app/cli/command_line.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/output_file.hpp"
#include "session/session_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace steplab {

void SessionOption::declare(CLI::App& app) {
    text_option(app, "--session", file_, "FILE",
                "Record what happens into this new file; a session file that is there is played", "Window");
}

GivenSession SessionOption::session(const SceneOptions& scene) const {
    std::error_code error;
    if (file_.empty() || written_directly(file_) || !std::filesystem::exists(file_, error)) return {.record_to = file_};
    if (scene.any_given())
        throw UsageError(
            fmt::format("'{}' is there: its session has a scene of its own. To record another one, give "
                        "the name of a new file",
                        shown(file_)));
    return {.film = read_session_file(file_)};
}

}  // namespace steplab
