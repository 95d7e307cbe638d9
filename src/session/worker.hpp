#pragma once

#include "session/event.hpp"
#include "session/recording.hpp"
#include "session/session_view.hpp"

#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>

namespace steplab {

/// Takes events: the interface talks to this alone; tests put a recorder in its place.
class EventSink {
public:
    virtual ~EventSink() = default;
    virtual void send(const Event& event) = 0;
};

/// Owns a session on a thread of its own and plays it by the clock. Events are handled in the order in which they were
/// sent, those left out that the next one overtakes(). send() returns at once; results are taken when there are new
/// ones. What happens is recorded.
class Worker final : public EventSink {
public:
    /// Recorded events get a hash in scenes of no more particles than this (Session::record()).
    static constexpr std::size_t most_hashed = 100'000;

    explicit Worker(const RunDescription& description, std::size_t hashed = most_hashed);
    /// Plays a recording like a film while the session plays: its events happen at their steps. It ends where something
    /// else is done, or is found to differ from what was recorded, which is reported as an error.
    explicit Worker(Recording film, std::size_t hashed = most_hashed);
    ~Worker() override;

    void send(const Event& event) override;

    /// Swaps the newest view into `view` if there is one that was not taken yet; false if nothing is new. Never waits.
    bool take(SessionView& view);
    /// Why no new view comes, where steps take so long that the check of an impossible energy is some moments away.
    std::optional<Doubt> doubt() const;
    /// What happened so far, as soon as the step under way has been taken; without its end if the worker is destroyed
    /// before.
    std::future<Recording> recording();
    /// Called from the worker's thread when a new view or doubt is ready (to wake the window); set before the first
    /// event.
    void on_view(void (*wake)());

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab
