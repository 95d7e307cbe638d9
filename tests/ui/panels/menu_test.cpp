#include "ui/desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace steplab::ui {
namespace {

using testing::ElementsAre;

/// Where an action is found beside its key in a window without panel and plots.
struct Place {
    Action action;
    std::string_view widget;
    std::string_view within = "menu";  ///< a button of the bar, or an item of the menu; empty: always there
};

constexpr Place places[] = {{Action::pause, "play", ""},
                            {Action::play_back, "menu/play back", "menu/playing"},
                            {Action::loop, "menu/loop", "menu/playing"},
                            {Action::step_forward, "step", ""},
                            {Action::step_back, "step back", ""},
                            {Action::restart, "restart", ""},
                            {Action::undo, "menu/undo"},
                            {Action::redo, "menu/redo"},
                            {Action::bookmark, "menu/bookmark"},
                            {Action::turn_round, "menu/turn round", "menu/runs"},
                            {Action::twin, "menu/twin", "menu/runs"},
                            {Action::select_box, "menu/select box"},
                            {Action::next_particle, "menu/next particle", "menu/particles"},
                            {Action::previous_particle, "menu/previous particle", "menu/particles"},
                            {Action::reset_view, "menu/reset view"},
                            {Action::zoom_to_fit, "menu/zoom to fit"},
                            {Action::faster, "menu/faster", "menu/playing"},
                            {Action::slower, "menu/slower", "menu/playing"},
                            {Action::previous_scene, "menu/previous scene"},
                            {Action::next_scene, "menu/next scene"},
                            {Action::open_scene, "menu/open scene"},
                            {Action::save_scene, "menu/save scene"},
                            {Action::panel, "menu/panel"},
                            {Action::larger, "menu/larger", "menu/text size"},
                            {Action::smaller, "menu/smaller", "menu/text size"},
                            {Action::usual_scale, "menu/usual scale", "menu/text size"},
                            {Action::help, "menu/help"},
                            {Action::snapshot, "menu/snapshot"},
                            {Action::record, "menu/record"},
                            {Action::steer, "menu/steer"},
                            {Action::full_screen, "menu/full screen"},
                            {Action::close, "menu", ""},  // Esc closes what is open; a click beside it, too
                            {Action::quit, "menu/quit"}};

/// Narrow, and high enough for the whole menu.
constexpr Display narrow{640, 1000, 1};

TEST(menu, each_key_has_a_button_or_an_entry_in_a_narrow_window_too) {
    for (const KeyBinding& binding : key_bindings()) {
        const auto* const place = std::find_if(std::begin(places), std::end(places),
                                               [&](const Place& p) { return p.action == binding.action; });
        ASSERT_NE(place, std::end(places)) << binding.label;
        Desk desk(describe("chain"), narrow);
        if (!place->within.empty()) desk.click("menu");
        if (!place->within.empty() && place->within != "menu") desk.click(place->within);
        EXPECT_TRUE(desk.has(place->widget)) << binding.label << ", " << binding.what;
    }
}

TEST(menu, runs_are_added_and_turned_round_from_it) {
    Desk desk(describe("chain"), narrow);
    const auto choose = [&](std::string_view item) {
        desk.click("menu");
        desk.click("menu/runs");
        desk.click(item);
    };
    choose("menu/twin");
    const auto twin = std::get<event::AddRun>(desk.recorder.events.back()).description;
    EXPECT_EQ(twin.precision, Precision::float_);
    choose("menu/turn round");
    EXPECT_TRUE(std::holds_alternative<TurnRound>(std::get<event::Do>(desk.recorder.events.back()).act));
    choose("menu/add run");
    desk.click("menu/add run/euler");
    EXPECT_EQ(std::get<event::AddRun>(desk.recorder.events.back()).description.method, "euler");
    desk.frame();
    EXPECT_FALSE(desk.has("menu/twin")) << "the menu is closed";
}

TEST(menu, more_than_four_runs_are_not_offered_and_one_has_no_equal_cost) {
    Desk desk(describe("chain"), narrow);
    const auto open = [&] {
        desk.click("menu");
        desk.click("menu/runs");
    };
    open();
    desk.click("menu/equal cost");
    EXPECT_THAT(desk.calls(), testing::Not(testing::Contains("other")));
    desk.key(Key::escape);
    desk.session.followers.resize(3, desk.view);
    open();
    desk.click("menu/add run");
    EXPECT_FALSE(desk.has("menu/add run/euler"));
    desk.click("menu/equal cost");
    EXPECT_TRUE(std::get<event::EqualCost>(desk.recorder.events.back()).on);
}

TEST(menu, of_a_trajectory_has_no_runs) {
    Desk desk(describe("chain"), narrow);
    desk.session.playback = PlaybackView{.file = "a.trajectory", .frame = 0, .frames = 2};
    desk.click("menu");
    EXPECT_FALSE(desk.has("menu/runs"));
}

}  // namespace
}  // namespace steplab::ui
