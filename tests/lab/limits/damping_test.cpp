// Limits of scenes with dashpots, and drag that differs between particles.

#include "lab/limits/limits.hpp"
#include "sim/run/linear_limit.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace steplab::test {
namespace {

RunDescription damped(const std::string& scene, std::string_view method) {
    return with_method(describe(read_scene("steplab = 1\n" + scene)), method);
}

const std::string chain = "[[particles]]\ngroup = \"a\"\nline = { count = 20, step = [1, 0, 0] }\n";
const std::string pair_of_masses =
    "[[particles]]\ngroup = \"a\"\n[[particles]]\ngroup = \"b\"\nposition = [1, 0, 0]\nmass = 4\n";
const std::string on_chain = "[[springs]]\nbetween = \"a\"\nk = 1\ndamping = ";
const std::string on_pair = "[[springs]]\npairs = [[\"a\", \"b\"]]\nk = 1\ndamping = ";

TEST(Damping, rate_is_that_of_the_motion_that_dashpots_damp_most) {
    EXPECT_DOUBLE_EQ(facts_of(damped(pair_of_masses + on_pair + "8\n", "rk4")).drag, 8 * (1 + 0.25));
    const std::string held = "[[fix]]\nparticles = \"b\"\nfixed = true\n";
    EXPECT_DOUBLE_EQ(facts_of(damped(pair_of_masses + on_pair + "8\n" + held, "rk4")).drag, 8);
    EXPECT_DOUBLE_EQ(facts_of(damped(chain + on_chain + "10\n", "rk4")).drag, 40);
    const std::string drag = "[[fields]]\nparticles = \"a\"\ndrag = 3\n";
    EXPECT_DOUBLE_EQ(facts_of(damped(pair_of_masses + on_pair + "8\n" + drag, "rk4")).drag, 13);
}

// Bisection to 3e-5; nothing else is between the two where dashpots go along springs.
TEST(Damping, theory_and_runs_agree_where_dashpots_go_along_springs) {
    for (const char* method : {"rk4", "midpoint", "euler-forward"}) {
        for (const std::string& scene : {chain + on_chain + "10\n", chain + on_chain + "0.5\n",
                                         pair_of_masses + on_pair + "10\n", pair_of_masses + on_pair + "0.3\n"}) {
            const RunDescription run = damped(scene, method);
            const Limit limit = StabilityLab(run).limit(run);
            ASSERT_TRUE(limit.theory && limit.measured) << method;
            EXPECT_NEAR(*limit.measured / *limit.theory, 1, 1e-3) << method << '\n' << scene;
            EXPECT_GT(
                std::abs(linear_limit(run, limit.omega_max) /
                             linear_limit(steplab::method(run.method), run.method_parameters, limit.omega_max, 0) -
                         1),
                0.01)
                << "damping matters: " << method << '\n'
                << scene;
        }
    }
}

/// Whether a run that begins with a small displacement of one particle is over within some thousand steps.
bool diverges(RunDescription run, double dt) {
    run.dt = dt;
    Simulation simulation(run);
    simulation.advance(4096);
    simulation.conclude();
    return simulation.divergence().has_value();
}

// Where damping mixes vibrations the limit is a bound: at 0.99 of it runs go on, and not far beyond they do not.
TEST(Damping, limit_is_a_bound_where_particles_are_damped_unequally) {
    const std::string one = "[[fields]]\nparticles = [\"a[3]\"]\ndrag = 50\n",
                      moved = "[[fix]]\nparticles = [\"a[3]\"]\ndisplacement = [0.01, 0, 0]\n";
    for (const std::string& scene : {chain + moved + on_chain + "0\n" + one, chain + moved + on_chain + "3\n" + one}) {
        const RunDescription run = damped(scene, "rk4");
        const Limit limit = StabilityLab(run).limit(run);
        ASSERT_TRUE(limit.theory);
        EXPECT_FALSE(limit.measured);
        EXPECT_THAT(limit.note, testing::HasSubstr("a bound"));
        EXPECT_FALSE(diverges(run, 0.99 * *limit.theory)) << scene;
        EXPECT_TRUE(diverges(run, 1.5 * *limit.theory)) << scene;
    }
}

}  // namespace
}  // namespace steplab::test
