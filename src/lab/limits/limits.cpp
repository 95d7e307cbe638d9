#include "lab/limits/limits.hpp"

#include "core/error.hpp"
#include "lab/limits/limit_search.hpp"
#include "lab/limits/mode_run.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/linear_limit.hpp"
#include "sim/run/particle_forces.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// Number of frequencies of a damped scene that are examined; if there are more, they are sampled.
constexpr std::size_t most_frequencies = 64;
/// Steps of a run: enough to detect growth just above the limit of theory, as far as the number of particles allows.
constexpr double fewest_steps = 1024, most_particle_steps = 4e8;
/// The work of a step beyond all limits, which solves equations, grows with the square of the particles or faster:
/// beyond this number a run has as few steps as show a growth of 1 % a step.
constexpr std::size_t many_particles = 25;
constexpr std::uint64_t steps_of_many = 64, steps_of_few = 1024;
/// If theory and measurement differ by more, the note says why.
constexpr double agreement = 1e-3;

/// Linear theory of a method in one mode just above its limit: the dt to test, and the growth of the mode there. A
/// resonance may be narrow, so the best of several values is taken, all as close to the limit as runs and theory should
/// agree.
struct Above {
    double dt = 0;
    double log_growth = 0;  ///< logarithm of the growth factor per step
};

Above just_above(const Method& method, const ParameterValues& parameters, double omega, double gamma, double limit) {
    Above best;
    if (!(limit > 0 && limit < infinity)) return best;
    for (const double factor : {1.0001, 1.0002, 1.0005, 1.001}) {
        const double growth = std::log(step_growth(method, parameters, omega, gamma, factor * limit));
        if (!(growth < best.log_growth)) best = {factor * limit, growth};
    }
    return best;
}

/// Enough steps to detect growth at a quarter of this rate, as far as the work allows.
std::uint64_t steps_of_a_run(const Above& above, double evaluations, const Plan& scene) {
    // a particle of a general layout takes some ten times as long as one of a lattice
    const double particles = static_cast<double>(scene.reference.count) *
                             (std::holds_alternative<ComposedForces>(scene.forces) ? 10.0 : 1.0);
    const double most = most_particle_steps / (particles * std::max(1.0, evaluations));
    const double wanted = above.log_growth > 0 ? 0.8 / above.log_growth : fewest_steps;
    return static_cast<std::uint64_t>(std::max(fewest_steps, std::min(wanted, most)));
}

double measured(const ModeRun& run, const LimitSearch& search) {
    return search.limit(run.most_at_once(), [&](std::span<GrowthQuestion> questions) { run.answer(questions); });
}

bool agree(double theory, double measured) {
    if (theory == 0 || std::isinf(theory)) return theory == measured;
    return std::abs(measured / theory - 1) <= agreement;
}

std::string percent(double ratio) { return fmt::format("{:+.2g} %", 100 * (ratio - 1)); }

/// Why the two differ, as far as the run shows.
std::string disagreement(const ModeRun& run, const RunDescription& held, double theory, double measured) {
    if (const double nonlinear = run.nonlinearity(); nonlinear > 0.01) {
        return fmt::format(
            "the force is not smooth at the initial positions (it deviates from its linearisation by {:.2g} %): linear "
            "theory does not apply",
            100 * nonlinear);
    }
    const std::string far = theory > 0 && measured > 0 && std::isfinite(measured) && std::isfinite(theory)
                                ? percent(measured / theory) + " from theory"
                                : "not the limit of theory";
    if (held.precision == Precision::float_)
        return far + ": rounding in float is not small compared with the vibration";
    return far + ": the steps of the method are not those of its linear theory";
}

}  // namespace

std::optional<double> Limit::ratio() const {
    if (!theory || !measured || !(*theory > 0) || std::isinf(*theory) || std::isinf(*measured)) return std::nullopt;
    return *measured / *theory;
}

StabilityLab::StabilityLab(const RunDescription& description, NoLimit no_limit)
    : no_limit_(no_limit),
      scene_(balanced(plan_of(as_held(description)))),
      facts_(facts_of(description)),
      spacing_(model_of(description).shape(as_held(description).scene).spacing),
      linearised_(scene_, model_of(description).shape(as_held(description).scene)),
      modes_(modes(linearised_)) {
    check_stiffness(omega_max());
}

double StabilityLab::omega_max() const { return highest_frequency(modes_); }

std::vector<StabilityLab::Oscillation> StabilityLab::oscillations() const {
    const Eigen::Index count = modes_.values.size();
    std::vector<Oscillation> all;
    if (count == 0) return all;
    const double zero = 1e-10 * std::abs(modes_.values[count - 1]);  // rounding of an eigenvalue 0
    const auto samples = std::min(static_cast<Eigen::Index>(most_frequencies), count);
    for (Eigen::Index sample = 0; sample < samples; ++sample) {
        const Eigen::Index mode = samples == 1 ? count - 1 : sample * (count - 1) / (samples - 1);
        const double omega2 = modes_.values[mode];
        if (omega2 < -zero) continue;  // unstable equilibrium: departs with any method
        all.push_back({.omega = omega2 < zero ? 0 : std::sqrt(omega2), .mode = mode, .limit = infinity});
        find_damping(all.back());
    }
    return all;
}

/// Of the vibration alone.
void StabilityLab::find_damping(Oscillation& oscillation) const {
    oscillation.gamma = scene_.drag;
    if (!facts_.damping) return;
    constexpr double mixed = 1e-6;  // of the largest damping that there is; rounding leaves less
    State<double> moving{Field<double>(scene_.reference.count),
                         linearised_.displacements(modes_.vectors.col(oscillation.mode))};
    State<double> still{moving.displacement, Field<double>(scene_.reference.count)};
    ParticleForces forces(scene_);
    std::vector<Vec3> with, without;
    forces.at(moving, with);
    forces.at(still, without);
    double power = 0, squares = 0, momenta_squared = 0, others = 0;
    const auto mass = [&](std::size_t i) { return scene_.mass * (scene_.masses.empty() ? 1 : scene_.masses[i]); };
    for (std::size_t i = 0; i < with.size(); ++i) {
        const Vec3 v = moving.velocity.at(i);
        power += dot(v, without[i] - with[i]);
        squares += mass(i) * dot(v, v);
    }
    oscillation.gamma = squares > 0 ? power / squares : 0;
    for (std::size_t i = 0; i < with.size(); ++i) {
        const Vec3 damping = without[i] - with[i];
        const Vec3 other = damping - oscillation.gamma * mass(i) * moving.velocity.at(i);
        momenta_squared += mass(i) * mass(i) * dot(moving.velocity.at(i), moving.velocity.at(i));
        others += dot(other, other);
    }
    oscillation.mixes = others > mixed * mixed * facts_.drag * facts_.drag * momenta_squared;
}

/// The oscillation that grows at the smallest dt. Without drag it is the fastest one.
StabilityLab::Oscillation StabilityLab::first_to_grow(const Method& method, const ParameterValues& parameters) const {
    const std::vector<Oscillation> all = oscillations();
    Oscillation first{};
    for (auto other = all.rbegin(); other != all.rend(); ++other) {
        const double limit = linear_limit(method, parameters, other->omega, other->gamma);
        const bool mixes = first.mixes || other->mixes;
        if (other == all.rbegin() || limit < first.limit) first = *other, first.limit = limit;
        first.mixes = mixes;
        if (facts_.drag == 0) break;
    }
    return first;
}

double StabilityLab::departure() const {
    return modes_.values.size() > 0 ? std::sqrt(std::max(0.0, -modes_.values[0])) : 0;
}

Limit StabilityLab::limit(const RunDescription& description) const {
    const RunDescription held = as_held(description);
    const Method& method = steplab::method(held.method);
    Limit limit{.description = held, .omega_max = omega_max(), .theory = infinity, .measured = infinity, .note = {}};
    if (method.info.adaptive) {
        limit.note = "adaptive: chooses its own steps";
    } else if (omega_max() == 0 && facts_.drag == 0) {
        limit.note = "nothing oscillates";
    } else {
        find(limit, method);
    }
    return limit;
}

/// Of a method that is stable at any dt by theory; empty if it is measured.
std::string StabilityLab::why_not_measured(const RunDescription& held) const {
    if (held.precision == Precision::float_) return "stable at any dt: not measured in float";
    if (held.method_parameters.contains("tolerance")) return "shortens its steps where necessary: not measured";
    return no_limit_ == NoLimit::measured ? "" : "stable at any dt by theory: not measured (--quick)";
}

void StabilityLab::find(Limit& limit, const Method& method) const {
    const RunDescription& held = limit.description;
    const Oscillation first = first_to_grow(method, held.method_parameters);
    limit.theory = first.limit;
    limit.measured.reset();
    if (first.mixes) {
        limit.theory = linear_limit(held, limit.omega_max);
        limit.note = "a bound: damping mixes the vibrations of this scene; not measured";
        return;
    }
    if (method.info.curiosity) {
        limit.note = "demonstrates a mistake: not measured";
        return;
    }
    if (std::isinf(first.limit)) limit.note = why_not_measured(held);
    if (!limit.note.empty()) return;
    // float has 7 digits for the distance of a pair: vibrations must be larger
    const double size = (held.precision == Precision::float_ ? 1e-3 : 1e-6) * spacing_;
    const ModeRun run(method, held.method_parameters, held.precision, scene_,
                      linearised_.displacements(modes_.vectors.col(first.mode)), first.omega, size, departure());
    const Above above = just_above(method, held.method_parameters, first.omega, first.gamma, first.limit);
    const std::uint64_t steps =
        steps_of_a_run(above, evaluations_per_step(method.info, held.method_parameters), scene_);
    limit.measured =
        measured(run, {.expected = first.limit,
                       .above = above.dt,
                       .time_scale = run.time_scale(),
                       .steps = steps,
                       .steps_beyond = scene_.reference.count > many_particles ? steps_of_many : steps_of_few});
    if (!agree(first.limit, *limit.measured)) limit.note = disagreement(run, held, first.limit, *limit.measured);
    if (!limit.note.empty() && above.log_growth > 0 && static_cast<double>(steps) * above.log_growth < 0.5)
        limit.note += fmt::format(", or {} steps are too few to see it grow", steps);
}

}  // namespace steplab
