#include "sim/run/segment.hpp"

#include "core/flush_subnormals.hpp"
#include "sim/run/starting.hpp"
#include "sim/steppers/bands.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace steplab {

namespace {

/// Pairs whose forces an evaluation sums for each particle, about.
double pairs_of(const PairForces& forces) { return static_cast<double>(forces.count) / 2; }
double pairs_of(const NearPairForces&) { return 50; }
double pairs_of(const ComposedForces& forces) {
    return forces.terms->pairs.empty() ? 4 : static_cast<double>(forces.count) / 2;
}
template <class OfNeighbours>
double pairs_of(const OfNeighbours&) {
    return 1;
}

std::uint64_t most_at_once(const RunDescription& held, const Plan& scene) {
    constexpr double most_work = 1e8;
    const double evaluations = evaluations_per_step(method(held.method).info, held.method_parameters);
    const double pairs = std::visit([](const auto& layout) { return pairs_of(layout); }, scene.forces);
    const double work = static_cast<double>(scene.reference.count) * pairs;
    return static_cast<std::uint64_t>(std::clamp(most_work / std::max(1.0, evaluations * work), 1.0, most_work));
}

}  // namespace

Segment::Segment(const RunDescription& given, const Execution& how)
    : description(given),
      held(as_held(given)),
      execution(how),
      scene(plan_of(held)),
      meter(scene, instructions_of(how)),
      steps_at_once(most_at_once(held, scene)) {
    restart();
}

Segment::Segment(const RunDescription& given, const Execution& how, const Start& start, std::optional<double> dt)
    : description(given),
      held(as_held(given)),
      execution(how),
      scene(plan_of(held)),
      meter(scene, instructions_of(how)),
      steps_at_once(most_at_once(held, scene)) {
    scene.start = start;
    if (dt) held.dt = rounded_to(held.precision, *dt);
    restart();
}

void Segment::restart() {
    const FlushSubnormals flush;
    stepper.reset();
    const Method& how = method(held.method);
    stepper = make_stepper(how, segment_start(held, scene, instructions_for(how, scene, execution)), execution);
}

void Segment::begin_at(Start start) {
    scene.start = std::move(start);
    restart();
}

const std::optional<StabilityLimit>& Segment::limit() const {
    if (!limit_) limit_ = stability_limit(held);
    return *limit_;
}

const std::optional<Resolution>& Segment::resolution() const {
    if (!resolution_) resolution_ = limit() ? steplab::resolution(held, limit()->omega_max) : std::nullopt;
    return *resolution_;
}

const Conservation& Segment::conservation() const {
    if (!conservation_) conservation_ = steplab::conservation(scene);
    return *conservation_;
}

const std::shared_ptr<const MethodRefusals>& Segment::refusals() const {
    if (!refusals_) refusals_ = std::make_shared<const MethodRefusals>(method_refusals(held, scene));
    return refusals_;
}

ParticleForces& Segment::forces() const {
    if (!forces_) forces_.emplace(scene);
    return *forces_;
}

}  // namespace steplab
