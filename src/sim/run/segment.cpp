#include "sim/run/segment.hpp"

#include "core/flush_subnormals.hpp"
#include "sim/steppers/bands.hpp"

namespace steplab {

Segment::Segment(const RunDescription& given, const Execution& how)
    : description(given),
      held(as_held(given)),
      execution(how),
      scene(model(held.model).scene(held.scene)),
      meter(scene, instructions_of(how)) {
    restart();
}

Segment::Segment(const RunDescription& given, const Execution& how, const Start& start, std::optional<double> dt)
    : description(given),
      held(as_held(given)),
      execution(how),
      scene(model(held.model).scene(held.scene)),
      meter(scene, instructions_of(how)) {
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

const std::optional<StabilityLimit>& Segment::limit() const {
    if (!limit_) limit_ = stability_limit(held);
    return *limit_;
}

const std::optional<Resolution>& Segment::resolution() const {
    if (!resolution_) resolution_ = limit() ? steplab::resolution(held, limit()->omega_max) : std::nullopt;
    return *resolution_;
}

const Remedies& Segment::remedies() const {
    if (!remedies_) remedies_ = steplab::remedies(description, scene);
    return *remedies_;
}

}  // namespace steplab
