// Two particles nearly in one place, and far apart: every potential as far as numbers hold it.

#include "models/scene/found_forces.hpp"
#include "models/scene/plain_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

template <class T>
class ComposedExtremes : public testing::Test {};
using ExtremeNumbers = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(ComposedExtremes, ExtremeNumbers);

/// Two particles of different masses and charges, the second one at this place.
Scene pair_at(const PairFormula& formula, Vec3 second) {
    Scene scene;
    for (const bool here : {true, false}) {
        auto listed = std::make_shared<std::vector<ListedParticles::Particle>>();
        listed->push_back({.position = here ? Vec3{} : second, .velocity = {}, .mass = here ? 0.5 : 2.5});
        ListedParticles block{.file = "made", .masses = true};
        block.particles = std::move(listed);
        scene.particles.push_back({.group = here ? "g0" : "g1", .arrangement = std::move(block)});
        Fix fix{.particles = {here ? "0" : "1"}};
        fix.charge = here ? -0.5 : 0.875;
        scene.fixes.push_back(std::move(fix));
    }
    PairTerm term{.between = {"g0", "g1"}, .potential = std::string(formula.text)};
    for (const auto& [name, value] : formula.values) term.values[name] = value;
    scene.pairs.push_back(std::move(term));
    return scene;
}

// From a millionth to a million of the distances in the formulas. The force is right where the number type holds it
// and what it is made of, the force divided by the distance: roundings as in composed_truth_test.cpp, the largest
// found is 5 of the sizes; numbers below the least normal one may become 0.
TYPED_TEST(ComposedExtremes, of_distance_leave_every_potential_right_that_numbers_hold) {
    using Limits = std::numeric_limits<TypeParam>;
    for (const PairFormula& formula : pair_formulas()) {
        int held = 0, all = 0;
        for (double power = -6; power <= 6; power += 0.125) {
            const double r = std::pow(10, power);
            const auto at = [](double number) { return static_cast<double>(static_cast<float>(number)); };
            const Scene scene = pair_at(formula, {at(0.36 * r), at(-0.48 * r), at(0.8 * r)});
            const PlainForces plain = PlainScene(scene).evaluated();
            const Real size = plain.sizes[0], largest = Real(Limits::max()) / 64;
            ++all;
            const Real distance = length(PlainScene(scene).particles()[1].position);
            if (size > largest || size / distance > largest || plain.energy_size > largest) continue;
            ++held;
            const Found result = found<TypeParam>(scene);
            const Real least = 64 * Real(Limits::min()) * (1 + distance);
            for (std::size_t i = 0; i < 2; ++i) {
                EXPECT_LE(length(result.forces[i] - plain.forces[i]), 8 * eps<TypeParam> * size + least)
                    << formula.text << ' ' << r << ' ' << plain.forces[i].x;
            }
            // energies are given in double
            const Real rounding = std::max(eps<TypeParam>, eps<double>);
            const Real least_energy = std::max(least, Real(std::numeric_limits<double>::min()));
            EXPECT_LE(std::abs(result.energy - plain.energy), 8 * rounding * plain.energy_size + least_energy)
                << formula.text << ' ' << r << ' ' << plain.energy;
        }
        EXPECT_GT(held, all / 2) << formula.text;
    }
}

}  // namespace
}  // namespace steplab::test
