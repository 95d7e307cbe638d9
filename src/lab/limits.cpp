#include "lab/limits.hpp"

#include "core/error.hpp"
#include "lab/mode_run.hpp"
#include "sim/catalogue.hpp"
#include "sim/linear_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// Frequencies of a damped scene that are asked; a scene with more of them is sampled.
constexpr std::size_t most_frequencies = 64;
/// Steps of a run; in large scenes fewer, so that a method takes seconds. 1000 still resolve 0.1 %.
constexpr double most_steps = 8192, fewest_steps = 1024, most_particle_steps = 4e8;
/// A vibration that grows by this factor is unstable: just below a limit bounded ones swell too, by
/// (8 (1 - dt / limit))^(-1/2), and this factor is reached within 2e-5 of it only.
const double unstable_growth = std::log(100.0);
constexpr double resolution = 2e-4;
/// Where theory and measurement agree no better, the note says why.
constexpr double agreement = 1e-3;

std::uint64_t steps_of_a_run(const Method& method, const RunDescription& description, std::size_t particles) {
    const double cost = static_cast<double>(particles) *
                        std::max(1.0, evaluations_per_step(method.info, description.method_parameters));
    return static_cast<std::uint64_t>(std::clamp(most_particle_steps / cost, fewest_steps, most_steps));
}

/// Bisection on runs, begun at what theory expects.
class Search {
public:
    Search(const ModeRun& run, std::uint64_t steps) : run_(run), steps_(steps) {}

    double limit(double expected) const {
        const double scale = run_.time_scale();
        if (run_.grows_slowly(0.1 * scale)) return 0;
        if (expected == infinity) return beyond_all(scale);
        const double guess = expected > 0 ? expected : scale;
        double stable = 0.99 * guess, unstable = 1.01 * guess;
        while (grows(stable)) {
            unstable = stable;
            stable *= 0.8;
            if (stable < 0.01 * scale) return 0;
        }
        while (!grows(unstable)) {
            stable = unstable;
            unstable *= 1.25;
            if (unstable > 1e4 * scale) return infinity;
        }
        return between(stable, unstable);
    }

private:
    bool grows(double dt) const { return run_.growth(dt, steps_) > unstable_growth; }

    /// Of a method that is said to be stable at any dt: tried at some, far beyond all explicit methods.
    double beyond_all(double scale) const {
        double stable = 0.1 * scale;
        for (const double tried : {1.0, 3.0, 10.0, 100.0, 1000.0}) {
            if (run_.growth(tried * scale, fewer_steps) > unstable_growth) return between(stable, tried * scale);
            stable = tried * scale;
        }
        return infinity;
    }

    double between(double stable, double unstable) const {
        while (unstable - stable > resolution * unstable) {
            const double middle = (stable + unstable) / 2;
            (grows(middle) ? unstable : stable) = middle;
        }
        return (stable + unstable) / 2;
    }

    static constexpr std::uint64_t fewer_steps = 1024;

    const ModeRun& run_;
    std::uint64_t steps_;
};

bool agree(double theory, double measured) {
    if (theory == 0 || std::isinf(theory)) return theory == measured;
    return std::abs(measured / theory - 1) <= agreement;
}

std::string percent(double ratio) { return fmt::format("{:+.2g} %", 100 * (ratio - 1)); }

/// Why the two differ, as far as the run can tell.
std::string disagreement(const ModeRun& run, Precision precision, double theory, double measured) {
    if (const double nonlinear = run.nonlinearity(); nonlinear > 0.01) {
        return fmt::format("the force is not smooth at the start (off its derivative by {:.2g} %): theory does not hold",
                           100 * nonlinear);
    }
    const std::string far = theory > 0 && measured > 0 && std::isfinite(measured) && std::isfinite(theory)
                                ? percent(measured / theory) + " from theory"
                                : "not what theory says";
    if (precision == Precision::float_) return far + ": float's rounding is no small part of the vibration";
    return far + ": the method's steps are not those of its linear theory";
}

}  // namespace

std::optional<double> Limit::ratio() const {
    if (!theory || !measured || !(*theory > 0) || std::isinf(*theory) || std::isinf(*measured)) return std::nullopt;
    return *measured / *theory;
}

StabilityLab::StabilityLab(const RunDescription& description)
    : scene_(balanced(model(description.model).scene(as_held(description).scene))),
      spacing_(model(description.model).shape(as_held(description).scene).spacing),
      linearised_(scene_, model(description.model).shape(as_held(description).scene)),
      modes_(modes(linearised_)) {}

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
        if (omega2 < -zero) continue;  // departs by itself, whatever the method
        all.push_back({omega2 < zero ? 0 : std::sqrt(omega2), mode});
    }
    return all;
}

Limit StabilityLab::limit(const RunDescription& description) const {
    const RunDescription held = as_held(description);
    const Method& method = steplab::method(held.method);
    Limit limit{.description = held, .omega_max = omega_max(), .theory = {}, .measured = {}, .note = {}};
    if (method.info.adaptive) {
        limit.theory = limit.measured = infinity;
        limit.note = "chooses its steps";
        return limit;
    }
    const std::vector<Oscillation> asked = oscillations();
    const bool moves = !asked.empty() && (asked.back().omega > 0 || scene_.drag > 0);
    if (!moves) {
        limit.theory = limit.measured = infinity;
        limit.note = "nothing oscillates";
        return limit;
    }
    Oscillation first = asked.back();
    double theory = linear_limit(method, held.method_parameters, first.omega, scene_.drag);
    if (scene_.drag > 0 && !method.info.curiosity) {
        for (const Oscillation& other : asked) {
            const double its = linear_limit(method, held.method_parameters, other.omega, scene_.drag);
            if (its < theory) first = other, theory = its;
        }
    }
    limit.theory = theory;
    if (method.info.curiosity) {
        limit.note = "kept to show a mistake: not measured, theory is that of the rule it should be";
        return limit;
    }
    // float keeps 7 digits of a pair's distance: its vibrations are larger
    const double size = (held.precision == Precision::float_ ? 1e-3 : 1e-6) * spacing_;
    const ModeRun run(method, held.method_parameters, held.precision, scene_,
                      linearised_.field(modes_.vectors.col(first.mode)), first.omega, size);
    limit.measured = Search(run, steps_of_a_run(method, held, scene_.reference.count())).limit(theory);
    if (!agree(theory, *limit.measured)) limit.note = disagreement(run, held.precision, theory, *limit.measured);
    return limit;
}

}  // namespace steplab
