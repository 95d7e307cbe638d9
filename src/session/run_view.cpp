#include "session/run_view.hpp"

#include "session/compared.hpp"
#include "sim/run/notes.hpp"
#include "sim/run/opening.hpp"

#include <algorithm>

namespace steplab {

namespace {

Tracked tracked_now(const Simulation& simulation, const Frame& frame, std::size_t particle) {
    const Vec3 rest = frame.shape->rest[particle];
    Tracked tracked{particle, frame.positions[particle] - rest};
    tracked.exact = simulation.exact_motion(particle);
    if (tracked.exact) tracked.exact_displacement = tracked.exact->displacement(frame.time);
    return tracked;
}

}  // namespace

void observe(const Simulation& simulation, const TrackedParticles& tracked, RunView& view) {
    view.divergence = simulation.divergence();
    view.description = simulation.description();
    view.diagnostics = simulation.observe(view.frame);
    view.energy_error = energy_error_of(simulation);
    view.evaluations = simulation.evaluations();
    tell_of(
        tracked, simulation.particles(), [&](std::size_t i) { return tracked_now(simulation, view.frame, i); }, view);
    view.limit = simulation.limit();
    view.resolution = simulation.resolution();
    view.facts = facts_of(view.description);
    view.conservation = simulation.conservation();
    view.refusals = simulation.refusals();
    view.notes.clear();
    if (!view.divergence) {
        view.notes = notes_of_rounding(view.description, view.diagnostics.farthest,
                                       [&](double enough) { return simulation.rate_of_motion(enough); });
    }
    view.has_exact = simulation.has_exact();
    view.why_not_exact = simulation.why_not_exact();
    view.segment_start = simulation.segment_start();
    view.baseline_step = simulation.baseline_step();
    view.dt = simulation.dt();
    view.opening_dt = opening_dt(view.description);
}

void tell_of(const TrackedParticles& tracked, std::size_t count,
             const std::function<Tracked(std::size_t particle)>& known, RunView& view) {
    view.tracked.reset();
    view.also_tracked.clear();
    for (const std::size_t particle : tracked) {
        if (particle >= count) continue;
        if (view.tracked) {
            view.also_tracked.push_back(known(particle));
        } else {
            view.tracked = known(particle);
        }
    }
}

Sample sample_of(const RunView& view) {
    Sample sample = sample_of(view.frame.step, view.frame.time, view.diagnostics);
    const auto add = [&](const Tracked& tracked) {
        if (tracked.particle < view.frame.velocities.size())
            sample.particles.emplace_back(Sample::Particle{
                tracked.displacement, view.frame.velocities[tracked.particle], tracked.exact_displacement});
    };
    if (view.tracked) add(*view.tracked);
    for (const Tracked& tracked : view.also_tracked) add(tracked);
    return sample;
}

std::size_t first_followed(const Shape& shape) {
    for (const Role role : {Role::kicked, Role::bullet}) {
        const auto found = std::find(shape.roles.begin(), shape.roles.end(), role);
        if (found != shape.roles.end()) return static_cast<std::size_t>(found - shape.roles.begin());
    }
    return shape.roles.size() - 1;
}

RunView view_of(const Simulation& simulation, std::optional<std::size_t> tracked) {
    return view_of(simulation, tracked_particles(tracked, {}));
}

RunView view_of(const Simulation& simulation, const TrackedParticles& tracked) {
    RunView view;
    observe(simulation, tracked, view);
    return view;
}

}  // namespace steplab
