#include "sim/run/state_meter.hpp"

#include "core/flush_subnormals.hpp"
#include "sim/run/execution.hpp"
#include "sim/run/measures.hpp"
#include "sim/run/starting.hpp"

namespace steplab {

StateMeter::StateMeter(const RunDescription& description)
    : scene_(plan_of(as_held(description))),
      conservation_(steplab::conservation(scene_)),
      shape_(std::make_shared<const Shape>(model_of(description).shape(as_held(description).scene))),
      exact_(exact_of(as_held(description))),
      meter_(scene_, instructions_of({})),
      state_{Field<double>(particles()), Field<double>(particles())} {}

Diagnostics StateMeter::measure(const Frame& frame) {
    const FlushSubnormals flush;
    for (std::size_t i = 0; i < particles(); ++i) {
        state_.displacement.set(i, frame.displacements[i]);
        state_.velocity.set(i, frame.velocities[i]);
    }
    ParticleSums particle_sums(scene_, *shape_, meter_.pieces());
    const Energy energy = meter_.energy(
        1,
        [&](const PortionSink& sink) {
            sink({0, particles(), state_});
        },
        [&](const Piece& piece) { particle_sums.add(piece); });
    Diagnostics sums = particle_sums.result();
    sums.kinetic = energy.kinetic;
    sums.potential = energy.potential.value;
    sums.energy = energy.total();
    if (exact_ && frame.time <= exact_->valid_until())
        sums.error = largest_error(state_.displacement, *exact_, frame.time);
    return sums;
}

void StateMeter::forces(std::vector<Vec3>& out) {
    const FlushSubnormals flush;
    if (!forces_) forces_.emplace(scene_);
    forces_->at(state_, out);
}

}  // namespace steplab
