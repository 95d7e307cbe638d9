#pragma once

#include "session/event.hpp"
#include "session/recording.hpp"
#include "session/session_view.hpp"

#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace steplab {

/// Events of a recording that happen in the session which is played, at their steps while it plays, as those of a film:
/// the part of a lesson. It then pauses, and the part that begins where this one ends may follow; another one begins
/// from the start of the recording, alone, and hastens to where it begins.
struct FilmPart {
    std::shared_ptr<const Recording> recording = {};
    std::size_t from = 0, to = 0;  ///< how many events have happened where it begins and ends
    friend bool operator==(const FilmPart&, const FilmPart&) = default;
};

/// Takes events: the interface talks to this alone; tests put a recorder in its place.
class EventSink {
public:
    virtual ~EventSink() = default;
    virtual void send(const Event& event) = 0;
    /// In place of what is played, a session of a run begins.
    virtual void begin(const RunDescription& description) = 0;
    /// A part of a recording is played.
    virtual void play_part(const FilmPart& part) = 0;
};

/// A trajectory file that is played.
struct TrajectoryFile {
    std::string path;
};

/// What a worker plays: a session of a run; a recording like a film, whose events happen at their steps while it plays
/// until something else is done, or it is found to differ from what was recorded, which is reported as an error; or the
/// frames of a file.
using Beginning = std::variant<RunDescription, Recording, TrajectoryFile>;

/// Owns a session, or a playback, on a thread of its own and plays it by the clock. Events are handled in the order in
/// which they were sent, those left out that the next one overtakes(). send() returns at once; results are taken when
/// there are new ones. What happens in a session is recorded.
class Worker final : public EventSink {
public:
    /// Recorded events get a hash in scenes of no more particles than this (Session::record()).
    static constexpr std::size_t most_hashed = 100'000;

    /// Throws UsageError if the run cannot be computed, FileError if the trajectory cannot be read.
    explicit Worker(const Beginning& beginning, std::size_t hashed = most_hashed);
    ~Worker() override;

    void send(const Event& event) override;
    /// In place of what is played, as soon as that has taken the step under way; what was sent before and has not
    /// happened yet is left out, recordings asked for before are handed out. What cannot begin is reported as an error,
    /// nothing changed. Rate, tracked particle and forces stay as they are shown.
    void begin(Beginning beginning);
    void begin(const RunDescription& description) override { begin(Beginning(description)); }
    /// After the events that were sent. What the person does then ends it, as it does any film.
    void play_part(const FilmPart& part) override;

    /// Swaps the newest view into `view` if there is one that was not taken yet; false if nothing is new. Never waits.
    bool take(SessionView& view);
    /// Why no new view comes, where steps take so long that the check of an impossible energy is some moments away.
    std::optional<Doubt> doubt() const;
    /// What happened so far in the session, as soon as the step under way has been taken; without its end if the worker
    /// is destroyed before. Of a trajectory, get() throws UsageError.
    std::future<Recording> recording();
    /// From now on a film is taken of what is played, with a frame after each `spacing` seconds of simulated time (>
    /// 0); none: no longer. After a frame the session takes no step until film_goes_on(). Not of a trajectory.
    void film(std::optional<double> spacing);
    /// The frames of the film up to the view that was taken last, which shows the last one of them.
    std::uint64_t film_frames() const;
    /// So many frames are safe: the session may go on.
    void film_goes_on(std::uint64_t frames);
    /// Called from the worker's thread when a new view or doubt is ready (to wake the window); set before the first
    /// event.
    void on_view(void (*wake)());

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab
