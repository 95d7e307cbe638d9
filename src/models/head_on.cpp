#include "models/head_on.hpp"

#include <cmath>
#include <limits>
#include <memory>

namespace steplab {

namespace {

using Real = long double;

/// With y = e^(b (r - r0)) and mu = m / 2 the energy of the relative motion, mu r'^2 / 2 + D (1/y^2 - 2/y) = E, becomes
/// y'^2 = (2 b^2 / mu) (E y^2 + 2 D y - D), and so y'' = kappa y + lift: linear, with kappa = 2 b^2 E / mu and lift = 2
/// b^2 D / mu.
class HeadOn final : public ExactSolution {
public:
    HeadOn(const PairForces& pair, double start, double v0)
        : start_(start),
          v0_(v0),
          depth_(pair.depth),
          b_(std::sqrt(pair.k / (2 * depth_))),
          r0_(pair.r0),
          y0_(std::exp(b_ * (-start_ - r0_))),
          rate0_(-b_ * y0_ * v0_) {
        const Real mu = static_cast<Real>(pair.mass) / 2;
        energy_ = mu * v0_ * v0_ / 2 + depth_ * (1 / y0_ - 2) / y0_;
        kappa_ = 2 * b_ * b_ * energy_ / mu;
        lift_ = 2 * b_ * b_ * depth_ / mu;
        if (energy_ > 0) {
            const Real root = std::sqrt(depth_ * depth_ + energy_ * depth_);
            nearest_ = depth_ / (depth_ + root);
            swing_ = root / energy_;
            const Real s = std::sqrt(kappa_);
            turn_ = -std::asinh(rate0_ / (swing_ * s)) / s;
        }
        touch_ = time_of_touch();
    }

    Vec3 displacement(std::size_t particle, double t) const override {
        const Real centre = (start_ + v0_ * t) / 2, r = r0_ + std::log(y(t)) / b_;
        return {static_cast<double>(particle == 0 ? centre + r / 2 : centre - r / 2), 0, 0};
    }

    Vec3 velocity(std::size_t particle, double t) const override {
        const Real r_rate = y_rate(t) / (b_ * y(t));
        return {static_cast<double>(particle == 0 ? (v0_ + r_rate) / 2 : (v0_ - r_rate) / 2), 0, 0};
    }

    double valid_until() const override { return touch_; }

    /// For bound motion, or at the threshold, y is a sum of terms that may cancel; otherwise the phase is rounded.
    double rounding(double t) const override {
        const Real s = std::sqrt(std::abs(kappa_));
        const Real terms = std::abs(y0_) + std::abs(y_rate(t)) / b_ + std::abs(rate0_) * std::abs(growth(t));
        const Real lost = energy_ > 0 ? s * std::abs(turn_) : terms / y(t);
        return static_cast<double>(1e-18L * (lost + s * t) / b_ + 1.2e-16L * (std::abs(start_) + std::abs(v0_) * t));
    }

private:
    /// sinh(s t) / s with s^2 = kappa, or sin where kappa < 0.
    Real growth(Real t) const {
        const Real s = std::sqrt(std::abs(kappa_)), phase = s * t;
        if (std::abs(phase) < 1e-9L) return t;
        return (kappa_ > 0 ? std::sinh(phase) : std::sin(phase)) / s;
    }
    /// cosh(s t) - 1 over kappa.
    Real lifted(Real t) const {
        const Real half = growth(t / 2);
        return 2 * half * half;
    }
    bool is_far(Real t) const { return energy_ > 0 && std::sqrt(kappa_) * t > 1; }
    /// For unbound motion, y = nearest + swing (cosh(s (t - turn)) - 1), relative to the turning point: the sum of
    /// terms of the initial values would lose as many digits as cosh has gained.
    Real y(Real t) const {
        if (is_far(t)) return nearest_ + swing_ * kappa_ * lifted(t - turn_);
        return y0_ + rate0_ * growth(t) + (kappa_ * y0_ + lift_) * lifted(t);
    }
    Real y_rate(Real t) const {
        if (is_far(t)) return swing_ * kappa_ * growth(t - turn_);
        return rate0_ * (1 + kappa_ * lifted(t)) + (kappa_ * y0_ + lift_) * growth(t);
    }

    /// Infinite if they never touch. y decreases towards its value at r = 0 and is convex, so that Newton's iteration
    /// approaches that time from below.
    double time_of_touch() const {
        const Real there = std::exp(-b_ * r0_);
        const Real nearest = depth_ / (depth_ + std::sqrt(depth_ * depth_ + energy_ * depth_));
        if (!(nearest < there) || (energy_ >= 0 && v0_ <= 0)) return infinity;
        Real t = energy_ < 0 ? bound_time(there) : 0;
        for (int i = 0; i < 200; ++i) {
            const Real step = (there - y(t)) / y_rate(t);
            t += step;
            if (std::abs(step) <= 4 * std::numeric_limits<Real>::epsilon() * t) break;
        }
        return static_cast<double>(t);
    }

    /// Bound particles: y = middle + swing cos(phase), the phase growing linearly from its initial value.
    Real bound_time(Real there) const {
        const Real s = std::sqrt(-kappa_), middle = -depth_ / energy_;
        const Real swing = std::hypot(y0_ - middle, rate0_ / s);
        return (std::acos((there - middle) / swing) - std::atan2(-rate0_ / s, y0_ - middle)) / s;
    }

    Real start_, v0_, depth_, b_, r0_;
    Real y0_, rate0_;  ///< initial y and y'
    Real energy_ = 0;  ///< E, of the relative motion
    Real kappa_ = 0, lift_ = 0;
    Real nearest_ = 0, swing_ = 0, turn_ = 0;  ///< for energy > 0: minimum of y, amplitude, time of the minimum
    double touch_ = 0;
};

}  // namespace

std::shared_ptr<const ExactSolution> head_on_solution(const PairForces& pair, double start, double v0) {
    const auto solution = std::make_shared<HeadOn>(pair, start, v0);
    // none for a potential so narrow that its exponential overflows
    return std::isfinite(solution->rounding(0)) ? solution : nullptr;
}

}  // namespace steplab
