#include "core/dual.hpp"
#include "models/forces/layouts.hpp"
#include "models/forces/plain.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

/// Every layout of forces that the models make, with displaced particles, so that no force is zero by symmetry.
struct ForcesCase {
    std::string name;
    Plan scene;
    Field<double> displacement;  ///< random displacements from rest
    std::vector<Role> roles;
};

ForcesCase forces_case(std::string name, std::string_view model_id, Settings settings) {
    const RunDescription description = run_of(model_id, "rk4", Precision::double_, 0.1, settings);
    Plan scene = model(model_id).plan(description.scene);
    auto roles = model(model_id).shape(description.scene).roles;
    State<double> start = scene.start.state();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> moved(-0.2, 0.2);
    for (std::size_t i = 0; i < roles.size(); ++i) {
        const Vec3 shift{moved(random), moved(random), moved(random)};
        if (roles[i] != Role::fixed) start.displacement.set(i, start.displacement.at(i) + shift);
    }
    return {std::move(name), std::move(scene), std::move(start.displacement), std::move(roles)};
}

std::vector<ForcesCase> all_forces() {
    std::vector<ForcesCase> cases;
    for (const Model& model : models()) {
        // a soft crystal, whose third derivatives are below 400 too
        const bool crystal = model.info.id == "crystal";
        cases.push_back(forces_case(std::string(model.info.id), model.info.id,
                                    crystal ? Settings{{"edge", 5}, {"k", 0.5}} : Settings{}));
    }
    cases.push_back(forces_case("free chain", "chain", {{"fixed", 0}, {"n", 37}, {"k", 3}, {"m", 2}}));
    cases.push_back(forces_case("chain of 16", "chain", {{"n", 16}}));
    cases.push_back(forces_case("chain of 17", "chain", {{"n", 17}}));
    cases.push_back(forces_case("chain of length 0", "chain", {{"L", 0}}));
    cases.push_back(forces_case("smallest mesh", "mesh", {{"dim", 3}, {"k", 2}}));
    cases.push_back(forces_case("morse with cut-off", "morse", {{"cutoff", 0.8}, {"spacing", 0.3}}));
    cases.push_back(forces_case("larger morse", "morse", {{"edge", 4}, {"m", 2}, {"D", 2}}));
    return cases;
}

template <class T>
Field<T> accelerations(const Forces& forces, const Field<T>& x) {
    Field<T> a(x.count());
    std::visit([&](const auto& layout) { engine<T>(layout).accelerations(x, a); }, forces);
    return a;
}

double potential(const Forces& forces, const Field<double>& x) {
    return std::visit([&](const auto& layout) { return engine<double>(layout).potential(x).value; }, forces);
}

double& component(Field<double>& field, std::size_t particle, std::size_t axis) {
    return (axis == 0 ? field.x() : axis == 1 ? field.y() : field.z())[particle];
}

double component(Vec3 v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Largest difference of m a from minus the central difference of the potential, over the moving particles.
double worst_gradient_error(const ForcesCase& c, double strength) {
    constexpr double h = 1e-5;
    const Field<double> a = accelerations(c.scene.forces, c.displacement);
    double worst = 0;
    for (std::size_t i = 0; i < c.roles.size(); ++i) {
        for (std::size_t axis = 0; c.roles[i] != Role::fixed && axis < 3; ++axis) {
            Field<double> x = c.displacement;
            component(x, i, axis) += h;
            const double above = potential(c.scene.forces, x);
            component(x, i, axis) -= 2 * h;
            const double slope = (above - potential(c.scene.forces, x)) / (2 * h);
            worst = std::max(worst, std::abs(strength * c.scene.mass * component(a.at(i), axis) + slope));
        }
    }
    return worst;
}

// Central differences of potentials below 400 with h = 1e-5: rounding 400 * 1e-16 / 1e-5 = 4e-9 plus a truncation error
// h^2 / 6 times third derivatives below 400 for the rope's k = 200.
constexpr double gradient_tolerance = 3e-8;

TEST(Forces, are_minus_the_gradient_of_the_potential) {
    for (const auto& c : all_forces()) EXPECT_LT(worst_gradient_error(c, 1), gradient_tolerance) << c.name;
}

TEST(Forces, that_are_one_per_mille_wrong_are_not_the_gradient) {
    for (const auto& c : all_forces()) EXPECT_GT(worst_gradient_error(c, 1.001), gradient_tolerance) << c.name;
}

// The plain loop on absolute positions is a second, independent statement of every force. Positions up to 100 with
// rounding 1e-14 and k <= 200 leave differences of a few 1e-12; accelerations are of the order 0.1 to 100.
TEST(Forces, of_every_layout_agree_with_the_plain_loop) {
    for (const auto& c : all_forces()) {
        const Field<double> a = accelerations(c.scene.forces, c.displacement);
        Field<double> positions(a.count()), expected(a.count());
        for (std::size_t i = 0; i < a.count(); ++i) positions.set(i, c.scene.reference.at(i) + c.displacement.at(i));
        Plain<double>(c.scene.forces).accelerations(positions, expected);
        for (std::size_t i = 0; i < a.count(); ++i)
            ASSERT_LT(length(a.at(i) - expected.at(i)), 1e-11) << c.name << " particle " << i;
    }
}

TEST(Forces, never_move_a_fixed_particle) {
    std::size_t fixed = 0;
    for (const auto& c : all_forces()) {
        const Field<double> a = accelerations(c.scene.forces, c.displacement);
        for (std::size_t i = 0; i < a.count(); ++i) {
            if (c.roles[i] != Role::fixed) continue;
            ++fixed;
            EXPECT_EQ(a.at(i), Vec3{}) << c.name << " particle " << i;
        }
    }
    EXPECT_GT(fixed, 0u);
}

TEST(Forces, leave_the_padding_zero) {
    for (const auto& c : all_forces()) {
        const Field<double> a = accelerations(c.scene.forces, c.displacement);
        for (const double* axis : {a.x(), a.y(), a.z()}) {
            for (std::size_t i = a.count(); i % Field<double>::granule != 0; ++i) EXPECT_EQ(axis[i], 0) << c.name;
        }
    }
}

// Actio = reactio: the sum of forces is only rounding, of at most 100 numbers below 10.
TEST(Forces, of_closed_systems_sum_to_zero) {
    for (const auto& c : {forces_case("free chain", "chain", {{"fixed", 0}}), forces_case("morse", "morse", {}),
                          forces_case("morse with cut-off", "morse", {{"cutoff", 0.8}})}) {
        const Field<double> a = accelerations(c.scene.forces, c.displacement);
        Vec3 sum;
        for (std::size_t i = 0; i < a.count(); ++i) sum = sum + a.at(i);
        EXPECT_LT(length(sum), 1e-13) << c.name;
    }
}

TEST(Forces, between_coincident_particles_are_finite) {
    for (auto c : all_forces()) {
        Field<double> x(c.displacement.count());
        for (std::size_t i = 0; i < x.count(); ++i) x.set(i, -1 * c.scene.reference.at(i));
        const Field<double> a = accelerations(c.scene.forces, x);
        for (const double number : a.flat()) EXPECT_TRUE(std::isfinite(number)) << c.name;
    }
}

TEST(Forces, are_the_same_formulas_in_every_number_type) {
    for (const auto& c : all_forces()) {
        const Field<double>& x = c.displacement;
        const Field<double> in_double = accelerations(c.scene.forces, x);
        const Field<float> in_float = accelerations(c.scene.forces, converted<float>(x));
        const Field<long double> in_long = accelerations(c.scene.forces, converted<long double>(x));
        for (std::size_t k = 0; k < x.flat().size(); ++k) {
            const double scale = 1 + std::abs(in_double.flat()[k]);
            // about ten roundings each, amplified by the rope's k = 200 and the bullet's distance of 10
            EXPECT_NEAR(static_cast<double>(in_long.flat()[k]), in_double.flat()[k], 1e-13 * scale) << c.name;
            EXPECT_NEAR(static_cast<double>(in_float.flat()[k]), in_double.flat()[k], 1e-4 * scale) << c.name;
        }
    }
}

// A dual number's derivative against a central difference of the accelerations themselves.
TEST(Forces, have_their_exact_jacobian_in_dual_numbers) {
    for (const auto& c : all_forces()) {
        constexpr double h = 1e-6;
        std::size_t last = c.roles.size() - 1;
        while (c.roles[last] == Role::fixed) --last;
        Field<double> above = c.displacement, below = above;
        above.y()[last] += h;
        below.y()[last] -= h;
        Field<Dual<double>> x = converted<Dual<double>>(c.displacement);
        x.y()[last].derivative = 1;
        const auto derivative = accelerations(c.scene.forces, x);
        const auto a = accelerations(c.scene.forces, above), b = accelerations(c.scene.forces, below);
        for (std::size_t k = 0; k < x.flat().size(); ++k) {
            const double slope = (a.flat()[k] - b.flat()[k]) / (2 * h);
            // rounding 1e-14 / 1e-6 and h^2 times third derivatives, for k = 200
            EXPECT_NEAR(derivative.flat()[k].derivative, slope, 1e-7 * (1 + std::abs(slope))) << c.name;
        }
    }
}

}  // namespace
}  // namespace steplab::test
