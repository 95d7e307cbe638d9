#pragma once

#include "session/session_view.hpp"

namespace steplab::ui {

/// True where the reference is so far behind the picture that its time has to be told: a text that came and went with
/// every step could not be read.
inline bool are_late(const SessionErrors& errors, const RunView& leading) {
    const double behind = leading.frame.time - errors.time;
    return behind > 20 * leading.dt && behind > 0.1 * leading.frame.time;
}

}  // namespace steplab::ui
