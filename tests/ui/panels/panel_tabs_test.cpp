// The tabs of the side panel in windows too low for all of its sections.

#include "ui/desk.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace steplab::ui {
namespace {

constexpr Display low{640, 480, 1}, lowest{400, 300, 1}, usual{1280, 1200, 1};

/// What stands in the panel, whatever its tab.
std::set<std::string> widgets_of_panel(Desk& desk) {
    std::set<std::string> found;
    for (const auto& [name, place] : desk.interface.widgets()) {
        if (place.right <= 300 && place.top > 74 && name.rfind("tab/", 0) != 0 && name != "footer") found.insert(name);
    }
    return found;
}

TEST(panel_tabs, are_there_in_a_low_window_alone) {
    Desk desk(describe("chain"), low), large(describe("chain"), usual);
    EXPECT_TRUE(desk.has("tab/Scene"));
    EXPECT_TRUE(desk.has("scene.n"));
    EXPECT_FALSE(desk.has("method"));
    EXPECT_FALSE(large.has("tab/Scene"));
    EXPECT_TRUE(large.has("method"));
}

TEST(panel_tabs, show_their_sections_alone) {
    Desk desk(describe("chain"), low);
    desk.click("tab/Method");
    EXPECT_TRUE(desk.has("method"));
    EXPECT_TRUE(desk.has("dt"));
    EXPECT_FALSE(desk.has("scene.n"));
    desk.click("tab/Display");
    EXPECT_TRUE(desk.has("colouring"));
    EXPECT_FALSE(desk.has("dt"));
}

// A panel without tabs has nothing that they do not lead to.
TEST(panel_tabs, lead_to_all_that_the_panel_has) {
    Desk desk(describe("chain"), low), large(describe("chain"), usual);
    std::set<std::string> found;
    for (const char* const tab : {"tab/Scene", "tab/Method", "tab/Display", "tab/State"}) {
        desk.click(tab);
        found.merge(widgets_of_panel(desk));
    }
    for (const char* const widget : {"scene.n", "method", "dt", "colouring", "ensemble/off", "selection.box"})
        EXPECT_TRUE(found.contains(widget)) << widget;
    for (const std::string& widget : widgets_of_panel(large)) EXPECT_TRUE(found.contains(widget)) << widget;
}

TEST(panel_tabs, of_runs_come_and_go_with_them) {
    Desk desk(describe("chain"), low);
    EXPECT_FALSE(desk.has("tab/Runs"));
    desk.session.followers = {desk.view};
    desk.frame();
    desk.frame();
    desk.click("tab/Runs");
    EXPECT_TRUE(desk.has("run 1"));
    desk.session.followers.clear();
    desk.frame();
    EXPECT_FALSE(desk.has("tab/Runs"));
    EXPECT_TRUE(desk.has("scene.n")) << "another tab takes its place";
}

TEST(panel_tabs, have_a_plot_where_there_is_no_room_below_the_scene) {
    Desk with_room(describe("chain"), low), desk(describe("chain"), lowest);
    EXPECT_FALSE(with_room.has("tab/Plot"));
    EXPECT_TRUE(with_room.has("plot 1"));
    desk.key(Key::tab);  // the panel is hidden there until it is asked for
    EXPECT_FALSE(desk.has("plot 1"));
    desk.click("tab/Plot");
    EXPECT_TRUE(desk.has("plot 1"));
    EXPECT_FALSE(desk.has("scene.n"));
    EXPECT_EQ(desk.calls(), std::vector<std::string>{"samples on"}) << "not before there is a plot";
    EXPECT_LE(desk.widget("energy error.save").right, 300);
    desk.click("tab/State");
    EXPECT_FALSE(desk.has("plot 1"));
    EXPECT_TRUE(desk.calls().empty()) << "they are taken on";
    desk.click("tab/Plot");
    desk.key(Key::tab);
    EXPECT_FALSE(desk.has("tab/Plot")) << "the key hides the panel with its plot";
}

TEST(panel_tabs, give_the_plot_back_to_a_window_that_grows) {
    Desk desk(describe("chain"), lowest);
    desk.key(Key::tab);
    desk.click("tab/Plot");
    desk.interface.resize(usual);
    for (int i = 0; i < 3; ++i) desk.frame();
    EXPECT_TRUE(desk.has("scene.n"));
    EXPECT_GT(desk.widget("plot 1").left, 300);
    desk.interface.resize(low);
    for (int i = 0; i < 3; ++i) desk.frame();
    EXPECT_TRUE(desk.has("scene.n")) << "a tab that is not there is not shown";
}

}  // namespace
}  // namespace steplab::ui
