#include "sim/catalogue.hpp"
#include "ui/desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

using testing::ElementsAre;

/// A run that went to its end in a real divergence.
RunView diverged(const std::string& method, double dt) {
    RunDescription description = describe("chain", method);
    description.dt = dt;
    Simulation simulation(description);
    simulation.advance(100000);
    return view_of(simulation);
}

class Diverged : public testing::Test {
protected:
    Diverged() {
        desk.view = diverged("euler", 2.5);
        desk.interface.record(desk.view);
        desk.frame();
        desk.frame();
        desk.calls();
    }
    Desk desk{[] {
        RunDescription description = describe("chain", "euler");
        description.dt = 2.5;
        return description;
    }()};
};

TEST_F(Diverged, card_appears_with_its_remedies) {
    ASSERT_TRUE(desk.view.divergence);
    ASSERT_TRUE(desk.view.remedies.dt);
    EXPECT_FALSE(desk.view.divergence->message.empty());
    EXPECT_TRUE(desk.has("divergence"));
    EXPECT_TRUE(desk.has("remedy.dt"));
    EXPECT_TRUE(desk.has("remedy.method"));
}

// ImGui knows the size of a new card one frame later: it must be drawn without any input.
TEST(Divergence, card_asks_for_frames_until_it_stands) {
    Desk desk(describe("chain", "euler"));
    for (int i = 0; i < 5; ++i) desk.frame();
    desk.view = diverged("euler", 2.5);
    desk.interface.record(desk.view);
    desk.frame();
    int frames = 1;
    for (; desk.interface.seconds_until_change() <= 0 && frames < 100; ++frames) desk.frame();
    EXPECT_LT(frames, 10);
    const WidgetRect stands = desk.widget("remedy.dt");
    for (int i = 0; i < 5; ++i) desk.frame();
    EXPECT_EQ(desk.widget("remedy.dt"), stands);
}

TEST_F(Diverged, smaller_dt_restarts_and_plays) {
    desk.click("remedy.dt");
    EXPECT_THAT(desk.calls(), ElementsAre("change", "restart", "play"));
    RunDescription expected = desk.view.description;
    expected.dt = desk.view.remedies.dt.value();
    EXPECT_EQ(desk.wanted(), expected);
    EXPECT_LT(desk.wanted().dt, 2 / 1.97272261) << "below Euler's limit of 2 / omega_max of ten points";
}

TEST_F(Diverged, other_method_keeps_dt_and_is_stable_there) {
    desk.click("remedy.method");
    EXPECT_THAT(desk.calls(), ElementsAre("change", "restart", "play"));
    EXPECT_EQ(desk.wanted().dt, 2.5);
    EXPECT_EQ(desk.wanted().method, "stoermer") << "ten substeps are the only ones stable at 2.5 times 1.97";
}

TEST_F(Diverged, remedies_cure_the_real_run) {
    for (const std::string_view widget : {"remedy.dt", "remedy.method"}) {
        desk.click(widget);
        Simulation simulation(desk.wanted());
        simulation.advance(5000);
        EXPECT_FALSE(simulation.divergence()) << widget;
    }
}

TEST_F(Diverged, card_can_be_closed_and_comes_back_with_the_next_divergence) {
    desk.click("divergence.close");
    EXPECT_FALSE(desk.has("divergence"));
    desk.view.divergence->step += 1;
    desk.frame();
    desk.frame();
    EXPECT_TRUE(desk.has("divergence"));
}

TEST_F(Diverged, run_cannot_be_played_but_restarted) {
    desk.click("divergence.close");
    desk.click("play");
    desk.click("step");
    EXPECT_TRUE(desk.calls().empty());
    desk.click("restart");
    EXPECT_THAT(desk.calls(), ElementsAre("restart"));
}

TEST(divergence, a_good_run_has_no_card) {
    Desk desk;
    EXPECT_FALSE(desk.has("divergence"));
}

}  // namespace
}  // namespace steplab::ui
