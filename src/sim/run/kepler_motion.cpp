#include "sim/run/kepler_motion.hpp"

#include "sim/run/fixed_particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace steplab {

namespace {

using Real = long double;

struct RealVector {
    Real x = 0, y = 0, z = 0;

    RealVector() = default;
    explicit RealVector(Vec3 v) : x(v.x), y(v.y), z(v.z) {}
    friend RealVector operator*(Real a, RealVector v) {
        v.x *= a, v.y *= a, v.z *= a;
        return v;
    }
    friend RealVector operator+(RealVector a, const RealVector& b) {
        a.x += b.x, a.y += b.y, a.z += b.z;
        return a;
    }
    Vec3 rounded() const { return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}; }
};
Real dot(const RealVector& a, const RealVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

struct RealState {
    RealVector position, velocity;
};

/// The relative motion on an ellipse, by the differences of the eccentric anomaly from the start: without elements that
/// a circle does not have (Battin, An Introduction to the Mathematics and Methods of Astrodynamics, 4.3).
class Ellipse {
public:
    Ellipse(const RealState& start, Real mu)
        : start_(start), mu_(mu), distance_(std::sqrt(dot(start.position, start.position))) {
        const Real energy = dot(start.velocity, start.velocity) / 2 - mu / distance_;
        axis_ = -mu / (2 * energy);
        rate_ = std::sqrt(mu / axis_) / axis_;
        cosine_ = 1 - distance_ / axis_;
        sine_ = dot(start.position, start.velocity) / std::sqrt(mu * axis_);
    }

    Real axis() const { return axis_; }
    Real rate() const { return rate_; }
    Real eccentricity() const { return std::hypot(cosine_, sine_); }

    RealState at(Real time) const {
        const Real t = std::fmod(time, 2 * std::numbers::pi_v<Real> / rate_);
        const Real anomaly = anomaly_at(rate_ * t), c = std::cos(anomaly), s = std::sin(anomaly);
        const Real versed = 2 * std::sin(anomaly / 2) * std::sin(anomaly / 2);
        const Real distance = axis_ * (1 - cosine_ * c + sine_ * s);
        const Real f = 1 - axis_ / distance_ * versed, g = t - (anomaly - s) / rate_;
        const Real f_rate = -std::sqrt(mu_ * axis_) / (distance * distance_) * s,
                   g_rate = 1 - axis_ / distance * versed;
        return {f * start_.position + g * start_.velocity, f_rate * start_.position + g_rate * start_.velocity};
    }

private:
    /// Kepler's equation x - C sin x + S (1 - cos x) = phase, which grows with x: Newton's method within bounds.
    Real anomaly_at(Real phase) const {
        Real low = phase - 3, high = phase + 3, x = phase;
        for (int i = 0; i < 100; ++i) {
            const Real versed = 2 * std::sin(x / 2) * std::sin(x / 2);
            const Real value = x - cosine_ * std::sin(x) + sine_ * versed - phase;
            (value > 0 ? high : low) = x;
            const Real next = x - value / (1 - cosine_ * std::cos(x) + sine_ * std::sin(x));
            const Real taken = next > low && next < high ? next : (low + high) / 2;
            if (std::abs(taken - x) <= 2e-19L * (1 + std::abs(x))) return taken;
            x = taken;
        }
        return x;
    }

    RealState start_;
    Real mu_, distance_, axis_, rate_, cosine_, sine_;
};

class KeplerMotion final : public ExactSolution {
public:
    struct Body {
        Vec3 reference;
        Real share;  ///< of the relative position that is its own, signed
    };

    KeplerMotion(const Ellipse& ellipse, const RealState& centre, const std::array<Body, 2>& bodies)
        : ellipse_(ellipse), centre_(centre), bodies_(bodies) {}

    Vec3 displacement(std::size_t i, double t) const override {
        const RealVector position =
            centre_.position + Real(t) * centre_.velocity + bodies_[i].share * ellipse_.at(t).position;
        return (position + Real(-1) * RealVector(bodies_[i].reference)).rounded();
    }
    Vec3 velocity(std::size_t i, double t) const override {
        return (centre_.velocity + bodies_[i].share * ellipse_.at(t).velocity).rounded();
    }
    /// Mainly that of the phase, where the motion is fastest.
    double rounding(double t) const override {
        const Real e = ellipse_.eccentricity(),
                   fastest = ellipse_.axis() * ellipse_.rate() * std::sqrt((1 + e) / (1 - e));
        return static_cast<double>(1e-18L * (ellipse_.axis() / (1 - e) + fastest * std::abs(t)));
    }

private:
    Ellipse ellipse_;
    RealState centre_;
    std::array<Body, 2> bodies_;
};

/// The one potential of two particles, if nothing else acts.
const ComposedPairs* only_pair(const Plan& plan) {
    const auto* const forces = std::get_if<ComposedForces>(&plan.forces);
    if (!forces || forces->count != 2 || plan.drag != 0) return nullptr;
    const Composition& terms = *forces->terms;
    const bool alone = terms.springs.empty() && terms.accelerations.empty() && terms.fields.empty() &&
                       terms.drag.empty() && terms.pairs.size() == 1 && terms.box == Vec3{};
    if (!alone) return nullptr;
    const ComposedPairs& pair = terms.pairs.front();
    const bool inverse = pair.potential == "gravity" || pair.potential == "coulomb";
    const bool whole = pair.first.size() + pair.second.size() == 2;                       // not a particle with itself
    const bool once = whole && pair.listed.size() < 2;                                    // not two springs
    return inverse && once && pair.values[1] == 0 && pair.cutoff == 0 ? &pair : nullptr;  // 1: the softening
}

/// The factor of 1 / r^2 in the force of attraction.
Real attraction(const Plan& plan, const ComposedPairs& pair, Real first_mass, Real second_mass) {
    const Real strength = pair.values[0];
    if (pair.potential == "gravity") return strength * first_mass * second_mass;
    const auto& charges = std::get<ComposedForces>(plan.forces).terms->charges;
    return charges.size() == 2 ? -strength * charges[0] * charges[1] : 0;
}

}  // namespace

std::shared_ptr<const ExactSolution> kepler_motion(const Plan& plan) {
    const ComposedPairs* const pair = only_pair(plan);
    if (!pair) return nullptr;
    std::array<RealState, 2> start;
    std::array<Real, 2> mass{}, inverse{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Start::Particle particle = plan.start[i];
        start[i] = {RealVector(plan.reference.at(i)) + RealVector(particle.displacement),
                    RealVector(particle.velocity)};
        mass[i] = Real(plan.mass) * (plan.masses.empty() ? 1 : plan.masses[i]);
        inverse[i] = is_fixed(plan.forces, i) ? 0 : 1 / mass[i];
    }
    const Real both = inverse[0] + inverse[1], mu = attraction(plan, *pair, mass[0], mass[1]) * both;
    const RealState apart{start[1].position + Real(-1) * start[0].position,
                          start[1].velocity + Real(-1) * start[0].velocity};
    if (!(mu > 0) || !(dot(apart.position, apart.position) > 0)) return nullptr;
    const Ellipse ellipse(apart, mu);
    if (!(ellipse.axis() > 0) || !(ellipse.eccentricity() < 0.999L)) return nullptr;
    const Real first = -inverse[0] / both, second = inverse[1] / both;
    const RealState centre{start[0].position + -first * apart.position, start[0].velocity + -first * apart.velocity};
    return std::make_shared<KeplerMotion>(
        ellipse, centre,
        std::array<KeplerMotion::Body, 2>{{{plan.reference.at(0), first}, {plan.reference.at(1), second}}});
}

}  // namespace steplab
