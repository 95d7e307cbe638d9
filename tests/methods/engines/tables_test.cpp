#include "core/entry.hpp"
#include "methods/engines/splitting.hpp"
#include "methods/engines/system.hpp"
#include "methods/rk4.hpp"
#include "models/forces/line.hpp"
#include "support/all_at_once.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab {
namespace {

// The engines run any table: these are the catalogue's tables with one coefficient off, to show that the tests of order
// and reversal would see it.

struct Rk4WithAWrongWeight {
    static constexpr ButcherTable<4> table{.a = Rk4::table.a, .b = {1.0 / 6 + 1e-3, 1.0 / 3 - 1e-3, 1.0 / 3, 1.0 / 6}};
};

/// Velocity Verlet as drift, kick, drift; and with a kick too strong.
struct DriftKickDrift {
    static constexpr std::array<KickAndDrift, 2> table{{{.kick = 0, .drift = 0.5}, {.kick = 1, .drift = 0.5}}};
};
struct StrongKick {
    static constexpr std::array<KickAndDrift, 2> table{{{.kick = 0, .drift = 0.5}, {.kick = 1.001, .drift = 0.5}}};
};

/// |x - sin t| of the oscillator at t = 2.
template <class Integrator>
double error(std::size_t steps) {
    const Line<double> spring({.count = 2, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 0});
    System system(test::force_for<Integrator>(spring), 0.0, 2 / static_cast<double>(steps));
    State<double> state{Field<double>(2), Field<double>(2)};
    state.velocity.x()[1] = 1;
    Integrator integrator{ParameterValues()};
    integrator.start(system, state);
    for (std::size_t i = 0; i < steps; ++i) integrator.step(system);
    integrator.synchronised(system, state);
    return std::abs(state.displacement.x()[1] - std::sin(2.0));
}

template <class Integrator>
double slope() {
    return std::log2(error<Integrator>(256) / error<Integrator>(512));
}

TEST(RungeKutta, loses_its_order_with_a_wrong_weight) {
    EXPECT_NEAR((slope<RungeKutta<double, Rk4>>()), 4, 0.1);
    EXPECT_LT((slope<RungeKutta<double, Rk4WithAWrongWeight>>()), 2);
}

TEST(Splitting, runs_tables_of_several_parts) {
    EXPECT_NEAR((slope<Splitting<double, DriftKickDrift>>()), 2, 0.1);
    EXPECT_LT((slope<Splitting<double, StrongKick>>()), 1);
}

}  // namespace
}  // namespace steplab
