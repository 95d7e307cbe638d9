// What a view of the worker shows beside the runs: their errors, what accuracy costs, how the steps stand to the scene.

#include "session/worker_body.hpp"

#include <utility>

namespace steplab {

namespace {

/// A view waits so long for its errors; where they take longer it has those of a moment before.
constexpr Pace::Duration patience{0.004};

}  // namespace

/// How far the runs are from the motion of their scene, where that is wanted: of this moment if it is known at once.
void Worker::Body::compare() {
    view.errors.reset();
    if (!session->wants_errors()) {
        view.error_series.clear();
        return errors.forget();
    }
    // a question asked again would be answered again, for ever
    if (!errors_alone) errors.ask(session->run().time(), shown_runs(*session));
    view.errors = errors.newest(errors_alone ? Pace::Duration(0) : patience);
    errors.put_into(view.error_series);
}

/// Called from the thread that compares: if nothing moves, a view is due for them.
void Worker::Body::errors_came() {
    {
        const std::lock_guard lock(mutex);
        compared = true;
    }
    changed.notify_one();
}

/// What accuracy costs on the scene, with its parameters of now, where that is wanted.
void Worker::Body::scan_costs() {
    if (!session->wants_costs()) {
        view.costs.reset();
        return costs.forget();
    }
    std::vector<RunDescription> runs{session->run().description()};
    for (const FollowerRun& follower : session->followers()) runs.push_back(follower.run().description());
    costs.ask(std::move(runs));
    view.costs = costs.newest();
}

/// How the steps stand to the scene as it is now, and why the run diverged.
void Worker::Body::judge_steps() {
    const Simulation& run = session->run();
    if (run.particles() <= PresentLimits::most_particles) {
        if (verdict.is_new(run)) verdict.ask({run.description(), run.step(), run.segment(), run.time(), run.state()});
        view.present = verdict.limit(patience);
    } else {
        view.present.reset();
    }
    if (const auto& divergence = view.leading.divergence) {
        verdict.ask_why(session->line(), *divergence);
        view.blow_up = verdict.blow_up();
    } else {
        verdict.forget_why();
        view.blow_up.reset();
    }
    const FastestOscillation* const fastest = view.blow_up   ? &view.blow_up->limit.oscillation
                                              : view.present ? &view.present->oscillation
                                                             : nullptr;
    view.leading.frame.oscillation = fastest ? fastest->shape : std::vector<Vec3>{};
}

/// Makes `view` one of the present moment.
void Worker::Body::see() {
    RunView& leading = view.leading;
    if (playback) {
        playback->observe(view);
        view.present.reset();
        view.blow_up.reset();
    } else {
        view.playback.reset();
        session->observe(view);
        compare();
        scan_costs();
        judge_steps();
        if (leading.divergence && !session->plays_backwards()) session->stop();
        leading.cost = session->line().cost();
        for (std::size_t i = 0; i < view.followers.size(); ++i)
            view.followers[i].cost = session->followers()[i].line().cost();
    }
    view.film.reset();
    if (film && !part) view.film = {film->done()};
    leading.run += runs_before;
    newest_run = leading.run;
    leading.error = error;
    leading.failures = failures;
    leading.steps_per_second = pace.steps_per_second();
    leading.evaluations_per_second = pace.evaluations_per_second();
}

}  // namespace steplab
