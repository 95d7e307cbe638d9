#include "sim/run/known_fall.hpp"

#include "models/forces/linear_response.hpp"
#include "sim/run/fixed_particles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace steplab {

namespace {

/// The integral of KickResponse::g of free motion with drag: t^2 phi_2(-gamma t), phi_2(z) = (e^z - 1 - z) / z^2
/// (Hochbruck, Ostermann, Acta Numerica 19 (2010) 209), by its series where that difference would cancel.
long double response_to_push(long double gamma, long double t) {
    const long double z = -gamma * t;
    if (z < -1) return t * t * (std::exp(z) - 1 - z) / (z * z);
    long double sum = 1;
    for (int k = 24; k >= 1; --k) sum = 1 + sum * z / static_cast<long double>(k + 2);  // 2 / 26! = 5e-27
    return t * t * sum / 2;
}

/// A particle that nothing pulls back: u'' = acceleration - drag u'.
struct Falling {
    Vec3 displacement, velocity = {}, acceleration = {};
    double drag = 0;
};

Vec3 along_each(const Falling& particle, auto value) {
    const auto number = [&](double u, double v, double a) { return static_cast<double>(value(u, v, a)); };
    const auto& [u, v, a, drag] = particle;
    return {number(u.x, v.x, a.x), number(u.y, v.y, a.y), number(u.z, v.z, a.z)};
}

class Fall final : public ExactSolution {
public:
    explicit Fall(std::vector<Falling> particles) : particles_(std::move(particles)) {}

    Vec3 displacement(std::size_t i, double t) const override {
        const KickResponse kick(0, particles_[i].drag, t);
        const long double push = response_to_push(particles_[i].drag, t);
        return along_each(particles_[i],
                          [&](long double u, long double v, long double a) { return u + v * kick.g + a * push; });
    }
    Vec3 velocity(std::size_t i, double t) const override {
        const KickResponse kick(0, particles_[i].drag, t);
        return along_each(particles_[i],
                          [&](long double, long double v, long double a) { return v * kick.g_rate + a * kick.g; });
    }
    /// Of some operations in long double.
    double rounding(double t) const override {
        double largest = 0;
        for (const auto& [u, v, a, drag] : particles_)
            largest = std::max(largest, length(u) + length(v) * t + length(a) * t * t);
        return 16 * static_cast<double>(std::numeric_limits<long double>::epsilon()) * largest;
    }

private:
    std::vector<Falling> particles_;
};

/// None where particles act on each other or forces change.
const Composition* constant_forces(const Plan& plan) {
    const auto* const composed = std::get_if<ComposedForces>(&plan.forces);
    if (!composed) return nullptr;
    const Composition& terms = *composed->terms;
    const bool constant = terms.springs.empty() && terms.pairs.empty() && terms.fields.empty() && terms.box == Vec3{};
    return constant ? &terms : nullptr;
}

Falling particle_of(const Plan& plan, const Composition& terms, std::size_t i) {
    const Start::Particle start = plan.start[i];
    if (is_fixed(plan.forces, i)) return {.displacement = start.displacement};
    Falling particle{start.displacement, start.velocity, {}, terms.drag.empty() ? plan.drag : terms.drag[i]};
    if (!terms.accelerations.empty())
        particle.acceleration = terms.accelerations.size() == 1 ? terms.accelerations.front() : terms.accelerations[i];
    return particle;
}

}  // namespace

std::shared_ptr<const ExactSolution> known_fall(const Plan& plan) {
    const Composition* const terms = constant_forces(plan);
    if (!terms) return nullptr;
    std::vector<Falling> particles;
    for (std::size_t i = 0; i < plan.reference.count; ++i) particles.push_back(particle_of(plan, *terms, i));
    return std::make_shared<Fall>(std::move(particles));
}

}  // namespace steplab
