#include "lab/study/lyapunov.hpp"

#include "core/interruption.hpp"
#include "methods/engines/extrapolation.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/layouts.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/linearised.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace steplab {

namespace {

using Number = Dual<double>;

/// omega_max times the step size; that of the coarsest reference run is twice as large.
constexpr double phase_of_a_step = 1;
constexpr std::uint64_t intervals = 8, skipped = 2;
/// The error of the reference, in units of the scene's spacing, from which on numbers are meaningless.
constexpr double meaningless = 1e-3;

/// A motion and its tangent vector.
class TangentRun {
public:
    /// The tangent begins in a direction without any symmetry. Position components are weighted by `rate`, so that they
    /// have the unit of velocities.
    TangentRun(const Plan& scene, const LinearisedScene& linear, double rate)
        : rate_(rate), state_(scene.start.state<Number>()) {
        Eigen::VectorXd direction(linear.size());
        for (Eigen::Index k = 0; k < direction.size(); ++k) direction[k] = std::sin(static_cast<double>(k + 1));
        const Field<double> moved = linear.field(direction);
        for (std::size_t k = 0; k < moved.flat().size(); ++k) state_.velocity.flat()[k].derivative = moved.flat()[k];
        normalise();
    }

    State<Number>& state() { return state_; }

    /// Scales the tangent to length 1 and returns the logarithm of its previous length.
    double normalise() {
        double square = 0;
        for (std::size_t k = 0; k < state_.velocity.flat().size(); ++k) {
            const double x = rate_ * state_.displacement.flat()[k].derivative;
            const double v = state_.velocity.flat()[k].derivative;
            square += x * x + v * v;
        }
        const double length = std::sqrt(square);
        for (Number& number : state_.displacement.flat()) number.derivative /= length;
        for (Number& number : state_.velocity.flat()) number.derivative /= length;
        return std::log(length);
    }

private:
    double rate_;
    State<Number> state_;
};

/// x'' = a(x) - gamma v in dual numbers. (System would also instantiate the force for lanes of them.)
template <class Force>
struct TangentEquations {
    Force force;
    double gamma;

    void accelerations(const Field<Number>& x, Field<Number>& a) { force.accelerations(x, a); }
    Number drag() const { return gamma; }
    bool damped() const {
        if constexpr (Force::capabilities.damping) return force.damped();
        return false;
    }
    void damp(const Field<Number>& x, Field<Number>& v, Number time) const {
        if constexpr (Force::capabilities.damping) force.damp(x, v, time);
    }
    void add_damping(const Field<Number>& x, const Field<Number>& v, Field<Number>& a) const {
        if constexpr (Force::capabilities.damping) force.add_damping(x, v, a);
    }
};

/// Logarithm of the growth of the tangent in each interval of the time.
std::vector<double> growths(const Plan& scene, TangentRun run, double time, double step) {
    std::vector<double> all(intervals, 0.0);
    std::visit(
        [&](const auto& forces) {
            const double interval = time / static_cast<double>(intervals);
            const double steps = std::max(1.0, std::ceil(interval / step));
            TangentEquations<decltype(engine<Number>(forces))> system{engine<Number>(forces), scene.drag};
            Extrapolation<Number> method(run.state().displacement.count());
            Lost<Number> lost;
            for (double& growth : all) {
                for (double i = 0; i < steps; ++i) {
                    check_interruption();
                    method.step(system, run.state(), lost, interval / steps);
                    growth += run.normalise();
                }
            }
        },
        scene.forces);
    return all;
}

}  // namespace

bool LyapunovExponent::chaotic() const { return exponent > 4 * spread && growth > 10; }

LyapunovExponent lyapunov_exponent(const Plan& scene, const Shape& shape, double time) {
    const LinearisedScene linear(scene, shape);
    const double rate = std::max({highest_frequency(modes(linear)), scene.drag, 1 / time});
    const std::vector<double> all = growths(scene, TangentRun(scene, linear, rate), time, phase_of_a_step / rate);
    const double interval = time / static_cast<double>(intervals), count = intervals - skipped;
    LyapunovExponent result;
    for (std::size_t i = 0; i < all.size(); ++i) {
        result.growth += all[i];
        if (i >= skipped) result.exponent += all[i] / (interval * count);
    }
    double square = 0;
    for (std::size_t i = skipped; i < all.size(); ++i)
        square += (all[i] / interval - result.exponent) * (all[i] / interval - result.exponent);
    result.spread = std::sqrt(square / (count * (count - 1)));
    return result;
}

std::string chaos_note(const RunDescription& description, double time, double error) {
    const RunDescription held = as_held(description);
    const Model& entry = model_of(held);
    const Shape shape = entry.shape(held.scene);
    if (error < meaningless * shape.spacing) return {};
    const LyapunovExponent lyapunov = lyapunov_exponent(entry.plan(held.scene), shape, time);
    if (!lyapunov.chaotic()) return {};
    const double digits = lyapunov.growth / std::log(10.0);
    return fmt::format(
        "The motion is chaotic: its Lyapunov exponent is {:.2g} ± {:.1g} 1/s. Trajectories that start close together "
        "diverge by a factor of 10 every {:.2g} s, and by 1e{:.0f} until t = {:.4g} s. At about t = {:.2g} s none of "
        "the 16 digits of double is left; compare energies and averages instead.",
        lyapunov.exponent, lyapunov.spread, std::log(10.0) / lyapunov.exponent, digits, time, 16 / digits * time);
}

}  // namespace steplab
