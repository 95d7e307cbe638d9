#pragma once

#include "app/cli/scene_options.hpp"
#include "session/recording.hpp"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace steplab {

/// What --session names: a session to be played, or a file to be written.
struct GivenSession {
    std::optional<Recording> film = {};
    std::string record_to = {};  ///< empty: nowhere
};

/// The option --session of the window. A file that is there is never overwritten: it is played.
class SessionOption {
public:
    void declare(CLI::App& app);
    /// Throws FileError if the file is there and is no session, UsageError if one of `scene` is given beside it.
    GivenSession session(const SceneOptions& scene) const;

private:
    std::string file_;
};

}  // namespace steplab
