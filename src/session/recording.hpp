#pragma once

#include "session/event.hpp"
#include "sim/run/run_description.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// True if an event goes to a step or time, on the way to which others may come.
bool is_seek(const Event& event);

/// An event and where the leading run was when it was handled.
struct RecordedEvent {
    Event event;
    std::uint64_t step = 0;  ///< at which the leading run stood before it
    bool diverged = false;   ///< the leading run had ended there
    /// Of the leading run after it (Simulation::hash()), but before a seek, which ends where the next event finds the
    /// run; empty if it was not computed.
    std::string hash = {};
    double pause = 0;  ///< for which the session had stood still before it [s]
};

/// Where all runs were when the recording was taken.
struct RecordedEnd {
    std::uint64_t step = 0;
    bool diverged = false;
    std::vector<std::string> hashes = {};  ///< of the leading run, then of those beside it if they had caught up
};

/// A session as data, from which it can be computed again: its start and what happened.
struct Recording {
    /// No more are kept: an hour of dragging. What comes later is missing (`complete`).
    static constexpr std::size_t most_events = 100'000;

    RunDescription start;
    std::vector<RecordedEvent> events = {};
    std::optional<RecordedEnd> end = {};
    bool complete = true;

    /// Adds an event. Where it leaves nothing of the last one it takes that one's place, unless the run has diverged: a
    /// particle or the speed that is dragged while the run stands, and, if `nothing_new`, the time line: the session
    /// stood, and was at no step since then that it had not been at before.
    void add(RecordedEvent next, bool nothing_new);
};

}  // namespace steplab
