#include "sim/segment.hpp"

#include "core/flush_subnormals.hpp"

namespace steplab {

namespace {

RunDescription as_held(RunDescription description) {
    check(description);
    description.dt = rounded_to(description.precision, description.dt);
    for (const auto& info : description.scene.infos()) {
        description.scene.set(info.name, rounded_to(description.precision, description.scene[info.name]));
    }
    return description;
}

}  // namespace

Segment::Segment(const RunDescription& given)
    : description(given), held(as_held(given)), scene(model(held.model).scene(held.scene)), meter(scene) {
    start(scene.start);
    scene.start = {};
}

Segment::Segment(const RunDescription& given, const State<double>& state)
    : description(given), held(as_held(given)), scene(model(held.model).scene(held.scene)), meter(scene) {
    start(state);
    scene.start = {};
}

void Segment::start(const State<double>& state) {
    const FlushSubnormals flush;
    stepper = method(held.method).make({scene, state, held.method_parameters, held.precision, held.dt});
}

const std::optional<StabilityLimit>& Segment::limit() const {
    if (!limit_known_) limit_ = stability_limit(held);
    limit_known_ = true;
    return limit_;
}

}  // namespace steplab
