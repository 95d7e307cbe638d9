#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::test {
namespace {

double rounding_of(Precision precision) { return precision == Precision::float_ ? 6e-8 : 1.2e-16; }

class Invariants : public testing::TestWithParam<MethodCase> {};

// Every method here keeps linear invariants up to rounding: so many additions of that relative size, of momenta of
// order 1 in 28 particles whose speeds reach 5.
TEST_P(Invariants, momentum_of_closed_systems_is_kept) {
    const auto& [info, precision] = GetParam();
    for (const char* model : {"chain", "morse"}) {
        RunDescription description = run_of(model, info->id, precision, 0.01);
        if (description.scene.contains("fixed")) description.scene.set("fixed", 0);
        Simulation simulation(description);
        const Vec3 before = simulation.diagnostics().momentum;
        simulation.advance(1000);
        EXPECT_LT(length(simulation.diagnostics().momentum - before), rounding_of(precision) * 28 * 5 * 1000) << model;
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Invariants, testing::ValuesIn(working_methods()), case_name);

class SymplecticMethods : public testing::TestWithParam<MethodCase> {};

TEST_P(SymplecticMethods, keep_angular_momentum) {
    const auto& [info, precision] = GetParam();
    // spacing 0.3: nothing comes close to where the force jumps
    Simulation simulation(run_of("morse", info->id, precision, 0.005, {{"spacing", 0.3}}));
    const Vec3 before = simulation.diagnostics().angular_momentum;
    simulation.advance(400);
    EXPECT_LT(length(simulation.diagnostics().angular_momentum - before), rounding_of(precision) * 28 * 100 * 400);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, SymplecticMethods, testing::ValuesIn(working_methods_where([](const MethodCase& c) {
                             return c.info->symplectic;
                         })),
                         case_name);

/// The energy of adaptive methods is as good as their tolerance, and so is their return.
class FixedSteps : public testing::TestWithParam<MethodCase> {};

// Bounded for symplectic methods over 10^4 steps, drifting for the others: the energy error of the second half of a
// long run is no larger than that of the first, up to a tenth and to what one rounding a step adds up to.
TEST_P(FixedSteps, keep_energy_bounded_exactly_where_it_is_said_to) {
    const auto& [info, precision] = GetParam();
    Simulation simulation(run_of("oscillator", info->id, precision, 0.3));
    double first = 0, second = 0;
    for (int i = 0; i < 10000; ++i) {
        simulation.advance(1);
        if (simulation.divergence()) break;
        double& half = i < 5000 ? first : second;
        half = std::max(half, std::abs(simulation.diagnostics().energy_error));
    }
    const double rounding = 10000 * rounding_of(precision);
    EXPECT_EQ(!simulation.divergence() && second < 1.1 * first + rounding, info->symplectic);
}

/// How far from its start a scene is after n steps, a reversal of all velocities and n steps.
double distance_after_return(std::string_view method, Precision precision) {
    const RunDescription description = run_of("morse", method, precision, 0.02, {{"spacing", 0.3}});
    Plan scene = model("morse").plan(description.scene);
    State<double> state = scene.start.state();
    const auto run = [&](std::uint64_t steps) {
        const auto stepper =
            steplab::method(method).make({scene, state, description.method_parameters, precision, description.dt});
        stepper->advance(steps);
        stepper->synchronised(state);
    };
    run(100);
    for (double& v : state.velocity.flat()) v = -v;
    run(100);
    double largest = 0;
    for (std::size_t i = 0; i < scene.start.count(); ++i) {
        largest = std::max(largest, length(state.displacement.at(i) - scene.start[i].displacement));
    }
    return largest;
}

// A reversible method retraces its path up to rounding; a cluster of 28 magnifies 200 roundings by some hundred times.
TEST(Reversal, brings_reversible_methods_back_and_no_others) {
    // rk4's error here is below float's rounding: only double can tell
    const auto can_tell = [](const MethodCase& c) {
        return has_fixed_steps(c) && (c.precision == Precision::double_ || c.info->reversible);
    };
    for (const MethodCase& c : working_methods_where(can_tell)) {
        const double tolerance = rounding_of(c.precision) * 10 * 200 * 100;
        EXPECT_EQ(distance_after_return(c.id(), c.precision) < tolerance, c.info->reversible) << c;
    }
}

// omega dt just below the declared limit stays bounded for long; just above, it blows up, if slowly: srkn-11b, whose
// limit is a narrow resonance at omega dt = pi, grows there by no more than 4e-4 a step. The methods unstable at any dt
// (limit 0) blow up at omega dt = 0.9; those stable at any dt do not at seven times rk4's
// limit.
TEST_P(FixedSteps, blow_up_on_the_oscillator_beyond_their_linear_limit) {
    const MethodCase& c = GetParam();
    const double limit = linear_limit(*c.info, ParameterValues(c.info->parameters));
    const auto diverges = [&](double dt, std::uint64_t steps = 100000) {
        Simulation simulation(run_of("oscillator", c.id(), c.precision, dt));
        simulation.advance(steps);
        return simulation.divergence().has_value();
    };
    if (limit == 0) {
        EXPECT_TRUE(diverges(0.9)) << c;
    } else if (std::isinf(limit)) {
        EXPECT_FALSE(diverges(20, 2000)) << c;
    } else {
        EXPECT_FALSE(diverges(0.999 * limit)) << c;
        EXPECT_TRUE(diverges(1.0002 * limit)) << c;
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, FixedSteps, testing::ValuesIn(working_methods_where(has_fixed_steps)), case_name);

}  // namespace
}  // namespace steplab::test
