#pragma once

#include "session/recording.hpp"
#include "session/session.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace steplab {

/// Computes a recording again: takes the leading run of a session to the step of each event and has the event handled
/// there.
///
///     const Recording recording = read_session_file("a.session");
///     Session session(recording.start);
///     for (Replay replay(recording, session); !replay.is_done();) {
///         replay.approach(1000);
///         if (!replay.is_due()) continue;
///         if (const auto difference = replay.perform()) return *difference;
///     }
class Replay {
public:
    /// `session` is at the recording's start, and lives longer than this object.
    Replay(Recording recording, Session& session);

    /// The number of events that were handled.
    std::size_t handled() const { return std::min(next_, recording_.events.size()); }
    /// Forward steps so far of the leading run, and about how many there are in all.
    std::uint64_t steps() const { return steps_; }
    std::uint64_t all_steps() const;
    /// The part of them that lies behind the present moment.
    double done() const;
    /// Seconds for which the session had stood still before the next event.
    double pause() const { return next_ < recording_.events.size() ? recording_.events[next_].pause : 0; }
    /// True if a hash was compared.
    bool compared() const { return compared_; }

    /// All events are handled, and the end is reached if the recording has one.
    bool is_done() const;
    /// The leading run stands where the next event, or the end, is to be handled, or can get no nearer.
    bool is_due() const;
    /// Steps from where the leading run stands to there; 0 where it lies behind.
    std::uint64_t ahead() const;
    /// Goes back to it or takes up to so many steps towards it. Throws Interrupted.
    void approach(std::uint64_t most);
    /// Handles it. Returns what is not as it was recorded, in a sentence. Throws Interrupted.
    std::optional<std::string> perform();

private:
    std::uint64_t next_step() const;
    std::uint64_t steps_to(std::size_t events) const;
    bool next_diverged() const;
    std::string place() const;
    std::optional<std::string> check_place();
    std::optional<std::string> handle(const RecordedEvent& entry);
    std::optional<std::string> check_end();
    std::optional<std::string> compare(const std::string& recorded, const std::string& now, std::string_view of);

    Recording recording_;
    Session& session_;
    std::size_t next_ = 0;  ///< event; behind the last one comes the end
    std::uint64_t steps_ = 0;
    bool compared_ = false;
};

}  // namespace steplab
