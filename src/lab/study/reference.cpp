#include "lab/study/reference.hpp"

#include "core/interruption.hpp"
#include "core/watching.hpp"
#include "lab/study/distances.hpp"
#include "methods/engines/extrapolation.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/layouts.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/linearised.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace steplab {

namespace {

using Real = long double;

/// A run in long double at the requested times.
struct ReferenceRun {
    std::vector<State<Real>> states;
    std::uint64_t steps = 0;
    std::uint64_t evaluations = 0;
    std::uint64_t collisions = 0;
};

/// The resolution of a run: a fixed step size, or the tolerance of an adaptive step size.
struct Fineness {
    double step = 0;
    double tolerance = 0;  ///< 0: fixed steps

    Fineness finer() const { return {step / 2, tolerance / 1000}; }
    /// At the next tolerance the estimate of a step's error would be rounding of long double.
    bool is_finest() const { return tolerance > 0 && tolerance < 1e-17; }
};

/// Called during a run with the fraction that is done.
using Watch = std::function<void(double)>;

/// Fixed steps: every interval between two times is divided into equal ones. Counts those in which particles pass each
/// other, where the order is lost.
template <class Force>
void equal_steps(System<Real, Force>& system, std::uint64_t steps, State<Real>& state, ReferenceRun& run,
                 const Watch& watch) {
    Extrapolation<Real> method(state.displacement.count());
    Lost<Real> lost(true, state.displacement.count());
    for (std::uint64_t i = 0; i < steps; ++i) {
        watch(static_cast<double>(i) / static_cast<double>(steps));
        const Field<Real> before = state.displacement;
        method.step(system, state, lost, system.dt());
        if (any_pass(system, before, state.displacement)) ++run.collisions;
    }
    run.steps += steps;
}

/// Number of times that an adaptive interval is checked for interruptions.
constexpr int parts = 64;

/// Adaptive steps over `parts` dt of the system, with collisions crossed.
template <class Force>
void own_steps(System<Real, Force>& system, double tolerance, State<Real>& state, ReferenceRun& run,
               const Watch& watch) {
    ParameterValues values(std::span(&tolerance_parameter, 1));
    values.set(tolerance_parameter.name, tolerance);
    AdaptiveSteps<Real, ExtrapolationRule<Real>> integrator(values);
    integrator.start(system, state);
    for (int part = 0; part < parts; ++part) {
        watch(static_cast<double>(part) / parts);
        integrator.step(system);
    }
    integrator.synchronised(system, state);
    run.collisions += integrator.collisions().count();
}

template <class Layout>
ReferenceRun run_on(const Layout& forces, const Plan& scene, std::span<const double> times, const Fineness& fineness,
                    const Watch& watch) {
    using Force = decltype(engine<Real>(forces));
    ReferenceRun run;
    State<Real> state = scene.start.state<Real>();
    double now = 0;
    for (const double time : times) {
        const Real interval = static_cast<Real>(time) - now;
        const auto steps = static_cast<std::uint64_t>(std::ceil((time - now) / fineness.step));
        const bool own = fineness.tolerance > 0;
        const std::uint64_t pieces = own ? parts : std::max<std::uint64_t>(1, steps);
        System<Real, Force> system(engine<Real>(forces), scene.drag, interval / static_cast<Real>(pieces));
        const auto within = [&](double part) { watch((now + part * (time - now)) / times.back()); };
        if (!own) equal_steps(system, steps, state, run, within);
        if (own && interval > 0) own_steps(system, fineness.tolerance, state, run, within);
        run.states.push_back(state);
        run.evaluations += system.evaluations();
        now = time;
    }
    return run;
}

void show(const ReferenceEffort& effort, int run, double part) {
    if (effort.progress) effort.progress(run, part);
}

/// Makes the runs of one reference.
class Runs {
public:
    Runs(const Plan& scene, std::span<const double> times, const ReferenceEffort& effort)
        : scene_(scene), times_(times), effort_(effort) {}

    ReferenceRun operator()(const Fineness& fineness) {
        ++count_;
        double done = 0;
        const Watching watching([&] { show(effort_, count_, done); });
        const auto watch = [&](double part) {
            done = part;
            check_interruption();
        };
        return std::visit([&](const auto& forces) { return run_on(forces, scene_, times_, fineness, watch); },
                          scene_.forces);
    }

private:
    const Plan& scene_;
    std::span<const double> times_;
    const ReferenceEffort& effort_;
    int count_ = 0;
};

std::vector<double> differences(const ReferenceRun& coarse, const ReferenceRun& fine) {
    std::vector<double> all;
    for (std::size_t i = 0; i < fine.states.size(); ++i)
        all.push_back(largest_distance(coarse.states[i], fine.states[i]));
    return all;
}

double largest(const std::vector<double>& numbers) {
    return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
}

std::string description_of(const ReferenceRun& run, const Fineness& fineness) {
    constexpr std::size_t order = Extrapolation<Real>::order;
    if (fineness.tolerance == 0)
        return fmt::format(
            "extrapolation of order {} in long double, {} steps; error estimated by a run with half as many", order,
            run.steps);
    return fmt::format(
        "extrapolation of order {} in long double with tolerance {:.0e}, {} collision{} crossed; error estimated by a "
        "run with 1000 times the tolerance",
        order, fineness.tolerance, run.collisions, run.collisions == 1 ? "" : "s");
}

Reference as_reference(const ReferenceRun& run, const std::vector<double>& errors, std::span<const double> times,
                       std::string how) {
    Reference reference;
    for (std::size_t i = 0; i < times.size(); ++i) {
        ReferenceMoment moment{
            times[i],
            {converted<double>(run.states[i].displacement), converted<double>(run.states[i].velocity)},
            errors[i]};
        moment.error += rounding_of(moment.state.displacement);
        reference.moments.push_back(std::move(moment));
    }
    reference.how = std::move(how);
    return reference;
}

/// The fastest rate in the scene, which determines the steps of the coarsest run.
double rate_of(const RunDescription& held, const Plan& scene) {
    const Model& entry = model_of(held);
    const std::optional<double> known = entry.omega_max(held.scene);
    const double omega = known ? *known : highest_frequency(modes(LinearisedScene(scene, entry.shape(held.scene))));
    return std::max(omega, scene.drag);
}

/// The longest step of the coarsest run.
double longest_step(const RunDescription& held, const Plan& scene, std::span<const double> times,
                    const ReferenceEffort& effort) {
    const Watching watching([&] { show(effort, 1, 0); });
    const double rate = rate_of(held, scene), step = rate > 0 ? effort.first_phase / rate : infinity;
    return times.empty() ? step : std::min(step, std::max(times.back(), 1e-300) / 2);
}

/// Refines until the runs agree, the cost is too high, or accuracy no longer improves. None if particles pass each
/// other in a run of fixed steps. `first`: the run of this fineness, if it was made already.
std::optional<Reference> refined(const RunDescription& held, std::span<const double> times,
                                 const ReferenceEffort& effort, Runs& run, Fineness fineness,
                                 std::optional<ReferenceRun> first = {}) {
    const double spacing = model_of(held).shape(held.scene).spacing, wanted = effort.error * spacing;
    const double particles = model_of(held).particles(held.scene);
    const auto blind = [&](const ReferenceRun& made) { return fineness.tolerance == 0 && made.collisions > 0; };
    ReferenceRun coarse = first ? std::move(*first) : run(fineness);
    if (blind(coarse)) return std::nullopt;
    ReferenceRun fine = run(fineness = fineness.finer());
    if (blind(fine)) return std::nullopt;
    std::vector<double> errors = differences(coarse, fine);
    for (int i = 0; i < effort.most_refinements && !(largest(errors) <= wanted); ++i) {
        const double cost = 2 * static_cast<double>(fine.evaluations) * particles;
        if (fineness.is_finest() || cost > effort.most_particle_evaluations) break;
        coarse = std::move(fine);
        fine = run(fineness = fineness.finer());
        if (blind(fine)) return std::nullopt;
        const std::vector<double> finer = differences(coarse, fine);
        const bool stalled = (largest(errors) < 1e-6 * spacing && largest(finer) > largest(errors) / 2) ||
                             largest(finer) * effort.least_gain > largest(errors);
        errors = finer;
        if (stalled) break;  // limited by rounding of long double, or slow
    }
    return as_reference(fine, errors, times, description_of(fine, fineness));
}

/// With fixed steps, shortened if particles pass each other only because steps are too long; with adaptive steps if
/// particles do pass each other.
Reference refined(const RunDescription& held, std::span<const double> times, const ReferenceEffort& effort) {
    const Plan scene = plan_of(held);
    Runs run(scene, times, effort);
    double step = longest_step(held, scene, times, effort);
    if (auto made = refined(held, times, effort, run, {.step = step})) return *made;
    const Fineness own{.step = step, .tolerance = 1e-12};
    ReferenceRun adaptive = run(own);
    if (adaptive.collisions == 0) {
        for (int halvings = 0; halvings < 8; ++halvings) {
            if (auto made = refined(held, times, effort, run, {.step = step /= 2})) return *made;
        }
    }
    return refined(held, times, effort, run, own, std::move(adaptive)).value();
}

}  // namespace

ReferenceMoment exact_moment(const ExactSolution& exact, std::size_t particles, double time) {
    ReferenceMoment moment{time, {Field<double>(particles), Field<double>(particles)}, exact.rounding(time)};
    for (std::size_t i = 0; i < particles; ++i) {
        moment.state.displacement.set(i, exact.displacement(i, time));
        moment.state.velocity.set(i, exact.velocity(i, time));
    }
    moment.error += rounding_of(moment.state.displacement);
    return moment;
}

std::optional<Reference> exact_reference(const RunDescription& description, std::span<const double> times) {
    const RunDescription held = as_held(description);
    const auto exact = exact_of(held);
    if (!exact || (!times.empty() && times.back() > exact->valid_until())) return std::nullopt;
    Reference reference{.moments = {}, .how = "exact solution", .exact = true};
    const auto particles = static_cast<std::size_t>(model_of(held).particles(held.scene));
    for (const double time : times) reference.moments.push_back(exact_moment(*exact, particles, time));
    return reference;
}

Reference reference(const RunDescription& description, std::span<const double> times, const ReferenceEffort& effort) {
    auto exact = exact_reference(description, times);
    return exact ? std::move(*exact) : reference_run(description, times, effort);
}

Reference reference_run(const RunDescription& description, std::span<const double> times,
                        const ReferenceEffort& effort) {
    return refined(as_held(description), times, effort);
}

std::optional<ReferenceMoment> resting_reference(const RunDescription& description) {
    const RunDescription held = as_held(description);
    const Model& entry = model_of(held);
    if (!entry.resting || !(entry.plan(held.scene).drag > 0)) return std::nullopt;
    Field<double> displacement = entry.resting(held.scene);
    const double rounding = 4 * rounding_of(displacement);  // of a few operations
    const std::size_t particles = displacement.count();
    return ReferenceMoment{infinity, {std::move(displacement), Field<double>(particles)}, rounding};
}

double error_against(const ReferenceMoment& reference, const Field<double>& displacement) {
    return std::max(reference.error, largest_distance(reference.state.displacement, displacement));
}

double rms_error_against(const ReferenceMoment& reference, const Field<double>& displacement) {
    double sum = 0;
    for (const double square : squared_distances(reference.state.displacement, displacement)) sum += square;
    const double rms = std::sqrt(sum / static_cast<double>(displacement.count()));
    return std::isnan(rms) ? infinity : std::max(reference.error, rms);
}

}  // namespace steplab
