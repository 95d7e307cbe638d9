// Scenes from files whose motion is known in closed form, with every method that steps them.

#include "core/number_text.hpp"
#include "sim/run/simulation.hpp"
#include "sim/run/starting.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
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

Frame after(const RunDescription& run, std::uint64_t steps) {
    Simulation simulation(run);
    simulation.advance(steps);
    EXPECT_FALSE(simulation.divergence());
    return simulation.frame();
}

const std::string dimer = R"(
[[particles]]
group = "light"
mass = 1
velocity = [0.3, 0, 0]
[[particles]]
group = "heavy"
position = [1, 0, 0]
mass = 3
velocity = [-0.1, 0, 0]
[[springs]]
pairs = [["light", "heavy"]]
k = 2
)";

class SceneAnswers : public testing::TestWithParam<MethodCase> {};

/// In steps of a hundredth of the period; a method of order 1 is off by some tenths of the amplitude then.
double allowed(const MethodCase& c, double amplitude) {
    const double order = c.info->adaptive ? 8 : c.info->order;
    const double truncation = c.info->adaptive ? 1e-6 : 2 * std::pow(2 * std::numbers::pi / 100, order) * 6;
    return amplitude * (truncation + (c.precision == Precision::float_ ? 1e-4 : 1e-9));
}

// Reduced mass 3/4: omega = sqrt(k / mu); the centre of mass rests.
TEST_P(SceneAnswers, two_masses_on_a_spring) {
    const double omega = std::sqrt(2 / 0.75), period = 2 * std::numbers::pi / omega;
    const Frame frame = after(run_of_text(dimer, GetParam(), period / 100), 30);
    const double t = frame.time, stretch = -0.4 / omega * std::sin(omega * t);
    const double amplitude = 0.4 / omega;
    EXPECT_NEAR(frame.positions[0].x, -0.75 * stretch, allowed(GetParam(), amplitude));
    EXPECT_NEAR(frame.positions[1].x, 1 + 0.25 * stretch, allowed(GetParam(), amplitude));
    EXPECT_EQ(frame.positions[0].y, 0);
}

const std::string kepler = R"(
[[particles]]
mass = 3
velocity = [0, -0.25, 0]
[[particles]]
position = [1, 0, 0]
velocity = [0, 0.75, 0]
[[pairs]]
potential = "gravity"
G = 0.25
)";

// The distance stays 1 on a circle: G (m1 + m2) / r^2 = v^2 / r with v = 1, so the period is 2 pi.
TEST_P(SceneAnswers, two_stars_on_a_circle) {
    const Frame frame = after(run_of_text(kepler, GetParam(), 2 * std::numbers::pi / 100), 30);
    const Vec3 apart = frame.positions[1] - frame.positions[0];
    EXPECT_NEAR(apart.x, std::cos(frame.time), allowed(GetParam(), 1));
    EXPECT_NEAR(apart.y, std::sin(frame.time), allowed(GetParam(), 1));
    EXPECT_EQ(apart.z, 0);
}

// The spring of the dimer, typed: every method takes it, and comes to the same motion.
TEST_P(SceneAnswers, two_masses_held_by_a_typed_potential) {
    const std::string typed = replaced(dimer, "[[springs]]\npairs = [[\"light\", \"heavy\"]]\nk = 2\n",
                                       "[[pairs]]\npotential = \"stiffness / 2 * (r - 1)^2\"\nstiffness = 2\n");
    const double omega = std::sqrt(2 / 0.75), period = 2 * std::numbers::pi / omega;
    const Frame frame = after(run_of_text(typed, GetParam(), period / 100), 30);
    const double stretch = -0.4 / omega * std::sin(omega * frame.time), amplitude = 0.4 / omega;
    EXPECT_NEAR(frame.positions[0].x, -0.75 * stretch, allowed(GetParam(), amplitude));
    EXPECT_NEAR(frame.positions[1].x, 1 + 0.25 * stretch, allowed(GetParam(), amplitude));
}

// In the field m omega^2 / 2 (x^2 + 4 y^2): x = cos(omega t), y = sin(2 omega t), whatever the mass.
TEST_P(SceneAnswers, masses_in_a_typed_field) {
    const std::string text = R"toml(
[parameters]
omega = 1.5
[[particles]]
position = [1, 0, 0]
velocity = [0, "2 * omega", 0]
mass = 3
[[particles]]
position = [1, 0, 0]
velocity = [0, "2 * omega", 0]
mass = 0.5
[[fields]]
potential = "m * omega^2 / 2 * (x^2 + stretch * y^2)"
stretch = 4
)toml";
    const Frame frame = after(run_of_text(text, GetParam(), std::numbers::pi / 1.5 / 100), 30);
    const double phase = 1.5 * frame.time;
    for (const Vec3& at : frame.positions) {
        EXPECT_NEAR(at.x, std::cos(phase), allowed(GetParam(), 1));
        EXPECT_NEAR(at.y, std::sin(2 * phase), allowed(GetParam(), 1));
        EXPECT_EQ(at.z, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, SceneAnswers, testing::ValuesIn(working_methods()), case_name);

// A pair in its minimum swings with sqrt(V'' / mu): V'' is 57.146 epsilon / sigma^2 for Lennard-Jones (r = 2^(1/6)
// sigma), k for Morse. Small swings: the next term changes the period by the square of the amplitude.
TEST(SceneAnswer, dimers_swing_with_the_frequency_of_their_minimum) {
    const double minimum = std::pow(2.0, 1.0 / 6);
    const std::pair<std::string, double> cases[] = {
        {"potential = \"lennard-jones\"\nepsilon = 1\nsigma = 1\n", 72 / std::cbrt(2.0)},
        {"potential = \"morse\"\nD = 1\nk = 40\nr0 = " + number_text(minimum) + "\n", 40}};
    for (const auto& [potential, stiffness] : cases) {
        const double omega = std::sqrt(stiffness / 0.5), amplitude = 1e-5;
        const std::string text = "[[particles]]\n[[particles]]\nposition = [" + number_text(minimum + amplitude) +
                                 ", 0, 0]\n[[pairs]]\n" + potential;
        const RunDescription run = run_of_text(text, {&method("rk4").info, Precision::double_}, 0.02 / omega);
        const Frame frame = after(run, 1000);
        const double stretch = frame.positions[1].x - frame.positions[0].x - minimum;
        EXPECT_NEAR(stretch, amplitude * std::cos(omega * frame.time), 0.01 * amplitude) << potential;
    }
}

// The figure of eight of three equal masses (Chenciner, Montgomery 2000); Simo's initial values, period 6.3259139.
TEST(SceneAnswer, three_bodies_return_on_a_figure_of_eight) {
    const std::string text = R"(
[[particles]]
position = [0.97000436, -0.24308753, 0]
velocity = [0.466203685, 0.43236573, 0]
[[particles]]
position = [-0.97000436, 0.24308753, 0]
velocity = [0.466203685, 0.43236573, 0]
[[particles]]
velocity = [-0.93240737, -0.86473146, 0]
[[pairs]]
potential = "gravity"
G = 1
)";
    const RunDescription run = run_of_text(text, {&method("ias15").info, Precision::double_}, 6.3259139 / 100);
    const Frame start = after(run, 0), end = after(run, 100);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LT(length(end.positions[i] - start.positions[i]), 1e-6) << i;  // values of eight digits
}

// Released at rest where V = -D + E, a Morse pair is at exp(b (r - r0)) = (1 + s cos(omega t)) / (1 - s^2), s^2 = E /
// D, omega = sqrt(k / mu) sqrt(1 - E / D), as the law of energy mu r'^2 / 2 + V = E - D shows: the period grows from
// that of the minimum to infinity at E = D. Masses of 1 and 3: mu = 3/4, and the layout of any forces.
TEST(SceneAnswer, a_morse_pair_has_the_motion_and_the_period_of_its_energy) {
    constexpr double D = 1.5, k = 12, r0 = 1.2, mu = 0.75;
    const double b = std::sqrt(k / (2 * D));
    const auto solves_to_a_tolerance = [](const MethodCase& c) {
        return c.precision == Precision::double_ && (c.info->adaptive || c.info->order > 8);
    };
    for (const double energy : {0.01, 0.5, 0.75, 0.96}) {  // E / D
        const double s = std::sqrt(energy), omega = std::sqrt(k / mu) * std::sqrt(1 - energy);
        const double start = r0 - std::log(1 - s) / b, period = 2 * std::numbers::pi / omega;
        const std::string text = "[[particles]]\n[[particles]]\nposition = [0, " + number_text(start) +
                                 ", 0]\nmass = 3\n[[pairs]]\npotential = \"morse\"\nD = 1.5\nk = 12\nr0 = 1.2\n";
        for (const MethodCase& c : working_methods_where(solves_to_a_tolerance)) {
            RunDescription run = run_of_text(text, c, period / 16);
            EXPECT_TRUE(std::holds_alternative<ComposedForces>(plan_of(run).forces));
            run.method_parameters.set("tolerance", 1e-13);
            Simulation simulation(run);
            for (int step = 1; step <= 32; ++step) {
                simulation.advance(1);
                const Frame frame = simulation.frame();
                const double r = frame.positions[1].y - frame.positions[0].y;
                const double right = r0 + std::log((1 + s * std::cos(omega * frame.time)) / (1 - s * s)) / b;
                // tolerances of 1e-13 in two periods; a shift in time grows with the speeds near E = D
                EXPECT_NEAR(r, right, 1e-10) << c.id() << " E / D " << energy << ", step " << step;
                EXPECT_NEAR(frame.positions[0].y + 3 * (frame.positions[1].y - start), 0, 1e-11);
            }
        }
        // in small steps: back where it began after one period and not sooner, off by the second order of 1 / 2000
        const Frame back =
            after(run_of_text(text, {&method("velocity-verlet").info, Precision::double_}, period / 2000), 2000);
        EXPECT_NEAR(back.positions[1].y - back.positions[0].y, start, 1e-3 * (start - r0)) << energy;
        const Frame half = after(run_of_text(text, {&method("rk4").info, Precision::double_}, period / 2000), 1000);
        EXPECT_NEAR(half.positions[1].y - half.positions[0].y, r0 - std::log(1 + s) / b, 1e-8) << energy;
    }
}

// The modes of two masses between walls with k, K, k are
// sqrt(k / m) and sqrt((k + 2 K) / m); a start in both beats.
TEST(SceneAnswer, two_masses_between_walls_beat) {
    const std::string text = R"(
[[particles]]
group = "walls"
line = { count = 2, step = [3, 0, 0] }
fixed = true
[[particles]]
group = "masses"
position = [1, 0, 0]
line = { count = 2, step = [1, 0, 0] }
[[fix]]
particles = "masses[0]"
displacement = [0.1, 0, 0]
[[springs]]
pairs = [["walls[0]", "masses[0]"], ["masses[1]", "walls[1]"]]
k = 4
[[springs]]
between = "masses"
k = 0.5
)";
    const Frame frame = after(run_of_text(text, {&method("rk4").info, Precision::double_}, 0.005), 4000);
    const double t = frame.time, slow = std::cos(2 * t), fast = std::cos(std::sqrt(5.0) * t);
    EXPECT_NEAR(frame.positions[2].x, 1 + 0.05 * (slow + fast), 1e-8);  // fourth order, 45 radians
    EXPECT_NEAR(frame.positions[3].x, 2 + 0.05 * (slow - fast), 1e-8);
}

}  // namespace
}  // namespace steplab::test
