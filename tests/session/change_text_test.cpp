#include "session/change_text.hpp"

#include "session/changed_run.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

RunDescription told_chain() { return run_of("chain", "rk4", Precision::double_, 0.1); }

std::string text_of_change(const RunDescription& before, const RunDescription& run) {
    return text_of({0, before}, {5, run});
}

RunDescription altered(const std::vector<Alteration>& alterations) {
    return with_alterations(told_chain(), alterations);
}

TEST(ChangeText, names_each_setting_that_differs) {
    RunDescription run = with(with(told_chain(), "dt", 0.25), "k", 2);
    EXPECT_EQ(text_of_change(told_chain(), run), "dt 0.25, k 2");
    run = with_method(run, "verlet");
    run.precision = Precision::float_;
    EXPECT_EQ(text_of_change(told_chain(), run), "method verlet, precision float, dt 0.25, k 2");
}

TEST(ChangeText, of_particles_says_what_became_of_them) {
    const RunDescription one = altered({{5, true}}), two = altered({{5, true}, {3, true}}),
                         heavy = altered({{5, std::nullopt, 2.5}});
    EXPECT_EQ(text_of_change(told_chain(), one), "particle 5 fixed");
    EXPECT_EQ(text_of_change(one, altered({{5, false}})), "particle 5 free");
    EXPECT_EQ(text_of_change(one, told_chain()), "particle 5 free");
    EXPECT_EQ(text_of_change(told_chain(), two), "2 particles fixed");
    EXPECT_EQ(text_of_change(one, two), "particle 3 fixed");
    EXPECT_EQ(text_of_change(told_chain(), heavy), "mass 2.5 kg of particle 5");
    EXPECT_EQ(text_of_change(heavy, told_chain()), "mass of particle 5");
}

TEST(ChangeText, of_an_act_counts_its_particles) {
    const auto text_of_act = [](const Act& act) { return text_of({0, told_chain()}, {5, told_chain(), act}); };
    EXPECT_EQ(text_of_act(Kick{5, {1, 0, 0}}), "kick of particle 5");
    EXPECT_EQ(text_of_act(Pull{5, {1, 0, 0}, ParticleList({2, 3})}), "pull of 3 particles");
    EXPECT_EQ(text_of_act(Tug{5, {1, 0, 0}, 4}), "pull of particle 5");
    EXPECT_EQ(text_of_act(TurnRound{}), "velocities turned round");
}

}  // namespace
}  // namespace steplab::test
