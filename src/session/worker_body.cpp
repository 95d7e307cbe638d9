#include "session/worker_body.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab {

namespace {

/// Computing time between two polls of the events: short enough for a change to take effect at once.
constexpr Pace::Duration slice{0.008};
/// A view that was not taken is replaced by a newer one after this time.
constexpr Pace::Duration stale{0.05};
/// Where not even an error can be handled, the next attempt comes after this time.
constexpr Pace::Duration without_memory{0.05};

/// True if a step takes another time after it.
bool changes_speed(const Event& event) {
    return is_any<event::Change, event::ChangeRun, event::AddRun, event::RemoveRun, event::EqualCost, event::Lead,
                  event::Undo, event::Redo, event::TakeBranch, event::ShowEnsemble>(event);
}

}  // namespace

void Worker::Body::loop() {
    const InterruptibleBy interruptible(stopping);
    while (true) {
        wait_for_work();
        {
            const std::lock_guard lock(mutex);
            if (stopping) break;
        }
        if (went_well([this] { take_turn(); })) continue;
        // outside of what is told by itself, as a rule because there is no memory for a word about it
        went_well([this] { give_up(); });
        hand_over(false);
        std::unique_lock lock(mutex);
        changed.wait_for(lock, without_memory, [this] { return stopping.load(); });
    }
    answer(false);  // the step under way may have been given up
}

/// What has come since, and some steps.
void Worker::Body::take_turn() {
    answer(true);
    const bool begun = begin_next();
    const bool happened = handle_events();
    bool to_show = begin_part() || happened || begun;
    to_show = answer_film() || to_show;
    if (playback) return play_frames(to_show);
    if (film && film_plays && !doubtful) to_show = show_film() || to_show;
    const std::uint64_t before = session->run().advanced().step;
    const bool doubted = doubtful, behind = !doubted && session->is_behind();
    if (behind) catch_up(slice);
    const bool well = went_well([this] { doubtful ? step_to_check() : take_steps(); });
    if (!well) give_up();
    if (doubtful || doubt) tell_doubt();
    if (doubtful) return;
    to_show = std::exchange(frame_came, false) || complete_samples() || to_show;
    to_show = to_show || doubted || !well;
    const auto [step, evaluations, diverged] = session->run().advanced();
    if (step != before) moved = Clock::now();
    if (to_show || ((behind || step != before || diverged) && affordable())) publish(to_show, well);
}

/// Those who asked what happened.
void Worker::Body::answer(bool with_end) {
    std::vector<std::promise<Recording>> waiting;
    {
        const std::lock_guard lock(mutex);
        waiting.swap(asked);
    }
    for (std::promise<Recording>& promise : waiting) {
        try {
            if (!session) throw UsageError("a trajectory is played back: nothing is recorded that could be saved");
            promise.set_value(session->recorded(with_end).value());
        } catch (const std::exception&) {
            promise.set_exception(std::current_exception());
        }
    }
}

void Worker::Body::wait_for_work() {
    std::unique_lock lock(mutex);
    if (playback) return wait_for_frame(lock);
    if (doubtful || session->goal() || session->is_behind()) return;
    if (gate_waits()) return changed.wait(lock, [this] { return called() || !gate_waits(); });
    const bool film_waits = film && film_plays && film->is_due();
    if (lacks_samples()) return;
    if (!session->playing() && !film_waits) return changed.wait(lock, [this] { return called(); });
    const auto now = Clock::now();
    const auto due = film_waits ? film_due : pace.next_due(now, wanted_rate(), session->run().dt());
    if (due > now)
        changed.wait_until(lock, due, [this] { return called(); });  // what is over at once would still ask the system
}

bool Worker::Body::handle_events() {
    std::deque<Event> taken;
    bool came = false;
    {
        const std::lock_guard lock(mutex);
        taken.swap(events);
        came = std::exchange(compared, false);
    }
    errors_alone = came && taken.empty() && !under_way();
    if (taken.empty()) return errors_alone;
    if (!std::all_of(taken.begin(), taken.end(), is_any<event::AlsoTrack>)) {
        error.clear();
        doubtful = false;  // of what was before
    }
    for (const Event& event : taken) went_well([&] { handle(event); });
    return true;
}

void Worker::Body::handle(const Event& event) {
    for (Event& each : kept_events) {
        if (each.index() == event.index()) each = event;
    }
    const bool looks_on = is_any<event::AlsoTrack>(event);  // nothing is done by a person
    if (playback) {
        playback->handle(event);
        if (!looks_on) frames_since = {Clock::now(), playback->elapsed()};
        return;
    }
    if (session->playing() && !session->plays_backwards() && session->run().divergence())
        session->stop();  // before it begins something new
    if (const auto* const play = std::get_if<event::Play>(&event); play && !play->on) {
        pause_film();
    } else if (play) {
        continue_film(*play);
    } else if (changes_runs(event)) {
        forget_film();
    }
    if (!looks_on) note_pause();
    session->handle(event);
    if (is_any<event::Track, event::AlsoTrack, event::ShowForces, event::Magnify, event::ShowSamples, event::ShowCosts,
               event::Bookmark>(event))
        return;
    if (changes_speed(event)) pace.forget_speed();
    pace.begin(Clock::now());
}

/// Of a session that stands, before an event.
void Worker::Body::note_pause() {
    const auto now = Clock::now();
    const Pace::Duration pause = now - moved;
    session->stood_still(!under_way() && pause > shortest_pause ? pause.count() : 0);
    moved = now;
}

/// What goes beside the run follows it, which may take longer where it begins: then the run waits for it.
void Worker::Body::catch_up(Pace::Duration most) {
    const auto begin = Clock::now();
    went_well([&] { session->catch_up([&] { return Clock::now() - begin > most; }); });
    pace.begin(Clock::now());
}

/// True if there are samples to be taken late, and time that nothing else needs.
bool Worker::Body::lacks_samples() const {
    if (!session->lacks_samples() || session->goal() || session->is_behind() || gate) return false;
    const auto now = Clock::now();
    return !session->playing() || pace.next_due(now, wanted_rate(), session->run().dt()) > now;
}

/// Some of those; true if they are to be shown.
bool Worker::Body::complete_samples() {
    if (!lacks_samples()) return false;
    const auto begin = Clock::now();
    const bool found = session->complete_samples([&] { return Clock::now() - begin > late_slice; });
    return found && (!session->lacks_samples() || begin - published > between_late_views);
}

/// Of all runs, so that they stay together. Whether all numbers are finite is checked when they are read: after every
/// few steps it would take a large scene as long as some of them.
void Worker::Body::take_steps() {
    const bool filmed = gate && !session->goal();
    if (!under_way() || session->is_behind() || (filmed && gate->waits())) return;
    const auto begin = Clock::now();
    const Simulation& run = session->run();
    const Rate rate = wanted_rate();
    std::uint64_t due = pace.steps_due(begin, rate, run.dt(), slice);
    if (const auto goal = session->goal()) due = std::min(due, *goal - std::min(*goal, run.step()));
    const double dt = std::abs(run.dt());
    if (filmed && due > 0) due = std::min(due, gate->steps_to_frame(dt));
    const auto before = run.advanced();
    const std::uint64_t taken = film ? play_film(due) : session->play_on(due);
    if (run.step() != before.step) session->catch_up([] { return false; });
    const auto after = run.advanced();
    pace.took(taken, std::max(after.evaluations, before.evaluations) - before.evaluations,
              static_cast<double>(taken) * run.dt(), begin, Clock::now(), rate);
    frame_came = filmed && gate->played(taken, dt);
    keep_moment();
    if (!session->goal() && rate.as_fast_as_possible) pace.begin(Clock::now());
}

/// To the next check of the energy without regard to the pace, but no longer at a time than events may wait.
void Worker::Body::step_to_check() {
    const auto begin = Clock::now();
    std::uint64_t left = session->run().divergence() ? 0 : session->run().steps_to_check();
    for (; left > 0 && Clock::now() - begin < slice; --left) session->advance(1);
    doubtful = left > 0 && !session->run().advanced().diverged;
    pace.begin(Clock::now());
}

/// That the picture stands still, and why; or that it no longer does.
void Worker::Body::tell_doubt() {
    std::optional<Doubt> told = doubtful ? found : std::nullopt;
    if (told) told->now = session->run().advanced().step;
    void (*call)() = nullptr;
    {
        const std::lock_guard lock(mutex);
        doubt = told;
        call = wake;
    }
    if (call && told) call();
}

/// Something to come back to; in a large scene that is a copy as costly as some steps.
void Worker::Body::keep_moment() {
    const auto begin = Clock::now();
    if (!moments.due(begin)) return;
    session->keep_moment();
    moments.took(begin, Clock::now());
}

/// True if a view would cost the run no more than its part, or the run has time to spare.
bool Worker::Body::affordable() const {
    const auto now = Clock::now();
    const bool spare = !session->goal() && pace.next_due(now, session->rate(), session->run().dt()) > now;
    return !under_way() || views.due(now) || spare;
}

/// Hands over a view of the present moment, unless the last one is still waiting and has not grown stale. A moment
/// whose energy is impossible is not shown, if it is to be `judged`: whether the run diverged is decided first.
void Worker::Body::publish(bool at_once, bool judged) {
    const auto begin = Clock::now();
    {
        const std::lock_guard lock(mutex);
        if (!at_once && under_way() && fresh && begin - published < stale) return;
    }
    const bool seen = went_well([this] { see(); });
    if (!seen) give_up();
    if (judged && seen) judge();
    if (doubtful) return;
    hand_over(seen);
    published = Clock::now();
    views.took(begin, published);
}

/// The view of now, or in an older one that there is none.
void Worker::Body::hand_over(bool seen) {
    void (*call)() = nullptr;
    {
        const std::lock_guard lock(mutex);
        if (seen) {
            std::swap(view, ready);
        } else {
            tell_in(ready);
        }
        fresh = ready.leading.frame.shape != nullptr;
        frames_ready = gate && !gate_asked ? gate->frames() : 0;
        call = wake;
    }
    if (call) call();
}

/// Of the present moment of a run.
void Worker::Body::judge() {
    if (playback) return;
    const Simulation& run = session->run();
    doubtful = !view.leading.divergence && !run.is_plausible();
    if (!doubtful) return;
    const std::uint64_t step = run.step();
    found = {step, run.time(), step, step + run.steps_to_check()};
}

/// After something went wrong that is no fault of an event, as a rule because there is no memory left.
void Worker::Body::give_up() {
    doubtful = false;
    if (playback) return playback->stop();
    session->stop();
    session->give_up_ensemble();
}

/// In an older view: what went wrong since.
void Worker::Body::tell_in(SessionView& older) const {
    older.leading.error = copy_or_short(error.c_str());
    older.leading.failures = failures;
    older.leading.playing = session && session->playing();
    older.leading.ensemble = {};
    older.leading.frame.ensemble.clear();
}

}  // namespace steplab
