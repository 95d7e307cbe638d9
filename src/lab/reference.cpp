#include "lab/reference.hpp"

#include "io/interruption.hpp"
#include "lab/extrapolation.hpp"
#include "lab/linearised.hpp"
#include "sim/catalogue.hpp"
#include "sim/stepper_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

using Real = long double;

/// Half an ulp of a double, for what is rounded to one.
constexpr double half_ulp = 1.2e-16;

double largest_number(const Field<double>& field) {
    double largest = 0;
    for (const double number : field.flat()) largest = std::max(largest, std::abs(number));
    return largest;
}

/// Squares of the particles' distances.
std::vector<double> squared_distances(const Field<double>& a, const Field<double>& b) {
    std::vector<double> squares;
    for (std::size_t i = 0; i < a.count(); ++i) {
        const Vec3 between = a.at(i) - b.at(i);
        squares.push_back(dot(between, between));
    }
    return squares;
}

double largest_distance(const Field<double>& a, const Field<double>& b) {
    double largest = 0;
    for (const double square : squared_distances(a, b)) {
        if (std::isnan(square)) return infinity;
        largest = std::max(largest, square);
    }
    return std::sqrt(largest);
}

/// A run in long double at the asked times.
struct ReferenceRun {
    std::vector<State<Real>> states;
    std::uint64_t steps = 0;
};

/// `step` is the longest step; every stretch between two times is cut into equal ones.
template <class Layout>
ReferenceRun run_on(const Layout& forces, const Scene& scene, std::span<const double> times, double step) {
    using Force = decltype(engine<Real>(forces));
    ReferenceRun run;
    State<Real> state{converted<Real>(scene.start.displacement), converted<Real>(scene.start.velocity)};
    Extrapolation<Real> method(state.displacement.count());
    double now = 0;
    for (const double time : times) {
        const Real stretch = static_cast<Real>(time) - now;
        const auto steps = static_cast<std::uint64_t>(std::ceil((time - now) / step));
        System<Real, Force> system(engine<Real>(forces), scene.drag,
                                   stretch / static_cast<Real>(std::max<std::uint64_t>(1, steps)));
        for (std::uint64_t i = 0; i < steps; ++i) {
            check_interruption();
            method.step(system, state);
        }
        run.states.push_back(state);
        run.steps += steps;
        now = time;
    }
    return run;
}

ReferenceRun run(const Scene& scene, std::span<const double> times, double step) {
    return std::visit([&](const auto& forces) { return run_on(forces, scene, times, step); }, scene.forces);
}

/// Largest distance between two runs at one time, taken before anything is rounded to double.
double difference(const State<Real>& a, const State<Real>& b) {
    Field<double> between(a.displacement.count());
    for (std::size_t k = 0; k < between.flat().size(); ++k)
        between.flat()[k] = static_cast<double>(a.displacement.flat()[k] - b.displacement.flat()[k]);
    return largest_distance(between, Field<double>(between.count()));
}

std::vector<double> differences(const ReferenceRun& coarse, const ReferenceRun& fine) {
    std::vector<double> all;
    for (std::size_t i = 0; i < fine.states.size(); ++i) all.push_back(difference(coarse.states[i], fine.states[i]));
    return all;
}

double largest(const std::vector<double>& numbers) {
    return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
}

Reference as_reference(const ReferenceRun& run, const std::vector<double>& errors, std::span<const double> times) {
    Reference reference;
    for (std::size_t i = 0; i < times.size(); ++i) {
        ReferenceMoment moment{
            times[i],
            {converted<double>(run.states[i].displacement), converted<double>(run.states[i].velocity)},
            errors[i]};
        moment.error += half_ulp * largest_number(moment.state.displacement);
        reference.moments.push_back(std::move(moment));
    }
    reference.how = fmt::format("extrapolation of order {} in long double, {} steps; its error from half as many",
                                Extrapolation<Real>::order, run.steps);
    return reference;
}

/// The rate at which things happen, for the coarsest run's steps.
double rate_of(const RunDescription& held, const Scene& scene) {
    const Model& entry = model(held.model);
    const std::optional<double> known = entry.omega_max(held.scene);
    const double omega = known ? *known : highest_frequency(modes(LinearisedScene(scene, entry.shape(held.scene))));
    return std::max(omega, scene.drag);
}

/// Halves the steps until the runs agree, the cost is too high, or nothing is gained any more.
Reference refined(const RunDescription& held, std::span<const double> times, const ReferenceEffort& effort) {
    const Model& entry = model(held.model);
    const Scene scene = entry.scene(held.scene);
    const double wanted = effort.error * entry.shape(held.scene).spacing, rate = rate_of(held, scene);
    const double evaluations_a_step = 65 * static_cast<double>(scene.reference.count());
    double step = rate > 0 ? effort.first_phase / rate : infinity;
    if (!times.empty()) step = std::min(step, std::max(times.back(), 1e-300) / 2);
    ReferenceRun coarse = run(scene, times, step), fine = run(scene, times, step /= 2);
    std::vector<double> errors = differences(coarse, fine);
    for (int i = 0; i < effort.most_refinements && !(largest(errors) <= wanted); ++i) {
        if (2 * static_cast<double>(fine.steps) * evaluations_a_step > effort.most_particle_evaluations) break;
        coarse = std::move(fine);
        fine = run(scene, times, step /= 2);
        const std::vector<double> finer = differences(coarse, fine);
        const bool stalled =
            largest(errors) < 1e-6 * entry.shape(held.scene).spacing && largest(finer) > largest(errors) / 2;
        errors = finer;
        if (stalled) break;  // down to the rounding of long double
    }
    return as_reference(fine, errors, times);
}

std::shared_ptr<const ExactSolution> exact_until(const RunDescription& held, std::span<const double> times) {
    const auto exact = model(held.model).exact(held.scene);
    return exact && (times.empty() || times.back() <= exact->valid_until()) ? exact : nullptr;
}

ReferenceMoment exact_moment(const ExactSolution& exact, std::size_t particles, double time) {
    ReferenceMoment moment{time, {Field<double>(particles), Field<double>(particles)}, exact.rounding(time)};
    for (std::size_t i = 0; i < particles; ++i) {
        moment.state.displacement.set(i, exact.displacement(i, time));
        moment.state.velocity.set(i, exact.velocity(i, time));
    }
    moment.error += half_ulp * largest_number(moment.state.displacement);
    return moment;
}

}  // namespace

Reference reference(const RunDescription& description, std::span<const double> times, const ReferenceEffort& effort) {
    const RunDescription held = as_held(description);
    const auto exact = exact_until(held, times);
    if (!exact) return refined(held, times, effort);
    Reference reference{.moments = {}, .how = "exact solution", .exact = true};
    const auto particles = static_cast<std::size_t>(model(held.model).particles(held.scene));
    for (const double time : times) reference.moments.push_back(exact_moment(*exact, particles, time));
    return reference;
}

Reference reference_run(const RunDescription& description, std::span<const double> times,
                        const ReferenceEffort& effort) {
    return refined(as_held(description), times, effort);
}

std::optional<ReferenceMoment> resting_reference(const RunDescription& description) {
    const RunDescription held = as_held(description);
    const Model& entry = model(held.model);
    if (!entry.resting || !(entry.scene(held.scene).drag > 0)) return std::nullopt;
    Field<double> displacement = entry.resting(held.scene);
    const double rounding = 4 * half_ulp * largest_number(displacement);  // of the few operations it takes
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
