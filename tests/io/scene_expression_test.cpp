// Potentials that scene files write as expressions.

#include "io/scene_writer.hpp"
#include "sim/run/simulation.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace steplab::test {
namespace {

using testing::HasSubstr;

const std::string salt = R"toml(steplab = 1
[parameters]
A = 4
rho = { value = 0.5, range = [0.1, 1] }
two = 2

[[particles]]
charge = 1
[[particles]]
position = [1.5, 0.2, 0]
charge = -1
mass = 2

[[pairs]]
potential = "A*exp(-r/rho) + q1*q2/r - C/r^6"
C = "two / 4"

[[fields]]
potential = "w/2*(x^2 + y^2 + 2*z^2)"
w = 0.3
)toml";

TEST(SceneExpression, every_method_but_those_of_2008_runs_it) {
    for (const MethodCase& c : working_methods()) {
        RunDescription run = with_method(describe(read_scene(salt)), c.id());
        run.precision = c.precision;
        EXPECT_NO_THROW(check(run)) << c.id();
    }
}

// A series at one side of a seam knows nothing of the other.
TEST(SceneExpression, with_a_seam_is_refused_by_taylor_alone) {
    const std::string potential = "A*exp(-r/rho) + q1*q2/r - C/r^6", field = "w/2*(x^2 + y^2 + 2*z^2)";
    const std::string seamed[] = {replaced(salt, potential, "A*exp(-r/rho) + C*max(0, 1 - r)^2.5"),
                                  replaced(salt, potential, "A*exp(-r/rho) + C*abs(r - 2)"),
                                  replaced(salt, field, "w/2*min(x^2, 1)")};
    for (const std::string& text : seamed) {
        for (const MethodCase& c : working_methods()) {
            const RunDescription run = with_method(describe(read_scene(text)), c.id());
            if (c.id() == "taylor") {
                EXPECT_THROW(check(run), UsageError) << text;
            } else {
                EXPECT_NO_THROW(check(run)) << c.id();
            }
        }
    }
}

// The root of x = 0 has no series, and x stays 0.
TEST(SceneExpression, without_a_series_where_it_rests_ends_the_run_of_taylor) {
    const std::string text = "steplab = 1\n[[particles]]\n[[fields]]\npotential = \"exp(-y) + 1e-3*x*sqrt(x)\"\n";
    RunDescription run = with_method(describe(read_scene(text)), "taylor");
    Simulation simulation(run);
    simulation.advance(100);
    ASSERT_TRUE(simulation.divergence());
    EXPECT_TRUE(simulation.divergence()->stop);
}

TEST(SceneExpression, its_parameters_apply_at_once) {
    RunDescription run = describe(read_scene(salt));
    for (const ParameterInfo& info : run.scene.infos()) EXPECT_EQ(info.on_change, OnChange::applies_live) << info.name;
    const Frame before = frame_after(run, 10);
    run.scene.set("rho", 0.6);
    EXPECT_NE(distance(before, frame_after(run, 10)), 0);
}

TEST(SceneExpression, written_and_read_again_is_the_same_run) {
    RunDescription run = describe(read_scene(salt));
    run.scene.set("A", 3.5);
    run.method = "rk4";
    run.dt = 0.01;
    const std::string text = scene_file_text(run);
    const RunDescription again = describe(read_scene(text));
    EXPECT_EQ(distance(frame_after(run, 200), frame_after(again, 200)), 0) << text;
    EXPECT_THAT(text, HasSubstr("potential = \"A*exp(-r/rho) + q1*q2/r - C/r^6\""));
}

TEST(SceneExpression, says_what_is_wrong_and_where) {
    const std::string potential = "\"A*exp(-r/rho) + q1*q2/r - C/r^6\"";
    const std::pair<std::string, std::string> cases[] = {
        {replaced(salt, potential, "\"A*exp(-r/rh) - C*q1\""),
         "a.toml:15:13: unknown name 'rh'; known: r, m1, m2, q1, q2, C, A, rho, two"},
        {replaced(salt, potential, "\"A*exp(-r/rho)\""), "a.toml:16:5: the potential does not use 'C'"},
        {replaced(salt, potential, "\"A*exp(-r/rho\""), "character 13: expected ')'"},
        {replaced(salt, potential, "\"A*foo(r) - C\""), "unknown function 'foo'"},
        {replaced(salt, potential, "\"mors\""), "a.toml:15:13: unknown potential 'mors' (did you mean 'morse'?)"},
        {replaced(salt, "C = ", "r = 1\nC = "), "a.toml:16:5: the potential does not use 'r'"},
        {replaced(salt, "w = 0.3\n", ""), "a.toml:19:13: unknown name 'w'"},
        {replaced(salt, "w = 0.3\n", "w = 0.3\nv = 1\n"), "a.toml:21:5: the potential does not use 'v'"},
        {replaced(salt, "w/2*(x^2", "w/2*(log(x)"),
         "a.toml:19:13: the potential is not finite where particle 0 starts"},
        {replaced(salt, "potential = \"w/2*(x^2 + y^2 + 2*z^2)\"\n", "gravity = [0, 0, 1]\n"),
         "a.toml:20:5: unknown key 'w'"},
        {replaced(salt, potential, '"' + std::string(100000, '(') + '"'), "nested more than 200 deep"},
        {replaced(
             salt, potential,
             "\"A" +
                 [] {
                     std::string sum;
                     for (int k = 0; k < 20000; ++k) sum += "+r";
                     return sum;
                 }() +
                 '"'),
         "has more than 10000 numbers, names and operations"}};
    for (const auto& [text, message] : cases) EXPECT_THAT(refusal_of_scene(text), HasSubstr(message));
}

// Potentials that name masses or charges tell the two groups apart, whichever is numbered first.
TEST(SceneExpression, first_and_second_are_those_of_between) {
    const auto force_on_heavy = [](const std::string& between, const std::string& potential) {
        const std::string text =
            "steplab = 1\n[[particles]]\ngroup = \"light\"\n[[particles]]\ngroup = \"heavy\"\n"
            "position = [2, 0, 0]\nmass = 5\n[[pairs]]\nbetween = " +
            between + "\npotential = \"" + potential + "\"\n";
        const RunDescription run = describe(read_scene(text));
        return frame_after(with_method(run, "euler"), 1).velocities[1].x;
    };
    EXPECT_EQ(force_on_heavy("[\"heavy\", \"light\"]", "m1*m2^2*r"),
              force_on_heavy("[\"light\", \"heavy\"]", "m2*m1^2*r"));
    EXPECT_NE(force_on_heavy("[\"heavy\", \"light\"]", "m1*m2^2*r"),
              force_on_heavy("[\"light\", \"heavy\"]", "m1*m2^2*r"));
}

}  // namespace
}  // namespace steplab::test
