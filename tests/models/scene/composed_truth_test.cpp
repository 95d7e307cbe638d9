// The forces and energies of composed scenes against a plain evaluation of their terms (plain_scene.hpp).

#include "models/scene/found_forces.hpp"
#include "models/scene/plain_scene.hpp"
#include "models/scene/random_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

template <class T>
class ComposedTruth : public testing::Test {};
using TruthNumbers = testing::Types<float, double>;
TYPED_TEST_SUITE(ComposedTruth, TruthNumbers);

// Some ten operations for a term, each off by eps / 2, and sums of up to a hundred terms: in units of the sizes of
// all terms the largest found is 2.2.
constexpr Real roundings = 4;

TYPED_TEST(ComposedTruth, forces_and_energy_are_those_of_a_plain_evaluation) {
    for_scenes(12, any_scene, [](const Scene& scene, const std::string& text) {
        SCOPED_TRACE(text);
        const Found result = found<TypeParam>(scene);
        const PlainForces plain = PlainScene(scene).evaluated();
        ASSERT_EQ(result.forces.size(), plain.forces.size());
        for (std::size_t i = 0; i < plain.forces.size(); ++i) {
            EXPECT_LE(length(result.forces[i] - plain.forces[i]), roundings * eps<TypeParam> * plain.sizes[i]) << i;
        }
        EXPECT_LE(std::abs(result.energy - plain.energy), roundings * eps<TypeParam> * plain.energy_size);
    });
}

// Without fields and fixed particles: what acts on one is taken from another, dashpots included, and turns nothing.
TYPED_TEST(ComposedTruth, forces_within_a_scene_cancel) {
    const auto closed = [](RandomScene& wanted) {
        wanted.fields = wanted.fixed = false;
        return true;
    };
    for_scenes(6, closed, [](const Scene& scene, const std::string& text) {
        SCOPED_TRACE(text);
        Scene without_drag = scene;
        without_drag.fields.clear();
        const Found result = found<TypeParam>(without_drag);
        const PlainScene plain(without_drag);
        const PlainForces right = plain.evaluated();
        Real3 sum, turning;
        Real sizes = 0, arms = 0;
        for (std::size_t i = 0; i < right.forces.size(); ++i) {
            const Real3 at = plain.particles()[i].position, force = result.forces[i];
            sum = sum + force;
            turning = turning + Real3{at.y * force.z - at.z * force.y, at.z * force.x - at.x * force.z,
                                      at.x * force.y - at.y * force.x};
            sizes += right.sizes[i];
            arms += right.sizes[i] * length(at);
        }
        EXPECT_GT(sizes, 1);
        EXPECT_LE(length(sum), roundings * eps<TypeParam> * sizes);
        if (without_drag.box.value() == Vec3{}) {
            EXPECT_LE(length(turning), roundings * eps<TypeParam> * arms);
        }
    });
}

// Turned and moved elsewhere, the same numbers but for rounding: a scene without external potentials has the same
// forces, turned, and without gravity the same energy.
TYPED_TEST(ComposedTruth, forces_turn_with_the_scene_and_are_the_same_elsewhere) {
    const auto open = [](RandomScene& wanted) { return wanted.periodic == 0 && wanted.rounded; };
    for_scenes(6, open, [](Scene scene, const std::string& text) {
        SCOPED_TRACE(text);
        std::erase_if(scene.fields, [](const FieldTerm& field) { return !field.potential.empty(); });
        const Found here = found<TypeParam>(scene);
        const PlainForces plain = PlainScene(scene).evaluated();
        const bool heavy = std::any_of(scene.fields.begin(), scene.fields.end(),
                                       [](const FieldTerm& field) { return field.gravity.has_value(); });
        for (const Vec3 shift : {Vec3{}, Vec3{-3, 11, 5.5}}) {
            const Found there = found<TypeParam>(turned_scene(scene, shift));
            for (std::size_t i = 0; i < here.forces.size(); ++i) {
                const Real3 f = here.forces[i];
                const Real3 right{(-11 * f.x - 2 * f.y + 10 * f.z) / 15, (10 * f.x - 5 * f.y + 10 * f.z) / 15,
                                  (2 * f.x + 14 * f.y + 5 * f.z) / 15};
                EXPECT_LE(length(there.forces[i] - right), roundings * eps<TypeParam> * plain.sizes[i]) << i;
            }
            if (!heavy) {
                EXPECT_LE(std::abs(there.energy - here.energy), roundings * eps<TypeParam> * plain.energy_size);
            }
        }
    });
}

/// Without what follows velocities, and in a box without springs about as long as half of it, which may pass to another
/// image.
Scene at_rest(Scene scene) {
    std::erase_if(scene.fields, [](FieldTerm& field) {
        field.drag.reset();
        return !field.gravity && field.potential.empty();
    });
    const PlainScene plain(scene);
    const Vec3 box = scene.box.value();
    std::erase_if(scene.springs, [&](SpringTerm& term) {
        term.damping = 0;
        const auto at = [&](const std::string& name) { return plain.particles()[std::stoul(name)].position; };
        const Real3 d = at(term.pairs[0].second) - at(term.pairs[0].first);
        const auto is_half = [](Real of, Real side) {
            return std::abs(std::fmod(std::abs(of), side) - side / 2) < 0.01L;
        };
        return is_half(d.x, box.x) || is_half(d.y, box.y) || is_half(d.z, box.z);
    });
    return scene;
}

// Of the layout in double: moved along a direction by h = 1e-4, energies change by what the forces do. In units of the
// sizes rounding is 1e-16 / h = 1e-12; h^4 times fifth derivatives 1e-10; a pair that passes its cut-off, where the
// second derivative jumps, h times a part of the size of one pair.
TEST(ComposedSlopes, of_the_energy_are_the_forces) {
    for_scenes(12, any_scene, [](const Scene& with_drag, const std::string& text) {
        SCOPED_TRACE(text);
        const Scene scene = at_rest(with_drag);
        const Plan plan = planned(scene);
        auto force = engine<double>(std::get<ComposedForces>(plan.forces));
        const Field<double> u = plan.start.state().displacement;
        const std::vector<Real3> along = directions(PlainScene(scene));
        const Real slope = fifth_order_slope(
            [&](Real h) {
                Field<double> moved = u;
                for (std::size_t i = 0; i < u.count(); ++i) {
                    const Real3 to = real(u.at(i)) + h * along[i];
                    moved.set(i, {static_cast<double>(to.x), static_cast<double>(to.y), static_cast<double>(to.z)});
                }
                return Real(force.potential(moved).value);
            },
            1e-4L);
        const Found result = found<double>(scene);
        const PlainForces plain = PlainScene(scene).evaluated();
        Real work = 0;
        for (std::size_t i = 0; i < u.count(); ++i) work += dot(result.forces[i], along[i]);
        EXPECT_LE(std::abs(slope + work), 1e-8L * plain.energy_size) << slope << ' ' << work;
        EXPECT_GT(std::abs(work), 1e-6L * plain.energy_size) << "it is compared with something";
    });
}

TEST(ComposedSlopes, of_every_built_in_potential_are_among_the_plain_formulas) {
    for (const PotentialInfo* const info : BuiltInPotentials::infos)
        EXPECT_NO_THROW(pair_formula(info->name)) << info->name;
}

// The slopes of plain_formulas.cpp were written by hand.
TEST(ComposedSlopes, of_the_plain_formulas_are_right) {
    const PlainParticle a{.mass = 0.7L, .charge = -0.4L}, b{.mass = 1.9L, .charge = 0.8L};
    for (const PairFormula& formula : pair_formulas()) {
        for (Real r = 0.45L; r < 4; r += 0.17L) {
            const auto energy = [&](Real h) { return formula.energy(r + h, formula.values, a, b); };
            const Real slope = formula.slope(r, formula.values, a, b);
            EXPECT_LE(std::abs(fifth_order_slope(energy, 1e-4L) - slope), 1e-9L * (1 + std::abs(slope)))
                << formula.text << ' ' << r;
        }
    }
    for (const FieldFormula& formula : field_formulas()) {
        const Real3 at{0.7L, -1.3L, 0.4L};
        const Real3 slope = formula.slope(at, 1.7L, -0.6L);
        const auto along = [&](Real3 axis) {
            return fifth_order_slope([&](Real h) { return formula.energy(at + h * axis, 1.7L, -0.6L); }, 1e-3L);
        };
        EXPECT_LE(length(Real3{along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})} - slope), 1e-11L) << formula.text;
    }
}

}  // namespace
}  // namespace steplab::test
