// Springs with a pair potential of their own: what is known of Toda's chain, what they share with other springs, and
// what is refused.

#include "core/number_text.hpp"
#include "io/scene_writer.hpp"
#include "models/scene/scene_facts.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/pair_law.hpp"
#include "sim/run/simulation.hpp"
#include "sim/run/starting.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string exponential = "potential = \"exp(1 - r) + r - 1\"\n";

/// A row of three particles, 1 m apart, the first of which moves; then these blocks.
std::string row_and(const std::string& blocks) {
    return "steplab = 1\n[[particles]]\ngroup = \"row\"\nline = { count = 3, step = [1, 0, 0] }\n"
           "[[fix]]\nparticles = \"row[0]\"\nvelocity = [0.3, 0.1, 0]\n" +
           blocks;
}

Frame after(const std::string& text, const MethodCase& method, double dt, std::uint64_t steps) {
    RunDescription run = with_method(describe(read_scene(text)), method.id());
    run.precision = method.precision;
    run.dt = dt;
    return frame_after(run, steps);
}

/// One soliton on a ring of n particles, of which kappa is the inverse width (Toda, Theory of Nonlinear Lattices, 3.2):
/// exp(-(r_j - 1)) = 1 + (sinh kappa / cosh(kappa j - beta t))^2, beta = sinh kappa.
struct Soliton {
    double kappa = 1;
    int n = 40;

    double phase(int j, double t) const { return kappa * (j - n / 2) - std::sinh(kappa) * t; }
    double position(int j, double t) const { return j + std::log(std::cosh(phase(j - 1, t)) / std::cosh(phase(j, t))); }
    double velocity(int j, double t) const {
        return std::sinh(kappa) * (std::tanh(phase(j, t)) - std::tanh(phase(j - 1, t)));
    }
    /// It shortens the ring.
    std::string text() const {
        std::string particles;
        for (int j = 0; j < n; ++j)
            particles += "[[particles]]\nposition = [" + number_text(position(j, 0)) + ", 0, 0]\nvelocity = [" +
                         number_text(velocity(j, 0)) + ", 0, 0]\n";
        std::string pairs;
        for (int j = 0; j < n; ++j)
            pairs += (j > 0 ? ", [" : "[") + std::to_string(j) + ", " + std::to_string((j + 1) % n) + "]";
        return "steplab = 1\n" + particles + "[[springs]]\npairs = [" + pairs + "]\n" + exponential +
               "[box]\nsize = [" + number_text(n - 2 * kappa) + ", 0, 0]\n";
    }
};

class SpringPotentials : public testing::TestWithParam<MethodCase> {};

TEST_P(SpringPotentials, carry_the_soliton_of_toda) {
    const MethodCase& c = GetParam();
    const Soliton soliton;
    const Frame frame = after(soliton.text(), c, 0.02, 50);
    // in steps of 0.02 where nothing changes faster than within 1 / beta = 0.85 s, for 1 s
    const double truncation = c.info->adaptive ? 1e-5 : 2 * std::pow(0.02 / 0.85, c.info->order);
    const double allowed = truncation + (c.precision == Precision::float_ ? 1e-4 : 1e-9);
    double moved = 0;
    for (int j = 0; j < soliton.n; ++j) {
        const double right = soliton.position(j, frame.time);
        EXPECT_NEAR(frame.positions[static_cast<std::size_t>(j)].x, right, allowed) << j;
        moved = std::max(moved, std::abs(right - soliton.position(j, 0)));
    }
    EXPECT_GT(moved, 10 * allowed) << "at its place it would have been noticed";
}

INSTANTIATE_TEST_SUITE_P(Catalogue, SpringPotentials, testing::ValuesIn(working_methods()), case_name);

/// Sum of the fourth powers of the eigenvalues of Flaschka's matrix L, which the motion keeps: L has b v_j / 2 on its
/// diagonal and exp(-b (r_j - 1) / 2) / 2 beside it (Flaschka 1974, Phys. Rev. B 9, 1924, in the units of the scene).
double fourth_trace(const Frame& frame, double b, double period) {
    const std::size_t n = frame.positions.size();
    const auto on = [&](std::size_t j) { return b * frame.velocities[j % n].x / 2; };
    const auto beside2 = [&](std::size_t j) {
        const double r = frame.positions[(j + 1) % n].x - frame.positions[j % n].x + (j % n + 1 == n ? period : 0);
        return std::exp(b * (1 - r)) / 4;
    };
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) {
        const double both = on(j) * on(j) + on(j) * on(j + 1) + on(j + 1) * on(j + 1);
        sum +=
            std::pow(on(j), 4) + 4 * beside2(j) * both + 2 * beside2(j) * beside2(j) + 4 * beside2(j) * beside2(j + 1);
    }
    return sum;
}

TEST(SpringPotential, of_toda_keeps_what_that_of_its_first_terms_does_not) {
    const std::string toda = "exp(-b*(r - 1))/b^2 + (r - 1)/b";
    const auto change = [&](const std::string& potential) {
        const std::string text = find_scene("toda-ring")->parts.front().content;
        RunDescription run = with_method(describe(read_scene(replaced(text, toda, potential))), "gauss-16");
        run.dt = 0.1;
        const Frame start = frame_after(run, 0), end = frame_after(run, 500);
        const double b = run.scene["b"], before = fourth_trace(start, b, 64);
        return std::abs(fourth_trace(end, b, 64) - before) / before;
    };
    EXPECT_LT(change(toda), 1e-12);  // a method of order 16, roundings of 500 steps
    EXPECT_GT(change("(r - 1)^2/2 - b*(r - 1)^3/6 + b^2*(r - 1)^4/24"), 1e-4);
}

TEST(SpringPotential, of_two_particles_moves_them_as_a_pair_force_does) {
    const std::string two = "steplab = 1\n[[particles]]\ngroup = \"two\"\nline = { count = 2, step = [0.8, 0.1, 0] }\n";
    for (const std::string& values : {exponential, std::string("potential = \"morse\"\nD = 1\nk = 20\nr0 = 1\n")}) {
        for (const MethodCase& c : working_methods()) {
            const Frame along = after(two + "[[springs]]\nbetween = \"two\"\n" + values, c, 0.01, 40);
            const Frame between = after(two + "[[pairs]]\nbetween = [\"two\"]\n" + values, c, 0.01, 40);
            if (c.info->adaptive) {
                EXPECT_LT(distance(along, between), 1e-5) << c.id();  // their first step may differ
            } else {
                EXPECT_LT(distance(along, between), c.precision == Precision::float_ ? 1e-5 : 1e-13) << c.id();
            }
        }
    }
}

TEST(SpringPotential, acts_between_the_ends_of_its_springs_alone) {
    const MethodCase rk4{&method("rk4").info, Precision::double_};
    const Frame neighbours = after(row_and("[[springs]]\nbetween = \"row\"\n" + exponential), rk4, 0.01, 50);
    const Frame listed =
        after(row_and("[[springs]]\npairs = [[\"row[1]\", \"row[0]\"], [\"row[1]\", \"row[2]\"]]\n" + exponential), rk4,
              0.01, 50);
    const Frame all = after(row_and("[[pairs]]\n" + exponential), rk4, 0.01, 50);
    EXPECT_EQ(distance(neighbours, listed), 0);
    EXPECT_GT(distance(neighbours, all), 1e-3);
    const Frame twice = after(row_and("[[springs]]\nbetween = \"row\"\npairs = [[\"row[0]\", \"row[1]\"], [\"row[1]\", "
                                      "\"row[2]\"]]\n" +
                                      exponential),
                              rk4, 0.01, 50);
    EXPECT_GT(distance(neighbours, twice), 1e-3) << "two springs between the same ends are two";
}

TEST(SpringPotential, has_a_dashpot_beside_it) {
    const MethodCase rk4{&method("rk4").info, Precision::double_};
    const std::string spring = "[[springs]]\nbetween = \"row\"\n", damper = "damping = 0.5\n";
    const Frame together = after(row_and(spring + exponential + damper), rk4, 0.01, 50);
    const Frame apart = after(row_and(spring + exponential + spring + "k = 0\n" + damper), rk4, 0.01, 50);
    const Frame none = after(row_and(spring + exponential), rk4, 0.01, 50);
    EXPECT_LT(distance(together, apart), 1e-15);
    EXPECT_GT(distance(together, none), 1e-3);
}

TEST(SpringPotential, is_drawn_listed_and_written_as_springs) {
    const std::string text = row_and("[[springs]]\nbetween = \"row\"\npotential = \"morse\"\nD = 2\nk = 9\nr0 = 1.1\n");
    const RunDescription run = describe(read_scene(text));
    const Shape shape = model_of(run).shape(run.scene);
    ASSERT_EQ(shape.springs.size(), 2U);
    EXPECT_EQ(shape.springs[1].first, 1U);
    const SceneFacts facts = facts_of(model_of(run).scene(run.scene));
    EXPECT_NEAR(facts.bond, 1.1, 1e-9);
    EXPECT_NEAR(facts.pair_frequency, std::sqrt(2 * 9.0), 1e-6);
    const RunDescription again = describe(read_scene(scene_file_text(run)));
    EXPECT_EQ(model_of(again).scene(again.scene), model_of(run).scene(run.scene));
    EXPECT_EQ(Simulation(again).hash(), Simulation(run).hash());
    const std::vector<PairLaw> laws = pair_laws(run);
    ASSERT_EQ(laws.size(), 1U);
    EXPECT_EQ(laws[0].name, "morse");
    EXPECT_THAT(distances_now(laws[0], frame_after(run, 0), 10), ElementsAre(1, 1));
}

// One spring of gravity is a Kepler pair; two between the same ends pull twice as much, and are none.
TEST(SpringPotential, of_gravity_is_an_ellipse_if_it_is_one_spring) {
    const auto exact = [](const std::string& pairs) {
        const std::string text =
            "steplab = 1\n[[particles]]\n[[particles]]\nposition = [1, 0, 0]\nvelocity = [0, 1, 0]\n"
            "[[springs]]\npairs = [" +
            pairs + "]\npotential = \"gravity\"\nG = 1\n";
        RunDescription run = with_method(describe(read_scene(text)), "dop853");
        run.dt = 0.01;
        Simulation simulation(run);
        simulation.advance(100);
        return simulation.diagnostics().error;
    };
    const auto once = exact("[0, 1]");
    ASSERT_TRUE(once);
    EXPECT_LT(*once, 1e-6);
    EXPECT_FALSE(exact("[0, 1], [0, 1]"));
}

// Its particles feel those at its ends: linear systems of many stay sparse.
TEST(SpringPotential, couples_neighbours_alone) {
    const RunDescription run = describe(read_scene(row_and("[[springs]]\nbetween = \"row\"\n" + exponential)));
    const Coupling coupling =
        std::visit([](const auto& forces) { return steplab::coupling(forces); }, plan_of(run).forces);
    EXPECT_EQ(coupling.kind, Coupling::Kind::near);
}

TEST(SpringPotential, of_a_wrong_text_is_refused_at_its_place) {
    const std::vector<std::pair<std::string, const char*>> cases{
        {"potential = \"mores\"\n", "a.toml:11:13: unknown potential 'mores'"},
        {"potential = \"morse\"\nD = 1\nk = 1\n", "the potential morse needs a value of r0"},
        {"potential = \"morse\"\nD = 1\nk = 1\nr0 = 1\nquadratic = 1\n", "a.toml:15:13: unknown value 'quadratic'"},
        {"potential = \"r^2\"\nlength = 1\n", "a.toml:12:10: the potential does not use 'length'"},
        {"potential = \"r^2\"\ncutoff = 1\n", "the potential does not use 'cutoff'"},
        {"potential = \"r^2 + z\"\n", "unknown name 'z'"},
        {"potential = \"log(r - 1)\"\n", "a.toml:11:13: the potential is not finite at r = 1"},
        {"potential = \"log(-1 - r)\"\n", "the potential is finite at no distance r"},
        {"potential = 3\n", "a.toml:11:13: must be a text"},
        {"", "needs k, the force constant, or a potential"},
        {"pontential = \"r^2\"\n", "unknown key 'pontential' of [[springs]] (did you mean 'potential'?)"}};
    for (const auto& [text, reason] : cases)
        EXPECT_THAT(refusal_of_scene(row_and("\n[[springs]]\nbetween = \"row\"\n" + text)), HasSubstr(reason)) << text;
}

}  // namespace
}  // namespace steplab::test
