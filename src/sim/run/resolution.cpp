#include "sim/run/resolution.hpp"

#include "sim/catalogue.hpp"
#include "sim/run/linear_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace steplab {

namespace {

constexpr double most_damping = 0.01, most_error = 0.1, fewest_steps = 4;

/// The eigenvalue that changes most in size: of an oscillation both are of the same. One that grows rules in the end.
double size_of_worst(const std::array<std::complex<double>, 2>& eigenvalues) {
    const double one = std::abs(eigenvalues[0]), other = std::abs(eigenvalues[1]), larger = std::max(one, other);
    if (larger > 1 + 1e-6) return larger;
    return std::abs(std::log(one)) > std::abs(std::log(other)) ? one : other;
}

}  // namespace

bool Resolution::keeps_motion() const { return std::abs(amplification - 1) <= most_damping; }

bool Resolution::is_good() const { return keeps_motion() && error <= most_error && steps_per_period >= fewest_steps; }

std::optional<Resolution> resolution(const RunDescription& run, double omega) {
    const Method& entry = method(run.method);
    if (!(omega > 0) || chooses_its_steps(run) || entry.info.curiosity) return std::nullopt;
    const double phase = omega * std::abs(run.dt), steps = 2 * std::numbers::pi / phase;
    // the equations of a step over more than a period take long to solve
    if (entry.info.implicit && steps < 1) return Resolution{steps, 0, infinity};
    const auto eigenvalues = step_eigenvalues(entry, run.method_parameters, omega, 0, std::abs(run.dt));
    const auto error = [&](const std::complex<double>& value) { return std::abs(value - std::polar(1.0, phase)); };
    return Resolution{.steps_per_period = steps,
                      .amplification = std::pow(size_of_worst(eigenvalues), steps),
                      .error = steps * std::min(error(eigenvalues[0]), error(eigenvalues[1]))};
}

}  // namespace steplab
