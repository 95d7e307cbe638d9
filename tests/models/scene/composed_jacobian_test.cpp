// The derivatives of the forces of composed scenes against differences of a plain evaluation (plain_scene.hpp).

#include "core/dual.hpp"
#include "models/forces/interactions.hpp"
#include "models/scene/found_forces.hpp"
#include "models/scene/plain_scene.hpp"
#include "models/scene/random_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace steplab::test {
namespace {

/// Without what follows velocities.
Scene of_positions(Scene scene) {
    for (SpringTerm& term : scene.springs) term.damping = 0;
    std::erase_if(scene.fields, [](FieldTerm& field) {
        field.drag.reset();
        return !field.gravity && field.potential.empty();
    });
    return scene;
}

/// A scene at its start, and how its forces change where the particles move along directions.
struct Changes {
    explicit Changes(const Scene& scene) : plan(planned(scene)), plain(scene), along(directions(plain)) {
        const std::vector<PlainParticle> start = plain.particles();
        const auto forces = [&](Real h) {
            for (std::size_t i = 0; i < start.size(); ++i) plain.place(i, start[i].position + h * along[i]);
            return plain.evaluated().forces;
        };
        constexpr Real h = 1e-6L;
        const auto up = forces(h), down = forces(-h), far_up = forces(2 * h), far_down = forces(-2 * h);
        for (std::size_t i = 0; i < up.size(); ++i)
            right.push_back((1 / (12 * h)) * (8 * (up[i] - down[i]) - (far_up[i] - far_down[i])));
        forces(0);
        sizes = plain.evaluated().sizes;
    }

    Real mass(std::size_t i) const { return plain.particles()[i].mass; }
    /// Rounding of the differences is 1e-19 / h, of the forces 1e-16 times the derivatives of all terms: of potentials
    /// at a distance of 0.2 up to a hundred times their sizes.
    void expect(std::size_t i, Real3 found) const { EXPECT_LE(length(found - right[i]), 1e-12L * (1 + sizes[i])) << i; }

    Plan plan;
    PlainScene plain;
    std::vector<Real3> along, right;
    std::vector<Real> sizes;
};

TEST(ComposedJacobian, by_dual_numbers_is_the_change_of_the_forces) {
    for_scenes(4, any_scene, [](const Scene& with_drag, const std::string& text) {
        SCOPED_TRACE(text);
        const Changes changes(of_positions(with_drag));
        Field<Dual<double>> u = converted<Dual<double>>(changes.plan.start.state().displacement), a(u.count());
        for (std::size_t i = 0; i < u.count(); ++i) {
            u.x()[i].derivative = static_cast<double>(changes.along[i].x);
            u.y()[i].derivative = static_cast<double>(changes.along[i].y);
            u.z()[i].derivative = static_cast<double>(changes.along[i].z);
        }
        engine<Dual<double>>(std::get<ComposedForces>(changes.plan.forces)).accelerations(u, a);
        Real largest = 0;
        for (std::size_t i = 0; i < u.count(); ++i) {
            const Real3 slope{a.x()[i].derivative, a.y()[i].derivative, a.z()[i].derivative};
            changes.expect(i, changes.mass(i) * slope);
            largest = std::max(largest, length(changes.right[i]));
        }
        EXPECT_GT(largest, 0.1L) << "something changes";
    });
}

// What Newton's method of the implicit methods is given: blocks of pairs, and of fields with i = j.
TEST(ComposedJacobian, by_blocks_is_the_change_of_the_forces) {
    for_scenes(4, any_scene, [](const Scene& with_drag, const std::string& text) {
        SCOPED_TRACE(text);
        const Changes changes(of_positions(with_drag));
        auto force = engine<double>(std::get<ComposedForces>(changes.plan.forces));
        const Field<double> u = changes.plan.start.state().displacement;
        std::vector<Real3> sum(u.count());
        const auto times = [&](const Block<double>& block, Real3 v) {
            const auto row = [&](std::size_t axis) {
                const auto& of = block.at[axis];
                return Real(changes.plan.mass) * (of[0] * v.x + of[1] * v.y + of[2] * v.z);
            };
            return Real3{row(0), row(1), row(2)};
        };
        each_block(force, u, [&](std::size_t i, std::size_t j, const Block<double>& block) {
            if (i == j) {
                sum[i] = sum[i] - times(block, changes.along[i]);
            } else {
                const Real3 pull = times(block, changes.along[j] - changes.along[i]);
                sum[i] = sum[i] + pull;
                sum[j] = sum[j] - pull;
            }
        });
        for (std::size_t i = 0; i < u.count(); ++i)
            changes.expect(i, changes.plain.particles()[i].fixed ? Real3{} : sum[i]);
    });
}

}  // namespace
}  // namespace steplab::test
