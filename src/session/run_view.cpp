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

void observe(const Simulation& simulation, std::optional<std::size_t> particle, RunView& view) {
    view.divergence = simulation.divergence();
    view.description = simulation.description();
    view.diagnostics = simulation.observe(view.frame);
    view.energy_error = energy_error_of(simulation);
    view.evaluations = simulation.evaluations();
    view.tracked.reset();
    if (particle && *particle < simulation.particles()) view.tracked = tracked_now(simulation, view.frame, *particle);
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

Sample sample_of(const RunView& view) {
    Sample sample = sample_of(view.frame.step, view.frame.time, view.diagnostics);
    if (!view.tracked) return sample;
    const Tracked& tracked = *view.tracked;
    if (tracked.particle < view.frame.velocities.size())
        sample.particle = {tracked.displacement, view.frame.velocities[tracked.particle], tracked.exact_displacement};
    return sample;
}

std::size_t first_followed(const Shape& shape) {
    for (const Role role : {Role::kicked, Role::bullet}) {
        const auto found = std::find(shape.roles.begin(), shape.roles.end(), role);
        if (found != shape.roles.end()) return static_cast<std::size_t>(found - shape.roles.begin());
    }
    return shape.roles.size() - 1;
}

RunView view_of(const Simulation& simulation, std::optional<std::size_t> particle) {
    RunView view;
    observe(simulation, particle, view);
    return view;
}

}  // namespace steplab
