#include "sim/run/simulation_body.hpp"

#include "core/flush_subnormals.hpp"
#include "core/interruption.hpp"
#include "sim/run/divergence.hpp"
#include "sim/run/starting.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace steplab {

namespace {

/// Bytes of an internal state up to which a copy is kept to come back to. A larger one would cost memory that scenes of
/// millions of particles need for themselves: they step again from where their segment began.
constexpr std::size_t most_kept = std::size_t{4} << 20;

}  // namespace

Simulation::Body::Body(const RunDescription& description, const Execution& execution)
    : segment(description, execution) {
    motion = std::make_shared<const MotionFromStart>(segment.held);
    baseline = energy();
    keep();
}

const State<double>& Simulation::Body::state() {
    const FlushSubnormals flush;
    if (!state_known) segment.stepper->synchronised(observed_state);
    state_known = true;
    return observed_state;
}

void Simulation::Body::emit(const PortionSink& sink) {
    const FlushSubnormals flush;
    if (state_known) return sink({0, observed_state.velocity.count(), observed_state});
    segment.stepper->emit(sink);
}

const Energy& Simulation::Body::energy() {
    if (!energy_known) measure(nullptr, nullptr);
    return measured;
}

void Simulation::Body::measure(const PortionSink& portions, const PieceSink& pieces) {
    const FlushSubnormals flush;
    const Stepper& stepper = *segment.stepper;
    const auto emit = [&](const PortionSink& sink) {
        const PortionSink both = [&](const Portion& portion) {
            if (portions) portions(portion);
            sink(portion);
        };
        if (state_known) return both({0, stepper.particles(), observed_state});
        stepper.emit_parallel(both);
    };
    measured = segment.meter.energy(state_known ? 1 : stepper.parts(), emit, pieces);
    energy_known = true;
}

/// The velocities a curiosity shows may be wrong while its positions are right: they are left out.
bool Simulation::Body::energy_is_good() {
    const double kinetic = method(segment.held.method).info.curiosity ? 0 : energy().kinetic;
    return energy_is_possible({kinetic, energy().potential}, baseline, segment.meter.floor(segment.held.dt));
}

void Simulation::Body::keep() {
    if (segment.stepper->bytes() <= most_kept) {
        segment.stepper->save(kept);
    } else {
        kept.reset();
    }
    kept_step = step;
    kept_drag_work = drag_work;
}

void Simulation::Body::take(std::uint64_t steps) {
    if (drag) return take_counting(steps);
    segment.stepper->advance(steps);
    step += steps;
    moved();
}

/// One by one, each with the work of drag in it.
void Simulation::Body::take_counting(std::uint64_t steps) {
    for (std::uint64_t i = 0; i < steps; ++i) {
        drag_work->add(drag->of_step(state()));
        segment.stepper->advance(1);
        ++step;
        moved();
    }
}

/// What drag has taken since the baseline.
std::optional<double> Simulation::Body::drag_taken() {
    if (!drag_work) return std::nullopt;
    const FlushSubnormals flush;
    if (!counted) counted = segment.stepper->drag_work();
    return drag_work->value() + *counted;
}

bool Simulation::Body::count_drag_work() {
    if (!integrates_drag_work(segment.held)) return false;
    drag_work.emplace();
    segment_begun();
    // a method may stand within a step of its own
    if (drag_taken()) drag_work->add(-*counted);
    kept_drag_work = drag_work;
    return true;
}

void Simulation::Body::segment_begun() {
    if (drag_work && !keeps_drag_work(segment.held)) drag_work.reset();
    segment_drag_work = drag_work;
    prepare_drag();
}

/// For the segment's method and dt.
void Simulation::Body::prepare_drag() {
    drag.reset();
    counted.reset();
    const Method& how = method(segment.held.method);
    segment.stepper->count_drag_work(drag_work && how.counts_drag ? drag_coefficients(segment.scene)
                                                                  : std::vector<double>());
    if (drag_work && !how.counts_drag) drag.emplace(segment.scene, how.parts, segment.held.dt);
}

void Simulation::Body::advance(std::uint64_t steps) {
    const FlushSubnormals flush;
    while (!divergence && steps > 0) {
        check_interruption();
        if (steps_to_shortened() == 0) {
            shorten_last_step();
            continue;
        }
        const std::uint64_t taken = std::min({steps, steps_to_check(), steps_to_shortened(), segment.steps_at_once});
        take(taken);
        steps -= taken;
        if (steps_to_check() != steps_between_checks) continue;
        if (!is_good()) return go_back_to_last_good();
        settled = true;
        keep();
    }
}

/// Before anything is read: all numbers are finite.
void Simulation::Body::settle() {
    if (settled || divergence) return;
    const FlushSubnormals flush;
    if (!segment.stepper->finite()) return go_back_to_last_good();
    settled = true;
}

void Simulation::Body::conclude() {
    const FlushSubnormals flush;
    settle();
    if (!divergence && !energy_is_good()) go_back_to_last_good();
}

/// Steps again from the kept state to find the first bad step, and once more to stand at the step before it.
void Simulation::Body::go_back_to_last_good() {
    go_back_to_kept();
    do take(1);
    while (is_good());
    divergence.emplace();
    divergence->particle = wildest_particle(state());
    divergence->stop = segment.stepper->stopped();
    const std::uint64_t good = step - 1;
    if (divergence->stop) divergence->stop->time += chooses_its_steps(segment.held) ? segment_time : time_at(good);
    go_back_to_kept();
    take(good - kept_step);
    diverged();
}

void Simulation::Body::go_back_to_kept() {
    if (kept.has_value()) {
        segment.stepper->restore(kept);
        step = kept_step;
        drag_work = kept_drag_work;
        moved();
    } else {
        segment.restart();
        step = segment_step;
        drag_work = segment_drag_work;
        prepare_drag();
        moved();
        take(kept_step - segment_step);
    }
}

void Simulation::Body::diverged() {
    divergence->step = step;
    divergence->time = time_at(step);
    explain(*divergence, segment.held, segment.limit(), energy().total());
    keep();
}

/// Begins a new segment at the synchronised state.
void Simulation::Body::go_on(const RunDescription& description, const GoingOn& how) {
    const FlushSubnormals flush;
    State<double> begin(state());
    const bool altered = description.alterations != segment.description.alterations;
    if (altered) carry_over(segment.scene, plan_of(as_held(description)), begin);
    Segment next(description, segment.execution, Start(std::move(begin)), how.dt);
    if (altered) shape.reset();
    leave_segment();
    segment = std::move(next);
    const bool still_known = how.another_motion && step == 0 && motion;
    begin_segment(how, still_known ? motion->in(segment.held) : nullptr);
}

void Simulation::Body::leave_segment() {
    if (drag_taken()) drag_work->add(*counted);
    evaluations_before += segment.stepper->evaluations();
    segment_time = time_at(step);
    segment_step = step;
}

/// `other`: what the motion is to be now, if that is another one.
void Simulation::Body::begin_segment(const GoingOn& how, std::shared_ptr<const MotionFromStart> other) {
    segment_number = ++newest_segment;
    segment_identity = std::make_shared<const int>();
    divergence.reset();
    moved();
    if (how.another_motion) motion = std::move(other);
    if (how.new_baseline) {
        baseline = energy();
        baseline_step = step;
        if (drag_work) drag_work.emplace();
    }
    segment_begun();
    keep();
}

/// The last step ends at the time asked for, in a segment of its own.
void Simulation::Body::shorten_last_step() {
    settle();
    if (divergence) return;
    go_on(RunDescription(segment.description), {.dt = *end->time - time_at(step)});
    shortened = true;
}

/// A new segment begins, of the same description: what is known of the scene need not be made again.
void Simulation::Body::act(const Act& act) {
    const FlushSubnormals flush;
    State<double> begin(state());
    apply(act, segment.scene.reference, begin);
    leave_segment();
    segment.begin_at(std::move(begin));
    begin_segment({.new_baseline = does_work(act), .another_motion = true},
                  step == 0 && motion ? motion->after(act) : nullptr);
}

}  // namespace steplab
