#include "ui/panels/step_verdict.hpp"

#include "io/scene_file.hpp"
#include "lab/limits/present_limit.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/opening.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

StepVerdict verdict(std::string_view model, std::string_view method, double dt, Precision precision) {
    RunDescription description = describe(model, method);
    description.dt = dt;
    description.precision = precision;
    return step_verdict(view_of(Simulation(description)));
}

StepVerdict verdict(std::string_view model, std::string_view method, double dt) {
    return verdict(model, method, dt, Precision::double_);
}

TEST(step_verdict, is_green_where_the_motion_is_resolved) {
    const StepVerdict found = verdict("chain", "rk4", 0.1);
    EXPECT_EQ(found.lamp, Lamp::good);
    EXPECT_EQ(found.text, "stable: 0.07 of the limit 1.43 s");
    EXPECT_THAT(found.tooltip, AllOf(HasSubstr("32 steps per period"), HasSubstr("stability limit 1.43 s")));
    EXPECT_EQ(verdict("free", "rk4", 5).text, "stable at any dt");
    EXPECT_EQ(verdict("chain", "implicit-midpoint", 0.1).lamp, Lamp::good);
    EXPECT_EQ(verdict("morse", "dopri5", 5).lamp, Lamp::good);
}

TEST(step_verdict, is_amber_where_it_is_stable_and_no_more) {
    const StepVerdict rope = verdict("rope", "rk4", 0.1);  // 0.974 of its limit; nothing of the stretching is left
    EXPECT_EQ(rope.lamp, Lamp::caution);
    EXPECT_EQ(rope.text, "stable, but only 2.3 steps per period");
    EXPECT_EQ(verdict("chain", "pefrl", 2.1 / 1.9727).text, "stable, but only 3 steps per period");
    for (const std::string_view method : {"implicit-midpoint", "tr-bdf2"}) {
        const StepVerdict found = verdict("chain", method, 1.5);
        EXPECT_EQ(found.lamp, Lamp::caution) << method;
        EXPECT_THAT(found.text, StartsWith("stable, but only 2.1 steps")) << method;
    }
}

// With drag the limit may be that of motion without any spring: nothing oscillates too fast, and the limit is near.
TEST(step_verdict, is_amber_close_to_the_limit) {
    RunDescription description = describe("oscillator", "rk4");
    description.scene.set("c", 100);
    description.scene.set("k", 0.01);
    description.dt = 0.95 * stability_limit(description)->limit;
    const StepVerdict found = step_verdict(view_of(Simulation(description)));
    EXPECT_EQ(found.lamp, Lamp::caution);
    EXPECT_THAT(found.text, StartsWith("barely stable: 0.95 of the limit"));
    description.dt *= 0.5;
    EXPECT_EQ(step_verdict(view_of(Simulation(description))).lamp, Lamp::good);
}

// The scene has stiffened: what is stable at rest is not.
TEST(step_verdict, is_of_the_scene_as_it_is_now) {
    RunDescription description = describe("chain", "rk4");
    const RunView view = view_of(Simulation(description));
    PresentLimit now{.step = 7, .time = 0.7};
    now.oscillation.omega = 40;
    now.limit = 0.0707;
    const StepVerdict found = step_verdict(view, &now);
    EXPECT_EQ(found.lamp, Lamp::bad);
    EXPECT_EQ(found.text, "unstable: 1.41 of the limit 0.0707 s");
    EXPECT_THAT(found.tooltip, HasSubstr("as it is at t = 0.70"));
    EXPECT_THAT(found.tooltip, HasSubstr("at rest 1.97 rad/s, limit 1.43 s"));
    EXPECT_EQ(step_verdict(view).lamp, Lamp::good);
}

TEST(step_verdict, says_what_a_period_costs_the_amplitude) {
    EXPECT_EQ(verdict("chain", "velocity-verlet", 0.1).detail, "per period: 32 steps, amplitude kept");
    EXPECT_EQ(verdict("chain", "velocity-verlet", 0.001).detail, "per period: 3185 steps, amplitude kept");
    EXPECT_THAT(verdict("chain", "rk4", 1.0).detail, StartsWith("0.70 of the limit, amplitude −"));
    EXPECT_EQ(verdict("chain", "implicit-midpoint", 1.5).detail, "amplitude kept");
    EXPECT_THAT(verdict("chain", "midpoint", 0.3).detail, HasSubstr("amplitude +"));
    // one of its two motions grows, the other decays as fast
    EXPECT_THAT(verdict("chain", "velocity-verlet", 1.1).detail, HasSubstr("amplitude +"));
    EXPECT_THAT(verdict("chain", "rk4", 2).detail, HasSubstr("explodes"));
    EXPECT_EQ(verdict("free", "rk4", 5).detail, "");
    EXPECT_EQ(verdict("morse", "dopri5", 5).detail, "");
}

TEST(step_verdict, is_red_beyond_the_limit) {
    const StepVerdict found = verdict("chain", "rk4", 2);
    EXPECT_EQ(found.lamp, Lamp::bad);
    EXPECT_EQ(found.text, "unstable: 1.39 of the limit 1.43 s");
    EXPECT_EQ(verdict("chain", "midpoint", 0.01).lamp, Lamp::bad);
}

TEST(step_verdict, says_where_nothing_is_known) {
    EXPECT_EQ(verdict("morse", "rk4", 0.01).lamp, Lamp::none);
    EXPECT_EQ(verdict("morse", "rk4", 0.01).text, "stability limit unknown");
}

TEST(step_verdict, is_amber_where_rounding_rules_the_run) {
    for (const std::string_view model : {"chain", "morse"}) {
        RunDescription description = describe(model, "velocity-verlet");
        description.precision = Precision::float_;
        description.dt = 1e-6;
        RunView view = view_of(Simulation(description));
        ASSERT_FALSE(view.notes.empty()) << model;
        EXPECT_EQ(step_verdict(view).lamp, Lamp::caution) << model;
        view.notes.clear();
        EXPECT_NE(step_verdict(view).lamp, Lamp::caution) << model;
    }
    RunView unstable = view_of(Simulation(describe("chain", "midpoint")));
    unstable.notes = {"a note"};
    EXPECT_EQ(step_verdict(unstable).lamp, Lamp::bad) << "the worse of the two";
}

/// The models and the shipped scenes.
std::vector<RunDescription> scenes_as_they_open() {
    std::vector<RunDescription> all;
    for (const Model& model : models()) all.push_back(opening(describe(model.info.id)));
    for (const std::string& name : shipped_scenes()) all.push_back(describe(find_scene(name)));
    return all;
}

/// As the window shows it once the worker has found the limit of the scene at its start.
StepVerdict shown_verdict(const RunDescription& description) {
    const Simulation start(description);
    const PresentLimit present = PresentLimits().at(description, start.state(), 0, 0);
    return step_verdict(view_of(start), &present);
}

TEST(step_verdict, of_every_scene_as_it_opens_is_green) {
    for (RunDescription description : scenes_as_they_open()) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            description.precision = precision;
            const StepVerdict found = shown_verdict(description);
            EXPECT_EQ(found.lamp, Lamp::good) << description.model << ": " << found.text;
        }
    }
}

TEST(step_verdict, of_scenes_with_longer_steps_is_not_green) {
    for (const char* const name : {"rope", "crystal", "spring-network", "newtons-cradle"}) {
        RunDescription description = describe(find_scene(name));
        description.dt *= 20;
        EXPECT_NE(shown_verdict(description).lamp, Lamp::good) << name;
    }
}

}  // namespace
}  // namespace steplab::ui
