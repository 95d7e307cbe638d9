#include "sim/simulation.hpp"

#include "core/flush_subnormals.hpp"
#include "sim/divergence.hpp"
#include "sim/measures.hpp"
#include "sim/segment.hpp"

#include <algorithm>
#include <any>
#include <cmath>

namespace steplab {

namespace {

/// Steps between two checks of the energy, which is as costly as some evaluations.
constexpr std::uint64_t interval = 256;

/// Bytes of an internal state up to which a copy is kept to come back to. A larger one would cost memory that scenes of
/// millions of particles need for themselves: they step again from where their segment began.
constexpr std::size_t most_kept = std::size_t{4} << 20;

/// True if only what may change under way differs between the two.
bool continues(const RunDescription& from, const RunDescription& to) {
    if (from.model != to.model) return false;
    return std::all_of(from.scene.infos().begin(), from.scene.infos().end(), [&](const ParameterInfo& info) {
        return info.on_change == OnChange::applies_live || from.scene[info.name] == to.scene[info.name];
    });
}

/// Where a run is and what it is measured against; with the description and the internal state it is all of a run.
struct Course {
    std::uint64_t step = 0;
    std::uint64_t segment_number = 0;
    std::uint64_t segment_step = 0;  // step at which the segment began
    double segment_time = 0;
    std::uint64_t evaluations_before = 0;  // of the segments before
    Energy baseline;
    std::uint64_t baseline_step = 0;
    /// What the motion is to be by its exact solution, if it has one: none once the scene was changed under way.
    std::optional<ParameterValues> exact_scene;
};

}  // namespace

struct Simulation::Snapshot::Content {
    RunDescription description;
    Start start;  ///< of the segment
    Course course;
    std::any internal;
    std::size_t bytes;
};

struct Simulation::Body : Course {
    Segment segment;
    mutable std::shared_ptr<const Shape> shape;

    std::any kept;  // internal state at a step known to be good; none of large scenes
    std::uint64_t kept_step = 0;
    std::optional<Divergence> divergence;

    Body(const RunDescription& description, const Execution& execution) : segment(description, execution) {
        exact_scene = segment.held.scene;
        baseline = energy();
        keep();
    }

    double time_at(std::uint64_t at) const {
        return segment_time + static_cast<double>(at - segment_step) * segment.held.dt;
    }

    // What is read of the present step, when somebody asks for it.
    const State<double>& state() {
        const FlushSubnormals flush;
        if (!state_known) segment.stepper->synchronised(looked_at);
        state_known = true;
        return looked_at;
    }
    void look(const PortionSink& sink) {
        const FlushSubnormals flush;
        if (state_known) return sink({0, looked_at.velocity.count(), looked_at});
        segment.stepper->look(sink);
    }
    const Energy& energy() {
        const FlushSubnormals flush;
        if (!energy_known) measured = segment.meter.energy([this](const PortionSink& sink) { look(sink); });
        energy_known = true;
        return measured;
    }
    const ExactSolution* exact() {
        if (!exact_scene) return nullptr;
        if (!exact_known) solution = model(segment.held.model).exact(*exact_scene);
        exact_known = true;
        return solution.get();
    }
    void moved() { state_known = energy_known = settled = false; }

    bool energy_is_good() { return energy_is_possible(judged_energy(), baseline, segment.meter.floor()); }

    /// The velocities a curiosity shows may be wrong while its positions are right: they are left out.
    Energy judged_energy() {
        return {method(segment.held.method).info.curiosity ? 0 : energy().kinetic, energy().potential};
    }

    bool is_good() { return segment.stepper->finite() && energy_is_good(); }

    void keep() {
        if (segment.stepper->bytes() <= most_kept) {
            segment.stepper->save(kept);
        } else {
            kept.reset();
        }
        kept_step = step;
    }
    void go_back_to_kept();

    std::uint64_t steps_to_check() const { return interval - (step - segment_step) % interval; }

    void advance(std::uint64_t steps);
    void settle();
    void conclude();
    void take(std::uint64_t steps);
    void pull(std::size_t particle, Vec3 displacement);
    void go_back_to_last_good();
    void diverged();
    void go_on(const RunDescription& description, bool energy_changed);

private:
    State<double> looked_at;
    Energy measured;
    bool state_known = false, energy_known = false;  // of the present step
    bool settled = false;                            // its numbers are finite
    bool exact_known = false;
    std::shared_ptr<const ExactSolution> solution;
};

void Simulation::Body::take(std::uint64_t steps) {
    segment.stepper->advance(steps);
    step += steps;
    moved();
}

void Simulation::Body::advance(std::uint64_t steps) {
    const FlushSubnormals flush;
    while (!divergence && steps > 0) {
        const std::uint64_t taken = std::min(steps, steps_to_check());
        take(taken);
        steps -= taken;
        if (steps_to_check() != interval) continue;
        if (!is_good()) return go_back_to_last_good();
        settled = true;
        keep();
    }
}

/// Before anybody looks: what he sees is finite.
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
    const std::uint64_t good = step - 1;
    go_back_to_kept();
    take(good - kept_step);
    diverged();
}

void Simulation::Body::go_back_to_kept() {
    if (kept.has_value()) {
        segment.stepper->restore(kept);
        step = kept_step;
    } else {
        segment.restart();
        step = segment_step;
        take(kept_step - segment_step);
    }
}

void Simulation::Body::diverged() {
    divergence->step = step;
    divergence->time = time_at(step);
    explain(*divergence, segment.held, segment.limit());
    keep();
}

/// Begins a new segment at the synchronised state.
void Simulation::Body::go_on(const RunDescription& description, bool energy_changed) {
    const FlushSubnormals flush;
    Segment next(description, segment.execution, Start(State<double>(state())));
    evaluations_before += segment.stepper->evaluations();
    segment_time = time_at(step);
    segment_step = step;
    segment = std::move(next);
    ++segment_number;
    divergence.reset();
    moved();
    if (energy_changed) {
        baseline = energy();
        baseline_step = step;
        exact_scene.reset();
    }
    keep();
}

/// The particle stops at this displacement; a new segment begins.
void Simulation::Body::pull(std::size_t particle, Vec3 displacement) {
    state();
    looked_at.displacement.set(particle, displacement);
    looked_at.velocity.set(particle, {});
    go_on(RunDescription(segment.description), true);
}

Simulation::Simulation(const RunDescription& description, const Execution& execution)
    : body_(std::make_unique<Body>(description, execution)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Simulation::Body& Simulation::settled() const {
    body_->settle();
    return *body_;
}

const RunDescription& Simulation::description() const { return body_->segment.description; }
std::uint64_t Simulation::step() const { return settled().step; }
double Simulation::time() const { return settled().time_at(settled().step); }
double Simulation::dt() const { return body_->segment.held.dt; }
std::size_t Simulation::particles() const { return body_->segment.scene.reference.count; }
std::uint64_t Simulation::segment() const { return body_->segment_number; }
double Simulation::segment_start() const { return body_->segment_time; }
std::uint64_t Simulation::baseline_step() const { return body_->baseline_step; }
bool Simulation::has_exact() const { return body_->exact() != nullptr; }
const std::optional<StabilityLimit>& Simulation::limit() const { return body_->segment.limit(); }
const std::optional<Divergence>& Simulation::divergence() const { return settled().divergence; }

std::uint64_t Simulation::evaluations() const {
    return settled().evaluations_before + body_->segment.stepper->evaluations();
}

CollisionRecord Simulation::collisions() const { return settled().segment.stepper->collisions(); }

void Simulation::advance(std::uint64_t steps) { body_->advance(steps); }
void Simulation::conclude() { body_->conclude(); }
std::uint64_t Simulation::check_interval() const { return interval; }

Frame Simulation::frame() const {
    Frame out;
    frame(out);
    return out;
}

void Simulation::frame(Frame& out) const {
    const Lattice& reference = body_->segment.scene.reference;
    const State<double>& state = this->state();
    const Precision precision = body_->segment.held.precision;
    out.step = step();
    out.time = time();
    out.precision = precision;
    out.shape = shape();
    out.positions.resize(particles());
    out.velocities.resize(particles());
    for (std::size_t i = 0; i < particles(); ++i) {
        const Vec3 position = reference.at(i) + state.displacement.at(i);
        out.positions[i] = {rounded_to(precision, position.x), rounded_to(precision, position.y),
                            rounded_to(precision, position.z)};
        out.velocities[i] = state.velocity.at(i);
    }
}

std::shared_ptr<const Shape> Simulation::shape() const {
    if (!body_->shape) {
        const RunDescription& held = body_->segment.held;
        body_->shape = std::make_shared<const Shape>(model(held.model).shape(held.scene));
    }
    return body_->shape;
}

std::string Simulation::hash() const {
    Body& body = settled();
    return hash_of(body.step, body.segment.held.precision, [&](const PortionSink& sink) { body.look(sink); });
}

const State<double>& Simulation::state() const { return settled().state(); }

Diagnostics Simulation::diagnostics() const {
    Body& body = settled();
    Diagnostics sums = sums_over_particles(body.state(), body.segment.scene, *shape());
    sums.kinetic = body.energy().kinetic;
    sums.potential = body.energy().potential.value;
    sums.energy = body.energy().total();
    sums.energy_error = sums.energy - body.baseline.total();
    if (has_exact() && time() <= body.exact()->valid_until())
        sums.error = largest_error(body.state().displacement, *body.exact(), time());
    return sums;
}

double Simulation::energy() const { return settled().energy().total(); }
double Simulation::energy_error() const { return energy() - body_->baseline.total(); }

std::optional<Vec3> Simulation::exact_position(std::size_t particle, double time) const {
    const ExactSolution* const exact = body_->exact();
    if (!exact || time > exact->valid_until()) return std::nullopt;
    return body_->segment.scene.reference.at(particle) + exact->displacement(particle, time);
}

Change Simulation::change(const RunDescription& description) {
    const RunDescription& now = body_->segment.description;
    if (description == now) return Change::none;
    if (!continues(now, description) || step() == 0) {
        const Change change = continues(now, description) ? Change::continued : Change::restarted;
        const std::uint64_t number = body_->segment_number;
        body_ = std::make_unique<Body>(description, body_->segment.execution);
        body_->segment_number = number + 1;
        return change;
    }
    body_->go_on(description, !(description.scene == now.scene));
    return Change::continued;
}

void Simulation::pull(std::size_t particle, Vec3 position) {
    if (particle >= particles() || shape()->roles[particle] == Role::fixed) return;
    body_->pull(particle, position - body_->segment.scene.reference.at(particle));
}

void Simulation::restart() {
    const std::uint64_t number = body_->segment_number;
    body_ = std::make_unique<Body>(RunDescription(description()), Execution(body_->segment.execution));
    body_->segment_number = number + 1;
}

std::uint64_t Simulation::Snapshot::step() const { return content_->course.step; }
std::uint64_t Simulation::Snapshot::segment() const { return content_->course.segment_number; }
std::size_t Simulation::Snapshot::bytes() const { return content_->bytes; }

Simulation::Snapshot Simulation::save() const {
    const Stepper& stepper = *settled().segment.stepper;
    const Course& course = *body_;
    std::any internal;
    stepper.save(internal);
    Snapshot snapshot;
    snapshot.content_ = std::make_shared<const Snapshot::Content>(
        Snapshot::Content{description(), body_->segment.scene.start, course, std::move(internal), stepper.bytes()});
    return snapshot;
}

void Simulation::restore(const Snapshot& snapshot) {
    const FlushSubnormals flush;
    const Snapshot::Content& content = *snapshot.content_;
    if (content.course.segment_number != segment())
        body_->segment = Segment(content.description, Execution(body_->segment.execution), content.start);
    static_cast<Course&>(*body_) = content.course;
    body_->segment.stepper->restore(content.internal);
    body_->divergence.reset();
    body_->moved();
    body_->keep();
}

}  // namespace steplab
