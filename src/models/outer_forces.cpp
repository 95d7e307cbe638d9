#include "models/outer_forces.hpp"

#include "models/potentials/expression_potential.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace steplab {

namespace {

double mass_of(const Composition& terms, std::size_t i) { return terms.masses.empty() ? 1 : terms.masses[i]; }

/// Accelerations that are given; of one for all, the particles' place changes nothing.
OuterForces of_accelerations(const Composition& terms) {
    Vec3 sum;
    double sizes = 0;
    for (std::size_t i = 0; i < terms.count && !terms.accelerations.empty(); ++i) {
        if (!terms.fixed.empty() && terms.fixed[i] != 0) continue;
        const Vec3 acceleration = terms.accelerations[terms.accelerations.size() == 1 ? 0 : i];
        const Vec3 force = mass_of(terms, i) * acceleration;
        sum = sum + force;
        sizes += length(force);
    }
    if (sizes == 0) return {};
    constexpr double rounding = 1e-12;  // of the sum of many that cancel
    return {.net = length(sum) > rounding * sizes,
            .central = false,
            .cause = terms.accelerations.size() == 1 ? "gravity" : "outer forces"};
}

/// Places around that of a particle, from near to far beyond the scene, in no particular direction.
std::vector<Vec3> places_around(Vec3 at) {
    constexpr std::array<Vec3, 3> directions{Vec3{0.618, -0.414, 0.732}, Vec3{-0.271, 0.577, 0.161},
                                             Vec3{-0.707, -0.382, 0.866}};
    const double scale = length(at) > 0 ? length(at) : 1;
    std::vector<Vec3> places{at};
    for (double distance = 0.1 * scale; distance < 2000 * scale; distance *= 4) {
        for (const Vec3 direction : directions) places.push_back(at + distance * direction);
    }
    return places;
}

/// True if the force at each of some places is along the line to the origin, and there is one.
class Central {
public:
    Central(const Plan& scene, const Composition& terms, const ComposedField& field)
        : scene_(scene), terms_(terms), potential_(field.expression) {
        constexpr std::size_t most = 16;  // particles
        const std::size_t stride = std::max<std::size_t>(1, field.particles.size() / most);
        for (std::size_t i = 0; i < field.particles.size(); i += stride) add(field.particles[i]);
    }
    bool holds() const { return pulls_ && !turns_; }

private:
    void add(std::uint32_t particle) {
        const Vec3 start = scene_.reference.at(particle) + scene_.start[particle].displacement;
        for (const Vec3 at : places_around(start)) {
            const auto [x, y, z] = potential_.force(Vector<double>{at.x, at.y, at.z}, mass_of(terms_, particle),
                                                    terms_.charges.empty() ? 0.0 : terms_.charges[particle]);
            const Vec3 force{x, y, z};
            const double size = length(force) * length(at), torque = length(cross(at, force));
            if (!std::isfinite(size) || size == 0) continue;
            constexpr double rounding = 1e-9;  // of an expression of some operations
            pulls_ = true;
            turns_ = turns_ || torque > rounding * size;
        }
    }

    const Plan& scene_;
    const Composition& terms_;
    FieldPotential<double> potential_;
    bool pulls_ = false, turns_ = false;
};

}  // namespace

OuterForces outer_forces(const Plan& scene, const Composition& terms) {
    OuterForces outer = of_accelerations(terms);
    for (const ComposedField& field : terms.fields) {
        if (field.particles.empty()) continue;
        outer.net = true;
        outer.central = outer.central && Central(scene, terms, field).holds();
        outer.cause = "outer forces";
    }
    return outer;
}

}  // namespace steplab
