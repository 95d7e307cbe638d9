#include "app/commands/pictured_runs.hpp"

#include "sim/run/simulation.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace steplab {
namespace {

TEST(PicturedRuns, tell_plots_what_each_run_did_on_its_way) {
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        RunDescription run = describe("oscillator", "velocity-verlet");
        run.precision = precision;
        PictureRequest picture;
        picture.panel = true;
        PicturedRuns runs({run, run}, RunEnd{.step = 40}, std::move(picture), std::nullopt);
        runs.go_to(40);
        EXPECT_EQ(runs.request().past.size(), 40u);
        Simulation alone(run);
        for (const PastMoment& moment : runs.request().past) {
            alone.advance(moment.sample.step - alone.step());
            ASSERT_TRUE(moment.sample.particle());
            EXPECT_EQ(moment.sample.particle()->velocity, alone.frame().velocities[1]);
            EXPECT_EQ(moment.sample.energy_error, alone.diagnostics().energy_error);
            ASSERT_EQ(moment.followers.size(), 1u);
            EXPECT_EQ(moment.followers[0].particle()->velocity, moment.sample.particle()->velocity);
        }
    }
}

TEST(PicturedRuns, tell_plots_how_far_the_runs_of_an_ensemble_are_apart) {
    const RunDescription run = describe("oscillator", "velocity-verlet");
    PictureRequest picture;
    picture.panel = true;
    const std::vector<ParameterRange> ranges{{.name = "v0", .from = 0.9, .to = 1.1}};
    PicturedRuns runs({run}, RunEnd{.step = 40}, std::move(picture), PicturedEnsemble(run, 4, ranges));
    runs.go_to(20);
    runs.go_to(40);
    const auto& samples = runs.request().view.spread.samples;
    ASSERT_EQ(samples.size(), 41u) << "at the start, after every step and at the end";
    EXPECT_EQ(samples.front().largest, 0);
    EXPECT_EQ(samples.back().largest, runs.request().view.ensemble_spread.largest);
    EXPECT_GT(samples[10].largest, 0);
    EXPECT_TRUE(samples[10].reach) << "of the particle that is followed";
}

TEST(PicturedRuns, scan_what_accuracy_costs_where_a_plot_shows_it) {
    const RunDescription run = describe("oscillator", "velocity-verlet");
    for (const ui::PlotKind kind : {ui::PlotKind::costs, ui::PlotKind::energies}) {
        PictureRequest picture;
        picture.panel = true;
        picture.plots = {kind};
        const PicturedRuns runs({run, run}, RunEnd{.step = 4}, std::move(picture), std::nullopt);
        const auto& costs = runs.request().costs;
        ASSERT_EQ(costs != nullptr, kind == ui::PlotKind::costs);
        if (!costs) continue;
        EXPECT_TRUE(costs->complete);
        EXPECT_GT(costs->points.size(), 50u);
        EXPECT_EQ(costs->runs.size(), 2u);
    }
}

}  // namespace
}  // namespace steplab
