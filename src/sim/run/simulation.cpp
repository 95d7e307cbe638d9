#include "sim/run/simulation.hpp"

#include "core/flush_subnormals.hpp"
#include "core/number_text.hpp"
#include "sim/run/measures.hpp"
#include "sim/run/simulation_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab {

bool restarts(const RunDescription& from, const RunDescription& to) {
    if (from.model != to.model || from.origin != to.origin || from.start != to.start) return true;
    return std::any_of(from.scene.infos().begin(), from.scene.infos().end(), [&](const ParameterInfo& info) {
        return info.on_change != OnChange::applies_live && from.scene[info.name] != to.scene[info.name];
    });
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
double Simulation::dt() const {
    const RunDescription& given = description();
    return rounded_to(given.precision, given.dt);
}
std::size_t Simulation::particles() const { return body_->segment.scene.reference.count; }
std::uint64_t Simulation::segment() const { return body_->segment_number; }
double Simulation::segment_start() const { return body_->segment_time; }
std::uint64_t Simulation::baseline_step() const { return body_->baseline_step; }
bool Simulation::has_exact() const { return body_->exact() != nullptr; }
const std::optional<StabilityLimit>& Simulation::limit() const { return body_->segment.limit(); }
const std::optional<Resolution>& Simulation::resolution() const { return body_->segment.resolution(); }
Conservation Simulation::conservation() const { return body_->segment.conservation(); }
std::shared_ptr<const MethodRefusals> Simulation::refusals() const { return body_->segment.refusals(); }
const std::optional<Divergence>& Simulation::divergence() const { return settled().divergence; }

std::uint64_t Simulation::evaluations() const {
    settled();
    return advanced().evaluations;
}

Simulation::Advanced Simulation::advanced() const {
    return {body_->step, body_->evaluations_before + body_->segment.stepper->evaluations(),
            body_->divergence.has_value()};
}

CollisionRecord Simulation::collisions() const { return settled().segment.stepper->collisions(); }

void Simulation::end_at(const RunEnd& end) { body_->end = end.time ? std::optional(end) : std::nullopt; }

bool Simulation::count_drag_work() { return settled().count_drag_work(); }
std::optional<double> Simulation::drag_work() const { return settled().drag_taken(); }

void Simulation::advance(std::uint64_t steps) { body_->advance(steps); }
void Simulation::conclude() { body_->conclude(); }
std::uint64_t Simulation::check_interval() const { return steps_between_checks; }
std::uint64_t Simulation::steps_to_check() const { return settled().steps_to_check(); }

bool Simulation::is_plausible() const {
    const FlushSubnormals flush;
    return settled().energy_is_good();
}

Frame Simulation::frame() const {
    Frame out;
    frame(out);
    return out;
}

void Simulation::frame(Frame& out, const FrameParts& wanted) const {
    Body& body = settled();
    prepare(out, wanted);
    body.emit([&](const Portion& portion) { fill(out, portion); });
}

/// All of a frame but for its particles.
void Simulation::prepare(Frame& out, const FrameParts& wanted) const {
    out.step = step();
    out.time = time();
    out.precision = body_->segment.held.precision;
    out.shape = shape();
    out.reference = body_->segment.scene.reference;
    out.mass = body_->segment.scene.masses.empty() ? body_->segment.scene.mass : 0;
    out.positions.resize(wanted.positions ? particles() : 0);
    out.displacements.resize(wanted.displacements ? particles() : 0);
    out.velocities.resize(particles());
    out.ensemble.clear();
    out.forces.clear();
    out.values.reset();
    out.cell.reset();
    out.magnified = 1;
}

void Simulation::fill(Frame& out, const Portion& portion) const {
    const State<double>& state = portion.state;
    for (std::size_t k = 0; k < portion.count; ++k)
        out.velocities[portion.first + k] = state.velocity.at(portion.place + k);
    if (!out.displacements.empty()) {
        for (std::size_t k = 0; k < portion.count; ++k)
            out.displacements[portion.first + k] = state.displacement.at(portion.place + k);
    }
    if (out.positions.empty()) return;
    out.reference.each(portion.first, portion.count, [&](std::size_t i, Vec3 reference) {
        const Vec3 displacement = state.displacement.at(portion.place + (i - portion.first));
        out.positions[i] = position_of(reference, displacement, out.precision);
    });
}

std::shared_ptr<const Shape> Simulation::shape() const {
    if (!body_->shape) {
        const RunDescription& held = body_->segment.held;
        body_->shape = std::make_shared<const Shape>(model_of(held).shape(held.scene));
    }
    return body_->shape;
}

std::string Simulation::hash() const {
    Body& body = settled();
    return hash_of(body.step, body.segment.held.precision, [&](const PortionSink& sink) { body.emit(sink); });
}

double Simulation::farthest() const {
    Body& body = settled();
    return farthest_of([&](const PortionSink& sink) { body.emit(sink); });
}

double Simulation::rate_of_motion(double enough) const {
    const State<double>& now = state();
    const std::size_t count = now.displacement.count();
    double ways = 0, speeds = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 way = now.displacement.at(i), velocity = now.velocity.at(i);
        if (velocity != Vec3{}) ways += dot(way, way), speeds += dot(velocity, velocity);
    }
    const double rate = ways > 0 ? std::sqrt(speeds / ways) : 0;
    if (rate >= enough) return rate;
    std::vector<Vec3> force;
    forces(force);
    const Plan& scene = body_->segment.scene;
    double pulled = 0, accelerations = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double mass = scene.mass * (scene.masses.empty() ? 1 : scene.masses[i]);
        const Vec3 way = now.displacement.at(i), acceleration = (1 / mass) * force[i];
        if (acceleration != Vec3{}) pulled += dot(way, way), accelerations += dot(acceleration, acceleration);
    }
    return pulled > 0 ? std::max(rate, std::sqrt(std::sqrt(accelerations / pulled))) : rate;
}

const State<double>& Simulation::state() const { return settled().state(); }
void Simulation::forces(std::vector<Vec3>& out) const { settled().segment.forces().at(state(), out); }

Diagnostics Simulation::diagnostics() const {
    return measured([](const Portion&) {});
}

Diagnostics Simulation::observe(Frame& out) const {
    settled();
    prepare(out, {});
    return measured([&](const Portion& portion) { fill(out, portion); });
}

/// Shows all particles to `also`.
Diagnostics Simulation::measured(const PortionSink& also) const {
    Body& body = settled();
    ParticleSums particles(body.segment.scene, *shape(), body.segment.meter.pieces());
    body.measure(also, [&](const Piece& piece) { particles.add(piece); });
    Diagnostics sums = particles.result();
    sums.kinetic = body.energy().kinetic;
    sums.potential = body.energy().potential.value;
    sums.energy = body.energy().total();
    sums.energy_error = body.energy_error();
    if (has_exact() && time() <= body.exact()->valid_until())
        sums.error = largest_error(body.state().displacement, *body.exact(), time());
    return sums;
}

double Simulation::energy() const { return settled().energy().total(); }
double Simulation::energy_error() const { return settled().energy_error(); }

double Simulation::energy_scale() const {
    const Energy& start = body_->baseline;
    return start.kinetic + start.potential.magnitude + body_->segment.meter.floor(dt());
}

/// Counted from the reference position, which is elsewhere where particles have no rest position.
Vec3 Simulation::displacement(std::size_t particle) const {
    return state().displacement.at(particle) + (body_->segment.scene.reference.at(particle) - shape()->rest[particle]);
}

std::optional<Vec3> Simulation::exact_position(std::size_t particle, double time) const {
    const ExactSolution* const exact = body_->exact();
    if (!exact || time > exact->valid_until()) return std::nullopt;
    return body_->segment.scene.reference.at(particle) + exact->displacement(particle, time);
}

std::optional<ExactMotion> Simulation::exact_motion(std::size_t particle) const {
    if (!has_exact()) return std::nullopt;
    const Vec3 origin = body_->segment.scene.reference.at(particle) - shape()->rest[particle];
    return ExactMotion{body_->motion->solution(), particle, origin};
}

std::string Simulation::why_not_exact() const {
    if (!body_->motion) return "the scene was changed during the run";
    const ExactSolution* const exact = body_->exact();
    if (exact && time() <= exact->valid_until()) return {};
    if (exact) return fmt::format("the exact solution ends at t = {} s", typed(exact->valid_until(), 4));
    if (!body_->segment.held.start.is_none() || dt() < 0) return "the exact solution has another start";
    if (!body_->motion->is_as_described()) return "no exact solution is known from this start";
    const Model& entry = model_of(body_->segment.held);
    const bool for_others = entry.exact(ParameterValues(entry.info.parameters)) != nullptr;
    return for_others ? "no exact solution for these parameters" : "no exact solution is known for this scene";
}

Change Simulation::change(const RunDescription& description) {
    const RunDescription& now = body_->segment.description;
    if (description == now) return Change::none;
    const bool again = restarts(now, description);
    const bool altered = description.alterations != now.alterations;
    const bool untouched = step() == 0 && body_->motion && body_->motion->is_as_described() && !altered;
    if (again || untouched) {
        begin(description);
    } else {
        const bool another = altered || !(description.scene == now.scene);
        body_->go_on(description, {.new_baseline = another, .another_motion = another});
    }
    return again ? Change::restarted : Change::continued;
}

void Simulation::act(const Act& act) {
    if (acts(act, *shape())) settled().act(act);
}

void Simulation::restart() { begin(RunDescription(description())); }

void Simulation::begin(const RunDescription& description) {
    const std::uint64_t newest = body_->newest_segment;
    body_ = std::make_unique<Body>(description, Execution(body_->segment.execution));
    body_->segment_number = body_->newest_segment = newest + 1;
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
        Snapshot::Content{description(), body_->segment.scene.start, body_->segment.held.dt, course,
                          std::move(internal), stepper.bytes()});
    return snapshot;
}

void Simulation::restore(const Snapshot& snapshot) {
    const FlushSubnormals flush;
    const Snapshot::Content& content = *snapshot.content_;
    if (content.description.alterations != description().alterations) body_->shape.reset();
    if (content.course.segment_identity != body_->segment_identity)
        body_->segment = Segment(content.description, Execution(body_->segment.execution), content.start, content.dt);
    static_cast<Course&>(*body_) = content.course;
    body_->newest_segment = std::max(body_->newest_segment, body_->segment_number);
    body_->prepare_drag();
    body_->segment.stepper->restore(content.internal);
    body_->divergence.reset();
    body_->moved();
    body_->keep();
}

}  // namespace steplab
