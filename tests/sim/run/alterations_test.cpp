#include "sim/run/alterations.hpp"

#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace steplab::test {
namespace {

RunDescription altered(const RunDescription& run, std::vector<Alteration> alterations) {
    return with_alterations(run, alterations);
}

RunDescription small(const Model& model, Precision precision) {
    return small_run_of(model.info.id, "velocity-verlet", precision, 0.01);
}

TEST(Alterations, a_fixed_particle_of_every_model_stays_where_it_is) {
    for (const Precision precision : precisions) {
        for (const Model& model : models()) {
            Simulation run(small(model, precision));
            const std::size_t last = run.particles() - 1;
            run.act(Kick{last, {0.3, 0.2, 0.1}});
            run.advance(20);
            const Vec3 before = run.frame().positions[last];
            EXPECT_EQ(run.change(altered(run.description(), {{last, true}})), Change::continued) << model.info.id;
            EXPECT_EQ(run.step(), 20u);
            EXPECT_NEAR(length(run.frame().positions[last] - before), 0, 1e-6 * (1 + length(before))) << model.info.id;
            const Vec3 held = run.frame().positions[last];
            EXPECT_EQ(run.frame().velocities[last], Vec3{});
            EXPECT_EQ(run.shape()->roles[last], Role::fixed);
            run.advance(50);
            EXPECT_EQ(run.frame().positions[last], held) << model.info.id;
            EXPECT_EQ(run.change(altered(run.description(), {{last, false}})), Change::continued);
            run.act(Kick{last, {0.3, 0.2, 0.1}});
            run.advance(5);
            EXPECT_NE(run.frame().positions[last], held) << "it is free again: " << model.info.id;
        }
    }
}

TEST(Alterations, what_is_altered_moves_on_from_where_it_was) {
    for (const Precision precision : precisions) {
        for (const Model& model : models()) {
            Simulation run(small(model, precision));
            run.advance(20);
            const Frame before = run.frame();
            run.change(altered(run.description(), {{run.particles() - 1, std::nullopt, 5.0}}));
            const Frame now = run.frame();
            for (std::size_t i = 0; i < before.positions.size(); ++i) {
                ASSERT_NEAR(length(now.positions[i] - before.positions[i]), 0, 1e-6 * (1 + length(before.positions[i])))
                    << model.info.id;
                ASSERT_EQ(now.velocities[i], before.velocities[i]) << model.info.id;
            }
        }
    }
}

// Newton's second law: the same spring, five times the mass.
TEST(Alterations, a_heavier_particle_accelerates_less) {
    const RunDescription run = run_of("chain", "velocity-verlet", Precision::double_, 1e-4, {{"v0", 0}});
    const auto acceleration = [&](double mass) {
        Simulation simulation(altered(run, {{9, std::nullopt, mass}}));
        simulation.act(Pull{9, {18.5, 0, 0}});
        simulation.advance(1);
        return simulation.frame().velocities[9].x / 1e-4;
    };
    const double k = run.scene["k"];
    EXPECT_NEAR(acceleration(1), -0.5 * k, 1e-4);
    EXPECT_NEAR(acceleration(5), -0.1 * k, 1e-4);
}

TEST(Alterations, of_what_the_scene_says_anyway_change_no_bit) {
    for (const Precision precision : precisions) {
        const RunDescription run = run_of("chain", "verlet", precision, 0.1);
        Simulation plain(run), same(altered(run, {{0, true}, {3, false, 1.0}}));
        plain.advance(100);
        same.advance(100);
        EXPECT_EQ(plain.hash(), same.hash()) << "the planner finds the line again";
        Simulation other(altered(run, {{3, std::nullopt, 1.001}}));
        other.advance(100);
        EXPECT_NE(plain.hash(), other.hash());
    }
}

TEST(Alterations, energy_is_that_of_the_altered_scene) {
    Simulation run(run_of("mesh", "velocity-verlet", Precision::double_, 0.001, {{"dim", 6}}));
    run.advance(100);
    run.change(altered(run.description(), {{14, std::nullopt, 3.0}, {15, true}}));
    EXPECT_EQ(run.baseline_step(), 100u);
    EXPECT_FALSE(run.has_exact());
    run.advance(1000);
    EXPECT_LT(std::abs(run.energy_error()), 1e-6 * run.diagnostics().energy);
}

TEST(Alterations, that_are_impossible_are_refused) {
    const RunDescription run = describe("chain");
    for (const double mass : {0.0, -1.0, infinity, std::nan("")})
        EXPECT_THROW(check(altered(run, {{1, std::nullopt, mass}})), UsageError) << mass;
    EXPECT_THROW(check(altered(run, {{10, true}})), UsageError);
    RunDescription in_float = altered(run, {{1, std::nullopt, 1e-60}});
    EXPECT_NO_THROW(check(in_float));
    in_float.precision = Precision::float_;
    EXPECT_THROW(check(in_float), UsageError);
    EXPECT_THROW(check(altered(describe("chain", "verlet-2008"), {{3, true}})), UsageError);
    EXPECT_NO_THROW(check(describe("chain", "verlet-2008")));
}

TEST(Alterations, later_ones_go_before_earlier_ones) {
    RunDescription run = altered(describe("chain"), {{5, true, 2.0}, {3, true}});
    run = altered(run, {{5, false}, {1, std::nullopt, 4.0}});
    const std::vector<Alteration> expected{{1, std::nullopt, 4.0}, {3, true}, {5, false, 2.0}};
    EXPECT_TRUE(
        std::equal(expected.begin(), expected.end(), run.alterations.all().begin(), run.alterations.all().end()));
    EXPECT_EQ(run.alterations.of(5).mass, 2.0);
    EXPECT_EQ(run.alterations.of(4).mass, std::nullopt);
    EXPECT_EQ(with_model(run, "chain").alterations, Alterations());
}

}  // namespace
}  // namespace steplab::test
