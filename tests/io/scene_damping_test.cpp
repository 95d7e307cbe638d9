// Dashpots, and drag that differs between particles, with every method that takes them.

#include "core/number_text.hpp"
#include "models/forces/linear_response.hpp"
#include "sim/run/simulation.hpp"
#include "sim/run/starting.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

namespace steplab::test {
namespace {

RunDescription run_of_text(const std::string& text, const MethodCase& method, double dt) {
    RunDescription run = with_method(describe(read_scene("steplab = 1\n" + text)), method.id());
    run.precision = method.precision;
    run.dt = dt;
    return run;
}

/// Masses of 1 and 3 that a spring and its dashpot hold 1 apart: mu = 3/4, omega = 2, gamma = c / mu.
std::string damped_dimer(double damping) {
    return R"(
[[particles]]
group = "light"
velocity = [0.3, 0, 0]
[[particles]]
group = "heavy"
position = [1, 0, 0]
mass = 3
velocity = [-0.1, 0, 0]
[[springs]]
pairs = [["light", "heavy"]]
k = 3
damping = )" +
           number_text(damping) + "\n";
}

double stretch_after(double damping, const MethodCase& method, double time, std::uint64_t steps) {
    Simulation simulation(run_of_text(damped_dimer(damping), method, time / static_cast<double>(steps)));
    simulation.advance(steps);
    const Frame frame = simulation.frame();
    // rounding of float in 450 steps
    EXPECT_LT(std::abs(frame.positions[0].x + 3 * (frame.positions[1].x - 1)), 450 * 6e-8)
        << "the centre of mass rests";
    return frame.positions[1].x - frame.positions[0].x - 1;
}

bool takes_damping(const MethodCase& c) { return c.info->order_with_damping > 0; }

std::vector<MethodCase> damping_methods(bool takes) {
    std::vector<MethodCase> all;
    for (const MethodCase& c : working_methods()) {
        if (takes_damping(c) == takes) all.push_back(c);
    }
    return all;
}

class Dashpots : public testing::TestWithParam<MethodCase> {};

// Weak, critical and strong damping: gamma = 2 omega is critical, c = 3. Steps of 1/300: an error of first order is
// some hundredths of the amplitude 0.2, one of second order 1e-5; float rounds at 1e-6.
TEST_P(Dashpots, in_all_three_regimes) {
    const MethodCase& c = GetParam();
    for (const double damping : {0.3, 3.0, 9.0}) {
        const double exact = -0.4 * kick_response(4, damping / 0.75, 1.5);
        const double allowed = c.info->order_with_damping == 1 ? 0.01 : c.precision == Precision::float_ ? 2e-5 : 1e-5;
        EXPECT_NEAR(stretch_after(damping, c, 1.5, 450), exact, allowed) << damping;
    }
}

// The error falls with the power of the step that the method states; of orders above 5 rounding is reached first.
TEST_P(Dashpots, have_the_stated_order) {
    const MethodCase& c = GetParam();
    const int order = c.info->order_with_damping;
    if (c.precision == Precision::double_ && !c.info->adaptive) {
        const double exact = -0.4 * kick_response(4, 0.9 / 0.75, 1.5);
        const double coarse = std::abs(stretch_after(0.9, c, 1.5, 60) - exact);
        const double fine = std::abs(stretch_after(0.9, c, 1.5, 120) - exact);
        EXPECT_NEAR(std::log2(coarse / fine), order, 0.15) << coarse << ' ' << fine;
    } else {
        const double exact = -0.4 * kick_response(4, 0.9 / 0.75, 1.5);
        EXPECT_NEAR(stretch_after(0.9, c, 1.5, 450), exact, order == 1 ? 0.01 : 2e-5);
    }
}

// v = v0 exp(-c t / m) of each particle by itself.
TEST_P(Dashpots, drag_of_each_particle) {
    const std::string text = R"(
[[particles]]
group = "a"
velocity = [1, 0, 0]
[[particles]]
group = "b"
velocity = [1, 0, 0]
mass = 4
[[fields]]
drag = 0.5
[[fields]]
particles = "b"
drag = 1
)";
    const MethodCase& c = GetParam();
    Simulation simulation(run_of_text(text, c, 0.005));
    simulation.advance(400);
    const Frame frame = simulation.frame();
    const double allowed = c.info->order_with_damping == 1 ? 0.005 : c.precision == Precision::float_ ? 1e-4 : 1e-5;
    EXPECT_NEAR(frame.velocities[0].x, std::exp(-0.5 * 2), allowed);
    EXPECT_NEAR(frame.velocities[1].x, std::exp(-1.5 / 4 * 2), allowed);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Dashpots, testing::ValuesIn(damping_methods(true)), case_name);

TEST(Damping, is_refused_by_name_where_formulas_have_none) {
    const std::vector<MethodCase> refused = damping_methods(false);
    ASSERT_FALSE(refused.empty());
    for (const MethodCase& c : refused) {
        try {
            check(run_of_text(damped_dimer(1), c, 0.01));
            ADD_FAILURE() << c.id();
        } catch (const UsageError& error) {
            EXPECT_NE(std::string(error.what()).find(c.id() + " cannot run this scene: dashpots"), std::string::npos);
        }
    }
}

// At the beginning the spring is at its length: what acts is the dashpot, c times the relative velocity of 0.4.
TEST(Damping, is_part_of_the_forces) {
    Simulation simulation(run_of_text(damped_dimer(2), {&method("rk4").info, Precision::double_}, 0.01));
    std::vector<Vec3> forces;
    simulation.forces(forces);
    ASSERT_EQ(forces.size(), 2u);
    EXPECT_NEAR(forces[0].x, -0.8, 1e-15);
    EXPECT_NEAR(forces[1].x, 0.8, 1e-15);
}

std::string hash_after(const RunDescription& run, std::uint64_t steps) {
    Simulation simulation(run);
    simulation.advance(steps);
    EXPECT_FALSE(simulation.divergence()) << command_line(run);
    return simulation.hash();
}

/// The rope with drag, written by hand; `drag` are its blocks. A run in float holds parameters as float has them.
std::string rope_with(const std::string& drag) {
    return "[parameters]\nm = 0.3\nk = 200\nc = 0.5\ng = 9.81\n[[particles]]\ngroup = \"rope\"\nmass = \"m\"\n"
           "line = { count = 10, step = [0.5, 0, 0] }\n[[fix]]\nparticles = \"rope[0]\"\nfixed = true\n"
           "[[springs]]\nbetween = \"rope\"\nk = \"k * m\"\n[[fields]]\ngravity = [0, \"-g\", 0]\n" +
           drag;
}

// A drag that is the same for all, however it is written, keeps every method, and has the bits of the drag of models.
TEST(Damping, equal_drag_is_the_drag_of_models) {
    for (const MethodCase& c : working_methods()) {
        const RunDescription model = run_of("rope", c.id(), c.precision, 0.01, {{"c", 0.5}});
        const std::string right = hash_after(model, 20);
        for (const char* const drag :
             {"drag = \"c\"\n", "drag = \"c/4\"\n[[fields]]\nparticles = \"all\"\ndrag = \"3*c/4\"\n"})
            EXPECT_EQ(hash_after(run_of_text(rope_with(drag), c, 0.01), 20), right) << c.id() << ' ' << drag;
        EXPECT_NE(hash_after(run_of_text(rope_with("drag = \"1.000001*c\"\n"), c, 0.01), 20), right) << c.id();
    }
}

// In the layout of any forces: the same rate c / m for all, of one block, of blocks for groups, and in proportion to
// masses that differ.
TEST(Damping, equal_drag_has_the_same_bits_however_it_is_written) {
    const std::string pair =
        "[[particles]]\ngroup = \"a\"\nvelocity = [1, 0, 0]\n"
        "[[particles]]\ngroup = \"b\"\nposition = [5, 1, 0]\nvelocity = [0, 0.5, 0]\n"
        "[[springs]]\npairs = [[\"a\", \"b\"]]\nk = 2\n";
    const std::string all = "[[fields]]\ndrag = 0.5\n";
    const std::string by_groups =
        "[[fields]]\nparticles = \"b\"\ndrag = 0.25\n[[fields]]\nparticles = \"a\"\ndrag = 0.125\n"
        "[[fields]]\ndrag = 0.25\n[[fields]]\nparticles = \"a\"\ndrag = 0.125\n";
    const std::string heavy = replaced(pair, "velocity = [0, 0.5, 0]\n", "velocity = [0, 0.5, 0]\nmass = 4\n");
    const std::string in_proportion =
        "[[fields]]\nparticles = \"a\"\ndrag = 0.5\n[[fields]]\nparticles = \"b\"\ndrag = 2\n";
    const std::string in_parts = "[[fields]]\ndrag = 0.5\n[[fields]]\nparticles = \"b\"\ndrag = 1.5\n";
    for (const MethodCase& c : working_methods()) {
        const auto hash = [&](const std::string& text) { return hash_after(run_of_text(text, c, 0.01), 20); };
        EXPECT_EQ(hash(pair + by_groups), hash(pair + all)) << c.id();
        EXPECT_EQ(hash(heavy + in_parts), hash(heavy + in_proportion)) << c.id();
        EXPECT_NE(hash(pair + all), hash(pair)) << c.id();
        EXPECT_NE(hash(heavy + in_proportion), hash(heavy)) << c.id();
    }
}

// The oscillator in the layout of any forces, where a field that pulls at nothing keeps it: the same operations on a
// single spring. Taylor's method sums the series of the two layouts in another order.
TEST(Damping, equal_drag_of_any_forces_is_the_drag_of_models) {
    const std::string oscillator =
        "[[particles]]\ngroup = \"anchor\"\nfixed = true\n[[particles]]\ngroup = \"mass\"\nvelocity = [1, 0, 0]\n"
        "[[springs]]\npairs = [[\"anchor\", \"mass\"]]\nk = 1\n[[fields]]\ndrag = 0.5\npotential = \"0*x\"\n";
    const auto sums_alike = [](const MethodCase& c) { return c.id() != "taylor"; };
    for (const MethodCase& c : working_methods_where(sums_alike)) {
        const RunDescription model = run_of("oscillator", c.id(), c.precision, 0.01, {{"c", 0.5}});
        const RunDescription composed = run_of_text(oscillator, c, 0.01);
        EXPECT_TRUE(std::holds_alternative<ComposedForces>(plan_of(composed).forces));
        EXPECT_EQ(hash_after(composed, 20), hash_after(model, 20)) << c.id();
    }
}

}  // namespace
}  // namespace steplab::test
