#include "app/commands/pictured_runs.hpp"

#include "sim/run/simulation.hpp"

#include <gtest/gtest.h>

#include <optional>

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

}  // namespace
}  // namespace steplab
