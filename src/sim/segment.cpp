#include "sim/segment.hpp"

#include "core/flush_subnormals.hpp"

namespace steplab {

Segment::Segment(const RunDescription& given, const Execution& how)
    : description(given),
      held(as_held(given)),
      execution(how),
      scene(model(held.model).scene(held.scene)),
      meter(scene) {
    start(scene.start);
    scene.start = {};
}

Segment::Segment(const RunDescription& given, const Execution& how, const State<double>& state)
    : description(given),
      held(as_held(given)),
      execution(how),
      scene(model(held.model).scene(held.scene)),
      meter(scene) {
    start(state);
    scene.start = {};
}

void Segment::start(const State<double>& state) {
    const FlushSubnormals flush;
    stepper = method(held.method)
                  .make({scene, state, held.method_parameters, held.precision, held.dt, execution.instructions});
}

const std::optional<StabilityLimit>& Segment::limit() const {
    if (!limit_known_) limit_ = stability_limit(held);
    limit_known_ = true;
    return limit_;
}

}  // namespace steplab
