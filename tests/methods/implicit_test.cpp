#include "core/error.hpp"
#include "models/forces/layouts.hpp"
#include "sim/run/linear_limit.hpp"
#include "sim/steppers/stepper_of.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace steplab::test {
namespace {

constexpr const char* implicit_methods[] = {"implicit-midpoint", "tr-bdf2"};

/// The scene with every particle that moves put off its place at random, so that nothing vanishes by symmetry.
Plan shaken(std::string_view id, Settings settings) {
    const RunDescription description = run_of(id, "rk4", Precision::double_, 0.1, settings);
    Plan scene = model(id).plan(description.scene);
    const auto roles = model(id).shape(description.scene).roles;
    State<double> start = scene.start.state();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> moved(-0.1, 0.1);
    for (std::size_t i = 0; i < roles.size(); ++i) {
        const Vec3 shift{moved(random), moved(random), moved(random)};
        if (roles[i] != Role::fixed) start.displacement.set(i, start.displacement.at(i) + shift);
    }
    scene.start = std::move(start);
    return scene;
}

std::vector<Plan> shaken_scenes() {
    std::vector<Plan> scenes;
    for (const Model& model : models()) scenes.push_back(shaken(model.info.id, {}));
    scenes.push_back(shaken("chain", {{"fixed", 0}, {"m", 2}}));
    scenes.push_back(shaken("chain", {{"L", 0}}));
    scenes.push_back(shaken("morse", {{"cutoff", 0.8}, {"spacing", 0.3}}));
    return scenes;
}

/// J times a direction by the layout's blocks, these scaled by `strength`.
Field<double> blocks_times(const Plan& scene, const Field<double>& direction, double strength) {
    Field<double> product(direction.count());
    std::visit(
        [&](const auto& forces) {
            auto force = engine<double>(forces);
            each_block(force, scene.start.state().displacement,
                       [&](std::size_t i, std::size_t j, const Block<double>& block) {
                           const Vec3 d = direction.at(j) - direction.at(i);
                           const auto change = (strength * block) * std::array<double, 3>{d.x, d.y, d.z};
                           const Vec3 slope{change[0], change[1], change[2]};
                           if (force.moves(i)) product.set(i, product.at(i) + slope);
                           if (force.moves(j)) product.set(j, product.at(j) - slope);
                       });
        },
        scene.forces);
    return product;
}

Field<double> accelerations_at(const Plan& scene, const Field<double>& direction, double h) {
    Field<double> x = scene.start.state().displacement, a(x.count());
    for (std::size_t k = 0; k < x.flat().size(); ++k) x.flat()[k] += h * direction.flat()[k];
    std::visit([&](const auto& forces) { engine<double>(forces).accelerations(x, a); }, scene.forces);
    return a;
}

/// Largest difference of the blocks from central differences, relative to the largest product.
double worst_block_error(const Plan& scene, double strength) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    Field<double> direction(scene.start.count());
    const Field<double> probe = accelerations_at(scene, direction, 0);
    for (std::size_t i = 0; i < direction.count(); ++i)
        direction.set(i, {number(random), number(random), number(random)});
    std::visit(
        [&](const auto& forces) {
            const auto force = engine<double>(forces);
            for (std::size_t i = 0; i < direction.count(); ++i) {
                if (!force.moves(i)) direction.set(i, {});
            }
        },
        scene.forces);
    constexpr double h = 1e-6;
    const Field<double> product = blocks_times(scene, direction, strength);
    const Field<double> above = accelerations_at(scene, direction, h), below = accelerations_at(scene, direction, -h);
    double worst = 0, most = 1e-300;
    for (std::size_t i = 0; i < direction.count(); ++i) {
        const Vec3 slope = (1 / (2 * h)) * (above.at(i) - below.at(i));
        worst = std::max(worst, length(product.at(i) - slope));
        most = std::max(most, length(product.at(i)));
    }
    return worst / most;
}

// Central differences with h = 1e-6: rounding 1e-16 / 1e-6, and h^2 times third derivatives of some hundred.
TEST(Blocks, are_the_derivative_of_the_accelerations) {
    for (const Plan& scene : shaken_scenes()) EXPECT_LT(worst_block_error(scene, 1), 1e-8);
}

TEST(Blocks, one_per_mille_too_large_are_not) {
    const auto have_derivative = [](const Plan& scene) { return scene.forces.index() != 0; };  // constant ones do not
    for (const Plan& scene : those_where(shaken_scenes(), have_derivative))
        EXPECT_GT(worst_block_error(scene, 1.001), 1e-8);
}

TEST(Blocks, of_coincident_particles_are_finite) {
    const Vector<double> nothing{0, 0, 0};
    const MorseFormula<double> morse{morse_constants<double>({.count = 2})};
    const SpringFormula<double> spring{{0, 0, 0}, 1, 1}, loose{{0, 0, 0}, 0, 1};
    for (const auto& block : {derivative(morse, nothing), derivative(spring, nothing), derivative(loose, nothing)}) {
        for (const auto& row : block.at) {
            for (const double number : row) EXPECT_TRUE(std::isfinite(number));
        }
    }
}

RunDescription at_100_times_the_limit(std::string_view model, std::string_view method, Settings settings) {
    RunDescription description = run_of(model, method, Precision::double_, 1, settings);
    description.dt = 100 * 2 / steplab::model(model).omega_max(description.scene).value();
    return description;
}

bool diverges(RunDescription description, Precision precision) {
    description.precision = precision;
    Simulation simulation(description);
    simulation.advance(1000);
    return simulation.divergence().has_value();
}

TEST(Implicit, methods_are_stable_at_100_times_the_explicit_limit_and_explicit_ones_are_not) {
    const Settings slow = {{"v0", 0.5}}, none = {};
    const std::pair<std::string_view, Settings> scenes[] = {{"chain", slow}, {"oscillator", none}};
    for (const auto& [scene, settings] : scenes) {
        for (const Precision precision : precisions) {
            for (const char* method : implicit_methods)
                EXPECT_FALSE(diverges(at_100_times_the_limit(scene, method, settings), precision)) << scene << method;
            for (const char* method : {"rk4", "velocity-verlet"})
                EXPECT_TRUE(diverges(at_100_times_the_limit(scene, method, settings), precision)) << scene << method;
        }
    }
}

// A stiff spring that turns far in a step is not linear: there the midpoint rule gains energy (Gonzalez, Simo, Comput.
// Methods Appl. Mech. Eng. 134 (1996) 197), and only a method that damps it stays.
TEST(Implicit, of_the_two_only_tr_bdf2_holds_a_stiff_rope_that_whips_undamped) {
    const Settings whip = {{"k", 2e5}, {"c", 0}}, damped = {{"k", 2e7}}, soft = {};
    for (const Precision precision : precisions) {
        for (const Settings& settings : {whip, damped, soft})
            EXPECT_FALSE(diverges(at_100_times_the_limit("rope", "tr-bdf2", settings), precision));
        EXPECT_TRUE(diverges(at_100_times_the_limit("rope", "implicit-midpoint", whip), precision));
    }
}

/// Distance of the stiff rope's end from where it hangs at rest, after `time`.
double distance_from_rest(std::string_view method, double k, double time) {
    RunDescription description = at_100_times_the_limit("rope", method, {{"k", k}, {"c", 1}});
    const ParameterValues& scene = description.scene;
    const Frame frame = frame_after(description, steps_until(time, description.dt));
    const double n = scene["n"];
    const double end = -((n - 1) * scene["L"] + scene["g"] / scene["k"] * n * (n - 1) / 2);
    return length(frame.positions.back() - Vec3{0, end, 0});
}

// The slowest motion, the pendulum, decays at the rate c / 2m = 1.67: after 20 time units e^-33 of it is left.
TEST(TrBdf2, lets_a_stiff_rope_settle_at_its_exact_rest) {
    for (const double k : {2e5, 2e7}) EXPECT_LT(distance_from_rest("tr-bdf2", k, 20), 1e-10) << k;
    EXPECT_GT(distance_from_rest("tr-bdf2", 2e5, 1), 1e-3);  // the partner: not yet settled
}

/// Largest |E - E0| over the last half of 2000 steps of the longitudinal chain, whose springs are linear.
double energy_error(std::string_view method, double dt, bool compensated = false) {
    RunDescription description = run_of("chain", method, Precision::double_, dt);
    description.method_parameters.set("compensated", compensated ? 1 : 0);
    Simulation simulation(description);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        simulation.advance(1);
        worst = std::max(worst, std::abs(simulation.diagnostics().energy_error));
    }
    return worst;
}

// Energy 2: 2000 steps of some 10 roundings of 4e-16 each, were they all of one sign.
TEST(ImplicitMidpoint, keeps_the_energy_of_linear_scenes_to_rounding) {
    for (const double dt : {0.1, 1.0}) {
        EXPECT_LT(energy_error("implicit-midpoint", dt), 1e-11) << dt;
        EXPECT_GT(energy_error("tr-bdf2", dt), 1e-6) << dt;
        EXPECT_GT(energy_error("velocity-verlet", dt), 1e-6) << dt;
    }
    EXPECT_LT(energy_error("implicit-midpoint", 0.1, true), energy_error("implicit-midpoint", 0.1));
}

TEST(TrBdf2, damps_what_it_cannot_resolve_and_implicit_midpoint_does_not) {
    const auto energy_left = [](const char* method) {
        Simulation simulation(at_100_times_the_limit("oscillator", method, {}));
        const double start = simulation.diagnostics().energy;
        simulation.advance(50);
        return simulation.diagnostics().energy / start;
    };
    EXPECT_LT(energy_left("tr-bdf2"), 1e-3);
    EXPECT_NEAR(energy_left("implicit-midpoint"), 1, 1e-9);
}

// A return over 2 x 200 steps leaves their roundings, some 1e-16 each, which the swinging rope magnifies little.
TEST(ImplicitMidpoint, retraces_its_path) {
    const RunDescription description = run_of("rope", "implicit-midpoint", Precision::double_, 0.01, {{"c", 0}});
    const auto distance_after_return = [&](std::string_view id) {
        const Plan scene = model("rope").plan(description.scene);
        State<double> state = scene.start.state();
        for (int half = 0; half < 2; ++half) {
            const auto stepper =
                method(id).make({scene, state, ParameterValues(method(id).info.parameters), Precision::double_, 0.01});
            stepper->advance(200);
            stepper->synchronised(state);
            for (double& v : state.velocity.flat()) v = -v;
        }
        double largest = 0;
        for (std::size_t i = 0; i < 10; ++i) largest = std::max(largest, length(state.displacement.at(i)));
        return largest;
    };
    EXPECT_LT(distance_after_return("implicit-midpoint"), 1e-10);
    EXPECT_GT(distance_after_return("tr-bdf2"), 1e-6);
}

TEST(Implicit, steps_far_too_large_for_a_violent_scene_end_in_numbers) {
    for (const char* method : implicit_methods) {
        for (const auto& description : {run_of("mesh", method, Precision::double_, 10, {{"v0", 1000}}),
                                        run_of("morse", method, Precision::double_, 1),
                                        run_of("morse", method, Precision::double_, 0.3, {{"cutoff", 1}}),
                                        run_of("rope", method, Precision::float_, 1, {{"k", 2e5}})}) {
            Simulation simulation(description);
            simulation.advance(10);
            for (const Vec3& x : simulation.frame().positions) EXPECT_TRUE(std::isfinite(length(x))) << method;
        }
    }
}

TEST(Implicit, coincident_particles_do_not_break_a_step) {
    for (const char* id : implicit_methods) {
        Plan scene = model("morse").plan(describe("morse").scene);
        State<double> start = scene.start.state();
        start.displacement.set(1, start.displacement.at(0));
        const auto stepper =
            method(id).make({scene, start, ParameterValues(method(id).info.parameters), Precision::double_, 0.1});
        stepper->advance(5);
        EXPECT_TRUE(stepper->finite()) << id;
    }
}

TEST(Implicit, methods_refuse_by_name_what_their_linear_solver_cannot_do) {
    for (const char* method : implicit_methods) {
        try {
            check(run_of("morse", method, Precision::double_, 0.01, {{"edge", 20}}));
            ADD_FAILURE() << method;
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), testing::StartsWith(std::string(method) + " cannot run this scene: "));
            EXPECT_THAT(error.what(), testing::HasSubstr("up to 600 particles, not for 8001"));
        }
        EXPECT_NO_THROW(check(run_of("morse", method, Precision::double_, 0.01)));
        EXPECT_NO_THROW(check(run_of("chain", method, Precision::double_, 0.01, {{"n", 100000}})));
    }
    EXPECT_NO_THROW(check(run_of("morse", "rk4", Precision::double_, 0.01, {{"edge", 20}})));
}

TEST(Implicit, methods_have_no_limit_with_drag_either) {
    for (const char* id : implicit_methods) {
        EXPECT_EQ(linear_limit(method(id), ParameterValues(method(id).info.parameters), 3, 0.5), infinity);
        EXPECT_EQ(stability_limit(run_of("rope", id, Precision::double_, 0.1))->limit, infinity);
    }
}

}  // namespace
}  // namespace steplab::test
