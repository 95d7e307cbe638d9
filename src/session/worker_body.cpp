#include "session/worker_body.hpp"

#include "core/interruption.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

/// Computing time between two polls of the commands: short enough for a change to take effect at once.
constexpr Pace::Duration slice{0.008};
/// A view that was not taken is replaced by a newer one after this time.
constexpr Pace::Duration stale{0.05};

}  // namespace

void Worker::Body::loop() {
    const InterruptibleBy asked(stopping);
    while (true) {
        wait_for_work();
        {
            const std::lock_guard lock(mutex);
            if (stopping) return;
        }
        bool to_show = carry_out_commands();
        const std::uint64_t before = simulation.advanced().step;
        const bool doubted = doubtful, behind = !doubted && ensemble_is_behind();
        if (behind) bring_ensemble(slice);
        const bool well = went_well([this] { doubtful ? step_to_check() : take_steps(); });
        if (!well) give_up();
        if (doubtful || doubt) tell_doubt();
        if (doubtful) continue;
        to_show = to_show || doubted || !well;
        const auto [step, evaluations, diverged] = simulation.advanced();
        if (to_show || ((behind || step != before || diverged) && affordable())) publish(to_show, well);
    }
}

void Worker::Body::wait_for_work() {
    std::unique_lock lock(mutex);
    if (doubtful || goal || ensemble_is_behind()) return;
    const auto called = [this] { return stopping || !commands.empty() || wanted; };
    if (!playing) return changed.wait(lock, called);
    const auto now = Clock::now(), due = pace.next_due(now, rate, simulation.dt());
    if (due > now) changed.wait_until(lock, due, called);  // what is over at once would still ask the system
}

bool Worker::Body::carry_out_commands() {
    std::deque<std::function<void(Body&)>> taken;
    std::optional<RunDescription> description;
    {
        const std::lock_guard lock(mutex);
        taken.swap(commands);
        description = std::exchange(wanted, std::nullopt);
    }
    if (taken.empty() && !description) return false;
    error.clear();
    doubtful = false;  // of what was before
    went_well([&] {
        if (playing && simulation.divergence()) playing = false;  // before a command begins something new
        if (description) apply(*description);
        for (const auto& command : taken) command(*this);
    });
    return true;
}

/// The ensemble follows the run, which may take longer where it begins: then the run waits for it.
void Worker::Body::bring_ensemble(Pace::Duration most) {
    const auto begin = Clock::now();
    const auto enough = [&] { return Clock::now() - begin > most; };
    if (!went_well([&] { live_ensemble->go_to(simulation.step(), segments, enough); })) show_ensemble({});
    pace.begin(Clock::now());
}

/// Of the run and its ensemble, so that they stay together. Whether all numbers are finite is checked when they are
/// read: after every few steps it would take a large scene as long as some of them.
void Worker::Body::take_steps() {
    if ((!playing && !goal) || ensemble_is_behind()) return;
    const auto begin = Clock::now();
    const Rate wanted_rate = goal ? Rate{.as_fast_as_possible = true} : rate;
    std::uint64_t due = pace.steps_due(begin, wanted_rate, simulation.dt(), slice);
    if (goal) due = std::min(due, *goal - std::min(*goal, simulation.step()));
    if (due == 0) return goal.reset();
    const auto before = simulation.advanced();
    simulation.advance(due);
    if (live_ensemble && simulation.step() > before.step) live_ensemble->go_to(simulation.step(), segments);
    const auto after = simulation.advanced();
    const std::uint64_t taken = std::max(after.step, before.step) - before.step;
    pace.took(taken, std::max(after.evaluations, before.evaluations) - before.evaluations,
              static_cast<double>(taken) * simulation.dt(), begin, Clock::now(), wanted_rate);
    keep_moment();
    if (simulation.advanced().diverged) playing = false, goal.reset();
    if (goal && simulation.step() >= *goal) goal.reset(), pace.begin(Clock::now());
}

/// To the next check of the energy without regard to the pace, but no longer at a time than commands may wait.
void Worker::Body::step_to_check() {
    const auto begin = Clock::now();
    std::uint64_t left = simulation.divergence() ? 0 : simulation.steps_to_check();
    for (; left > 0 && Clock::now() - begin < slice; --left) simulation.advance(1);
    doubtful = left > 0 && !simulation.advanced().diverged;
    pace.begin(Clock::now());
}

/// That the picture stands still, and why; or that it no longer does.
void Worker::Body::tell_doubt() {
    std::optional<Doubt> told = doubtful ? found : std::nullopt;
    if (told) told->now = simulation.advanced().step;
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
    history.offer(simulation);
    moments.took(begin, Clock::now());
}

/// True if a view would cost the run no more than its part, or the run has time to spare.
bool Worker::Body::affordable() const {
    const auto now = Clock::now();
    return (!playing && !goal) || views.due(now) || (!goal && pace.next_due(now, rate, simulation.dt()) > now);
}

/// Makes `view` one of the present moment.
void Worker::Body::see() {
    observe(simulation, tracked, view);
    if (with_forces) simulation.forces(view.frame.forces);
    if (view.divergence) playing = false;
    view.playing = playing;
    view.goal = goal;
    view.ensemble = ensemble;
    view.ensemble_spread = {.step = live_ensemble ? live_ensemble->step() : 0};
    if (live_ensemble && !ensemble_is_behind()) view.ensemble_spread = live_ensemble->observe(view.frame);
    view.can_step_back = history.reaches_before(simulation.step());
    view.rate = rate;
    view.run = run;
    view.error = error;
    view.failures = failures;
    view.steps_per_second = pace.steps_per_second();
    view.evaluations_per_second = pace.evaluations_per_second();
}

/// Hands over a view of the present moment, unless the last one is still waiting and has not grown stale. A moment
/// whose energy is impossible is not shown, if it is to be `judged`: whether the run diverged is decided first.
void Worker::Body::publish(bool at_once, bool judged) {
    const auto begin = Clock::now();
    {
        const std::lock_guard lock(mutex);
        if (!at_once && (playing || goal) && fresh && begin - published < stale) return;
    }
    const bool seen = went_well([this] { see(); });
    if (!seen) give_up();
    doubtful = judged && seen && !view.divergence && !simulation.is_plausible();
    if (doubtful) {
        const std::uint64_t step = simulation.step();
        found = {step, simulation.time(), step, step + simulation.steps_to_check()};
        return;
    }
    void (*call)() = nullptr;
    {
        const std::lock_guard lock(mutex);
        if (seen) {
            std::swap(view, ready);
        } else {
            tell_in(ready);
        }
        fresh = ready.frame.shape != nullptr;
        call = wake;
    }
    published = Clock::now();
    views.took(begin, published);
    if (call) call();
}

/// After something went wrong that is no fault of a command, as a rule because there is no memory left.
void Worker::Body::give_up() {
    playing = doubtful = false;
    goal.reset();
    show_ensemble({});
}

/// In an older view: what went wrong since.
void Worker::Body::tell_in(RunView& older) const {
    older.error = error;
    older.failures = failures;
    older.playing = playing;
    older.ensemble = ensemble;
    older.frame.ensemble.clear();
}

/// The ensemble begins where the run began.
void Worker::Body::show_ensemble(LiveEnsembleOptions asked) {
    ensemble = std::move(asked);
    live_ensemble.reset();
    if (ensemble.runs == 0) return;
    live_ensemble.emplace(ensemble.runs, [of = ensemble](const RunDescription& description, std::size_t member) {
        return run_in_range(description, ranges_of(of, description), member, of.runs);
    });
}

void Worker::Body::apply(const RunDescription& description) {
    const bool at_start = simulation.step() == 0;
    const Change change = simulation.change(description);
    if (change == Change::none) return;
    goal.reset();
    pace.forget_speed();
    if (change == Change::restarted || at_start) {
        begin_anew();
    } else {
        segments.push_back({simulation.step(), description});
        history.offer(simulation);
    }
    pace.begin(Clock::now());
}

void Worker::Body::begin_anew() {
    ++run;
    history.clear();
    history.offer(simulation);
    segments = {{0, simulation.description()}};
    show_ensemble(ensemble);
}

void Worker::Body::step_back() {
    playing = false;
    goal.reset();
    if (simulation.step() == 0) return;
    history.go_back(simulation, simulation.step() - 1);
    if (segments.back().step <= simulation.step()) return;
    while (segments.back().step > simulation.step()) segments.pop_back();
    show_ensemble(ensemble);
}

void Worker::Body::pull(std::size_t particle, Vec3 position) {
    const std::uint64_t segment = simulation.segment();
    simulation.pull(particle, position);
    if (simulation.segment() == segment) return;
    goal.reset();
    append_pull(segments, {simulation.step(), simulation.description(), SegmentBegin::Pull{particle, position}});
    history.offer(simulation);
}

void Worker::Body::play(bool on) {
    playing = on && !simulation.divergence();
    goal.reset();
    pace.begin(Clock::now());
}

}  // namespace steplab
