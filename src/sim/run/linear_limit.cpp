#include "sim/run/linear_limit.hpp"

#include "core/flush_subnormals.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace steplab {

namespace {

/// x'' = -omega^2 x - gamma x' as a scene: particle 1 on a spring of rest length 0.
Plan damped_oscillator(double omega, double gamma) {
    return {.mass = 1,
            .drag = gamma,
            .forces = LineForces{.count = 2, .first_fixed = true, .mass = 1, .k = omega * omega, .rest_length = 0},
            .reference = {.count = 2},
            .start = {}};
}

/// The eigenvalues of the 2 x 2 matrix of one step. Its columns are what a step makes of (x, v) = (1, 0) and (0, 1),
/// which are taken in one run as two directions of space.
std::array<std::complex<double>, 2> eigenvalues(const Method& method, const ParameterValues& parameters,
                                                const Plan& scene, double dt) {
    State<double> state{Field<double>(2), Field<double>(2)};
    state.displacement.set(1, {1, 0, 0});
    state.velocity.set(1, {0, 1, 0});
    const auto stepper = method.make({scene, state, parameters, Precision::double_, dt});
    stepper->advance(1);
    stepper->synchronised(state);
    const Vec3 x = state.displacement.at(1), v = state.velocity.at(1);
    // the discriminant from the half difference of the diagonal: exact where one eigenvalue is 1 because nothing
    // couples
    const double half_trace = (x.x + v.y) / 2, half_difference = (x.x - v.y) / 2;
    const std::complex<double> root = std::sqrt(std::complex<double>(half_difference * half_difference + x.y * v.x));
    return {half_trace + root, half_trace - root};
}

double growth(const Method& method, const ParameterValues& parameters, const Plan& scene, double dt) {
    const auto [one, other] = eigenvalues(method, parameters, scene, dt);
    return std::max(std::abs(one), std::abs(other));
}

/// The smallest omega dt at which growth is looked for.
constexpr double smallest_phase = 0.01;

/// The first dt at which the damped motion grows, searched in steps of 2 % and bisected down to rounding.
double first_growth(const Method& method, const ParameterValues& parameters, double omega, double gamma) {
    const FlushSubnormals flush;
    const Plan scene = damped_oscillator(omega, gamma);
    const auto grows = [&](double dt) { return !(growth(method, parameters, scene, dt) <= 1 + 1e-12); };
    const double scale = 1 / std::max(omega, gamma);
    double stable = smallest_phase * scale, unstable = stable;
    while (!grows(unstable) && unstable < 1e4 * scale) stable = std::exchange(unstable, unstable * 1.02);
    if (!grows(unstable)) return infinity;
    for (int i = 0; i < 45; ++i) {
        const double middle = (stable + unstable) / 2;
        (grows(middle) ? unstable : stable) = middle;
    }
    return stable;
}

}  // namespace

double linear_limit(const Method& method, const ParameterValues& parameters, double omega, double gamma) {
    const double phase = linear_limit(method.info, parameters);
    const double undamped = omega > 0 ? phase / omega : infinity;
    const bool always = phase == infinity;  // drag takes nothing from a method that is stable everywhere
    if (gamma == 0 || always || method.info.curiosity || method.info.adaptive) return undamped;
    return first_growth(method, parameters, omega, gamma);
}

double measured_linear_limit(const Method& method, const ParameterValues& parameters) {
    const double limit = first_growth(method, parameters, 1, 0);
    return limit > smallest_phase ? limit : 0;
}

double linear_limit(const RunDescription& run, double omega) {
    const double gamma = facts_of(run).drag;
    const auto limit = [&](double frequency) {
        return linear_limit(method(run.method), run.method_parameters, frequency, gamma);
    };
    return std::min(limit(omega), limit(0));
}

std::array<std::complex<double>, 2> step_eigenvalues(const Method& method, const ParameterValues& parameters,
                                                     double omega, double gamma, double dt) {
    const FlushSubnormals flush;
    return eigenvalues(method, parameters, damped_oscillator(omega, gamma), dt);
}

double step_growth(const Method& method, const ParameterValues& parameters, double omega, double gamma, double dt) {
    const FlushSubnormals flush;
    return growth(method, parameters, damped_oscillator(omega, gamma), dt);
}

}  // namespace steplab
