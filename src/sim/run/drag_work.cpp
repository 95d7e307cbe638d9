#include "sim/run/drag_work.hpp"

#include "core/number.hpp"
#include "core/phi.hpp"
#include "models/forces/layouts.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <variant>

namespace steplab {

namespace {

/// Below 1 a series, to avoid cancellation: the k-th coefficient is one of (-z)^k.
template <class Coefficient>
double series(double z, Coefficient coefficient) {
    double sum = 0;
    for (int k = 26; k >= 0; --k) sum = coefficient(k) - z * sum;  // 2^28 / 29! = 3e-23
    return sum;
}

double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

/// With drag alone, a speed that gains d = a - gamma v at first is v + g(s) d after the time s, g(s) = s phi_1(-gamma
/// s). The integrals of g and g^2 over a time tau are tau^2 and tau^3 times these, z = gamma tau.
double integral_of_gain(double z) {
    if (std::abs(z) > 1) return (z - 1 + exponential(-z)) / (z * z);
    return series(z, [](int k) { return 1 / factorial(k + 2); });
}
double integral_of_gain_squared(double z) {
    if (std::abs(z) > 1) return (z - 2 * (1 - exponential(-z)) + (1 - exponential(-2 * z)) / 2) / (z * z * z);
    return series(z, [](int k) { return (std::ldexp(4, k) - 2) / factorial(k + 3); });
}

void add(Field<double>& sum, double factor, const Field<double>& term) {
    for (std::size_t k = 0; k < sum.flat().size(); ++k) sum.flat()[k] += factor * term.flat()[k];
}

}  // namespace

std::vector<double> drag_coefficients(const Plan& scene) {
    const auto* const composed = std::get_if<ComposedForces>(&scene.forces);
    std::vector<double> coefficients(scene.reference.count, scene.mass * scene.drag);
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        if (composed && !composed->terms->drag.empty())
            coefficients[i] = scene.mass * (scene.drag + composed->terms->drag[i]);
        if (!scene.masses.empty()) coefficients[i] *= scene.masses[i];
    }
    return coefficients;
}

DragWork::DragWork(const Plan& scene, const StepParts& parts, double dt)
    : coefficients_(drag_coefficients(scene)),
      drag_(scene.drag),
      parts_(parts),
      dt_(dt),
      slopes_(scene.reference.count) {
    std::visit(
        [&](const auto& layout) {
            using Force = decltype(engine<double>(layout));
            const auto force = std::make_shared<Force>(engine<double>(layout));
            force_ = [force](const Field<double>& x, Field<double>& a) { force->accelerations(x, a); };
        },
        scene.forces);
}

double DragWork::of_step(const State<double>& state) {
    at_ = state;
    double integral = 0;
    if (parts_.kicks.empty()) {
        from_ = state;
        integral = stages();
    }
    for (const KickAndDrift& part : parts_.kicks) {
        if (part.kick != 0) integral += kick(static_cast<double>(part.kick) * dt_);
        drift(static_cast<double>(part.drift) * dt_);
    }
    return integral;
}

void DragWork::accelerate() {
    force_(at_.displacement, slopes_);
    add(slopes_, -drag_, at_.velocity);
}

/// Summed over all particles, times c.
double DragWork::product(const Field<double>& p, const Field<double>& q) const {
    double sum = 0;
    for (std::size_t i = 0; i < coefficients_.size(); ++i)
        sum += coefficients_[i] * (p.x()[i] * q.x()[i] + p.y()[i] * q.y()[i] + p.z()[i] * q.z()[i]);
    return sum;
}

/// Returns the integral of c v^2 over the kick.
double DragWork::kick(double time) {
    accelerate();
    const double z = drag_ * time, gain = parts_.explicit_drag ? time : time * phi_1(-z);
    // drag as at the beginning acts on the mean of both velocities
    const double of_slope = time * time * (parts_.explicit_drag ? 0.5 : 2 * integral_of_gain(z));
    const double of_slope_squared = parts_.explicit_drag ? 0 : time * time * time * integral_of_gain_squared(z);
    const Field<double>& v = at_.velocity;
    const double integral =
        time * product(v, v) + of_slope * product(v, slopes_) + of_slope_squared * product(slopes_, slopes_);
    add(at_.velocity, gain, slopes_);
    return integral;
}

void DragWork::drift(double time) { add(at_.displacement, time, at_.velocity); }

/// Returns the integral of c v^2 over the step by the weights of the stages.
double DragWork::stages() {
    double integral = 0;
    for (const RungeKuttaStage<double>& stage : parts_.stages) {
        integral += dt_ * stage.weight * product(at_.velocity, at_.velocity);
        if (stage.ahead == 0) continue;
        accelerate();
        const Field<double> velocity = at_.velocity;
        at_ = from_;
        add(at_.displacement, dt_ * stage.ahead, velocity);
        add(at_.velocity, dt_ * stage.ahead, slopes_);
    }
    return integral;
}

}  // namespace steplab
