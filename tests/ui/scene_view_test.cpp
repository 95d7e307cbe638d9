#include "io/scene_file.hpp"
#include "render/framing.hpp"
#include "sim/run/simulation.hpp"
#include "ui/desk.hpp"
#include "ui/window_command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

// What a scene's file says of its view, in the window.

namespace steplab::ui {
namespace {

const std::string camera = "30,20,8,0.7,0.9,0.7";

RunDescription scene(const std::string& view, double x = 1, const std::string& given = "a.toml") {
    const std::string text = "steplab = 1\n[[particles]]\nline = { count = 3, step = [" + std::to_string(x) +
                             ", 0, 0] }\n[[fields]]\ngravity = [0, -1, 0]\n[view]\n" + view;
    return describe(scene_from({{.name = "", .content = text}}, given));
}

const std::string all = "camera = \"" + camera + "\"\ncolour = \"speed\"\nbackground = \"light\"\n";

void show(Desk& desk, const RunDescription& run) { desk.show(view_of(Simulation(run))); }

TEST(scene_view, is_taken_when_the_scene_opens) {
    Desk desk(describe("chain"));
    show(desk, scene(all));
    EXPECT_EQ(render::view_text(desk.camera), camera);
    EXPECT_EQ(desk.style.colouring, render::Colouring::speed);
    EXPECT_EQ(desk.style.background, render::Background::light);
}

TEST(scene_view, colours_end_with_their_scene) {
    Desk desk(describe("chain"));
    desk.style.colouring = render::Colouring::strain;
    show(desk, scene(all));
    show(desk, describe("mesh"));
    EXPECT_EQ(desk.style.colouring, render::Colouring::strain);
    EXPECT_EQ(desk.style.background, render::Background::dark);
}

TEST(scene_view, colours_that_the_user_chose_meanwhile_stay) {
    Desk desk(describe("chain"));
    show(desk, scene(all));
    desk.style.colouring = render::Colouring::displacement;
    show(desk, describe("mesh"));
    EXPECT_EQ(desk.style.colouring, render::Colouring::displacement);
}

TEST(scene_view, home_is_the_camera_of_the_file) {
    Desk desk(describe("chain"));
    show(desk, scene(all));
    desk.camera.yaw += 40;
    desk.frame();
    desk.key(Key::home);
    EXPECT_EQ(render::view_text(desk.camera), camera);
}

// The camera stays where it is, moved by the user or not, and wherever the particles now are.
TEST(scene_view, camera_stays_when_the_file_is_read_again) {
    Desk desk(scene(""));
    const render::Camera untouched = desk.camera;
    show(desk, scene("", 2));
    EXPECT_EQ(desk.camera, untouched);
    desk.camera.distance *= 2;
    const render::Camera moved = desk.camera;
    desk.frame();
    show(desk, scene("", 3));
    EXPECT_EQ(desk.camera, moved);
    show(desk, scene("", 3, "b.toml"));
    EXPECT_NE(desk.camera, moved);
}

TEST(scene_view, reading_again_keeps_what_was_changed_in_the_window) {
    Desk desk(scene("", 1));
    RunDescription changed = desk.view.description;
    changed.dt = 0.5;
    show(desk, changed);
    desk.interface.reload(scene("", 2), desk.recorder);
    EXPECT_EQ(desk.wanted().dt, 0.5);
    EXPECT_EQ(desk.wanted().origin, scene("", 2).origin);
}

TEST(scene_view, what_is_read_again_of_another_file_is_not_shown) {
    Desk desk(describe("chain"));
    desk.interface.reload(scene(""), desk.recorder);
    EXPECT_TRUE(desk.recorder.changes.empty());
}

TEST(scene_view, a_file_that_is_right_again_ends_the_message) {
    Desk desk(scene(""));
    desk.interface.report_error("a.toml:2:1: no");
    desk.frame();
    EXPECT_TRUE(desk.has("refusal"));
    desk.interface.reload(scene(""), desk.recorder);
    desk.frame();
    EXPECT_FALSE(desk.has("refusal"));
}

void draw_until_nothing_changes(Desk& desk) {
    do desk.frame();
    while (desk.interface.seconds_until_change() == 0);
}

TEST(scene_view, a_longer_message_is_seen_whole) {
    Desk desk(scene(""));
    for (const char* message : {"a.toml:2:1: no", "a.toml:3:1: one line\nand another\nand a third", "a.toml:2:1: no"}) {
        desk.interface.report_error(message);
        draw_until_nothing_changes(desk);
        const float settled = desk.widget("refusal").top;
        for (int i = 0; i < 3; ++i) desk.frame();
        EXPECT_EQ(desk.widget("refusal").top, settled) << "it still grew: " << message;
        EXPECT_LT(desk.widget("refusal.text").bottom, desk.widget("refusal").bottom) << message;
        EXPECT_GT(desk.widget("refusal.text").top, desk.widget("refusal").top) << message;
        EXPECT_LT(desk.widget("refusal").bottom - desk.widget("refusal.text").bottom, 20) << message;
    }
}

/// Of as many particles as a parameter says, of a mass that another leaves.
RunDescription hungry_scene(const std::string& mass) {
    return describe(scene_from({{.name = "",
                                 .content = "steplab = 1\n[parameters]\nn = 5\nk = { value = 1, range = [0, 20] }\n"
                                            "[[particles]]\nline = { count = \"n\", step = [1, 0, 0] }\nmass = \"" +
                                            mass + "\"\n"}},
                               "a.toml"));
}

// With an altered particle, of which is asked whether the scene still has it, and without.
TEST(scene_view, values_that_make_no_scene_are_refused_where_they_are_set) {
    for (const bool altered : {false, true}) {
        for (const auto& [row, value] : {std::pair{"n", "2.5"}, {"n", "-3"}, {"k", "7"}}) {
            RunDescription run = hungry_scene("6 - k");
            if (altered) run = with_alterations(run, std::vector<Alteration>{{0, std::nullopt, 2.0}});
            Desk desk(run);
            desk.click("scene." + std::string(row) + ".value");
            desk.type(value);
            desk.key(Key::enter);
            desk.frame();
            EXPECT_TRUE(desk.has("refusal")) << row;
            EXPECT_TRUE(desk.recorder.changes.empty()) << row;
        }
    }
}

TEST(scene_view, a_file_read_again_that_makes_no_scene_with_the_values_set_is_refused) {
    RunDescription run = hungry_scene("20 - k");
    run.scene.set("k", 15);
    Desk desk(run);
    desk.interface.reload(hungry_scene("8 - k"), desk.recorder);
    desk.frame();
    EXPECT_TRUE(desk.has("refusal"));
    EXPECT_TRUE(desk.recorder.changes.empty());
}

}  // namespace
}  // namespace steplab::ui
