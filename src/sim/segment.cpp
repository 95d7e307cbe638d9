#include "sim/segment.hpp"

#include "core/flush_subnormals.hpp"
#include "sim/bands.hpp"

namespace steplab {

Segment::Segment(const RunDescription& given, const Execution& how)
    : description(given),
      held(as_held(given)),
      execution(how),
      scene(model(held.model).scene(held.scene)),
      meter(scene, how.instructions) {
    restart();
}

Segment::Segment(const RunDescription& given, const Execution& how, const Start& start)
    : description(given),
      held(as_held(given)),
      execution(how),
      scene(model(held.model).scene(held.scene)),
      meter(scene, how.instructions) {
    scene.start = start;
    restart();
}

void Segment::restart() {
    const FlushSubnormals flush;
    stepper.reset();
    stepper = make_stepper(
        method(held.method),
        {scene, scene.start, held.method_parameters, held.precision, held.dt, execution.instructions}, execution);
}

const std::optional<StabilityLimit>& Segment::limit() const {
    if (!limit_known_) limit_ = stability_limit(held);
    limit_known_ = true;
    return limit_;
}

}  // namespace steplab
