#pragma once

#include "core/problem_text.hpp"
#include "session/film_gate.hpp"
#include "session/live_costs.hpp"
#include "session/live_errors.hpp"
#include "session/live_verdict.hpp"
#include "session/pace.hpp"
#include "session/playback.hpp"
#include "session/replay.hpp"
#include "session/session.hpp"
#include "session/share.hpp"
#include "session/worker.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace steplab {

/// The worker's thread and what it works with.
struct Worker::Body {
    using Clock = std::chrono::steady_clock;

    /// Of the time of a run that has none to spare: for views, and for moments to come back to.
    static constexpr double part_for_views = 0.02, part_for_history = 0.01;
    /// But a picture that moves less often than this is of no use to who watches.
    static constexpr std::chrono::milliseconds longest_without_view{500};
    /// Computing time of samples that are taken late between two polls of the events, and how often they are shown.
    static constexpr Pace::Duration late_slice{0.004}, between_late_views{0.2};
    /// An event of a film is seen before the next one comes.
    static constexpr std::chrono::milliseconds between_film_events{40};
    /// A shorter pause is not recorded, and a longer one is cut in a film.
    static constexpr Pace::Duration shortest_pause{0.1}, longest_pause{5};

    // shared between the threads
    std::mutex mutex;
    std::condition_variable changed;
    std::optional<Beginning> next;  // in place of what is played; before these
    std::deque<Event> events;
    std::optional<FilmPart> next_part;           // of a film, after these
    std::vector<std::promise<Recording>> asked;  // for what happened so far
    std::atomic<bool> stopping = false;          // also in the middle of a long step
    bool fresh = false;                          // `ready` has not been taken yet
    bool compared = false;                       // there are errors that no view has
    SessionView ready;
    std::optional<double> gate_asked;  // a film is to begin with this spacing, or to end: 0
    std::uint64_t frames_ready = 0, frames_taken = 0, frames_done = 0;  // of the film: of `ready`, taken, safe
    std::optional<Doubt> doubt;                                         // told while `doubtful` lasts
    void (*wake)() = nullptr;

    // the worker's own
    std::unique_ptr<Session> session;  // one of these two
    std::unique_ptr<Playback> playback;
    Pace pace;
    std::optional<Replay> film;    // until it has ended
    std::optional<FilmPart> part;  // of the film that is played; none: all of it
    bool film_plays = false;
    std::optional<FilmGate> gate;  // of the film that is taken
    bool frame_came = false;       // of it, and has not been shown yet
    Clock::time_point film_due{};  // its next event, if the run is there
    bool film_arrived = false;     // the run is there, and its pause has begun
    Clock::time_point moved{};     // when something was done last, or the run went on
    bool errors_alone = false;     // nothing but errors has come since the last view
    bool doubtful = false;         // the energy is impossible, and the check that decides about it has not come yet
    std::optional<Doubt> found;    // where `doubtful` began
    std::size_t hashed;
    std::uint64_t runs_before = 0, newest_run = 0;  // runs have other numbers than those of what was played before
    std::array<Event, 7> kept_events{event::SetRate{},         event::Track{},   event::AlsoTrack{},
                                     event::ShowForces{false}, event::Magnify{}, event::ShowSamples{false},
                                     event::ShowCosts{false}};  // what stays from then
    /// The wall clock of frames that are played: when it showed so many seconds behind the first one.
    struct Since {
        Clock::time_point now{};
        double elapsed = 0;
    };
    Since frames_since;
    std::string error;
    std::uint64_t failures = 0;
    SessionView view;
    Clock::time_point published;
    Share views{part_for_views, longest_without_view}, moments{part_for_history};
    LiveErrors errors{[this] { errors_came(); }};
    LiveCosts costs{[this] { errors_came(); }};
    LiveVerdict verdict{[this] { errors_came(); }};
    std::thread thread;

    Body(const Beginning& beginning, std::size_t up_to) : hashed(up_to) {
        begin(beginning);
        see();
        std::swap(view, ready);
        fresh = true;
        thread = std::thread([this] { loop(); });
    }

    /// An error is reported in the next view, and the thread continues: true if there was none.
    template <class Work>
    bool went_well(const Work& work) {
        try {
            work();
            return true;
        } catch (const std::exception& problem) {
            error = problem_text(problem);
            ++failures;
            return false;
        }
    }

    bool under_way() const {
        return playback ? playback->playing() : session->playing() || session->goal().has_value();
    }
    void begin(const Beginning& beginning);
    void begin_in_place(const Beginning& beginning);
    bool begin_next();
    void loop();
    void take_turn();
    void wait_for_work();
    bool handle_events();
    void handle(const Event& event);
    void answer(bool with_end);
    bool begin_part();
    void play_part(const FilmPart& next_one);
    void note_pause();
    bool follows_film(const FilmPart& next_one) const;
    bool hastens() const;
    Rate wanted_rate() const;
    bool answer_film();
    bool show_film();
    void pause_film();
    void continue_film(const event::Play& play);
    void forget_film();
    void end_film();
    std::uint64_t play_film(std::uint64_t due);
    void take_steps();
    void step_to_check();
    void judge();
    /// With the mutex held: there is something to do at once.
    bool called() const {
        return stopping || next || next_part || !events.empty() || !asked.empty() || compared || gate_asked;
    }
    /// With the mutex held: the film waits for a frame to be safe.
    bool gate_waits() const { return gate && gate->waits() && frames_done < gate->frames(); }
    void wait_for_frame(std::unique_lock<std::mutex>& lock);
    Clock::time_point next_frame_due() const;
    void play_frame(Clock::time_point now);
    bool sample_frames();
    void play_frames(bool to_show);
    void tell_doubt();
    void catch_up(Pace::Duration most);
    bool lacks_samples() const;
    bool complete_samples();
    void keep_moment();
    void compare();
    void errors_came();
    void scan_costs();
    void judge_steps();
    bool affordable() const;
    void see();
    void publish(bool at_once, bool judged);
    void hand_over(bool seen);
    void give_up();
    void tell_in(SessionView& older) const;
};

}  // namespace steplab
