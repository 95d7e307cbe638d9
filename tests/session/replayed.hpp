#pragma once

#include "session/replay.hpp"
#include "session/session.hpp"

#include <string>
#include <utility>

namespace steplab::test {

/// What a replay finds to differ; "the same" if nothing does.
inline std::string replayed(Recording recording) {
    Session session(recording.start);
    Replay replay(std::move(recording), session);
    while (!replay.is_done()) {
        replay.approach(37);
        if (!replay.is_due()) continue;
        if (const auto difference = replay.perform()) return *difference;
    }
    return replay.compared() ? "the same" : "nothing was compared";
}

}  // namespace steplab::test
