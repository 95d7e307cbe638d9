#include "ui/keys.hpp"

#include "sim/catalogue.hpp"
#include "ui/desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace steplab::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(keys, every_action_has_one_key_of_its_own) {
    std::set<std::pair<Key, bool>> used;
    for (int i = 0; i <= static_cast<int>(Action::quit); ++i) {
        const KeyBinding& binding = binding_of(static_cast<Action>(i));
        EXPECT_EQ(binding.action, static_cast<Action>(i));
        EXPECT_TRUE(used.insert({binding.key, binding.control}).second) << binding.label;
    }
    EXPECT_EQ(used.size(), key_bindings().size());
}

TEST(keys, table_names_them_all) {
    const std::string table = key_table();
    for (const KeyBinding& binding : key_bindings()) {
        EXPECT_NE(table.find("| " + std::string(binding.label) + " | "), std::string::npos) << binding.label;
    }
}

TEST(keys, table_names_those_that_move_the_axes_of_a_plot) {
    const std::string table = key_table();
    const std::size_t row = table.find("at a plot");
    ASSERT_NE(row, std::string::npos);
    const std::string label = table.substr(table.rfind('\n', row) + 1, row - table.rfind('\n', row));
    for (const Key key : {Key::equal, Key::minus, Key::bracket_left, Key::bracket_right, Key::home}) {
        const auto& bindings = key_bindings();
        const auto binding = std::find_if(bindings.begin(), bindings.end(),
                                          [&](const KeyBinding& b) { return b.key == key && !b.control; });
        EXPECT_NE(label.find(binding->label), std::string::npos) << binding->label;
    }
}

TEST(keys, run_is_driven_from_the_keyboard) {
    Desk desk;
    desk.key(Key::space);
    EXPECT_THAT(desk.calls(), ElementsAre("play"));
    desk.key(Key::right);
    desk.key(Key::left);
    desk.key(Key::backspace);
    EXPECT_THAT(desk.calls(), ElementsAre("step forward", "step back", "restart"));
    desk.key(Key::equal);
    EXPECT_EQ(desk.recorder.rates.back().seconds_per_second, 2);
    desk.view.rate = desk.recorder.rates.back();
    desk.key(Key::minus);
    EXPECT_EQ(desk.recorder.rates.back().seconds_per_second, 1);
}

TEST(keys, brackets_cycle_through_the_scenes) {
    const auto all = models();
    Desk desk(describe(all.front().info.id));
    desk.key(Key::bracket_left);
    EXPECT_EQ(desk.wanted().model, all.back().info.id);
    desk.key(Key::bracket_right);
    desk.key(Key::bracket_right);
    EXPECT_EQ(desk.wanted().model, all[1].info.id);
}

TEST(keys, tab_hides_the_panel_and_brings_it_back) {
    Desk desk;
    const PixelRect with_panel = desk.interface.scene();
    desk.key(Key::tab);
    EXPECT_FALSE(desk.has("model"));
    EXPECT_GT(desk.interface.scene().width, with_panel.width);
    desk.key(Key::tab);
    EXPECT_TRUE(desk.has("model"));
    EXPECT_EQ(desk.interface.scene(), with_panel);
}

TEST(keys, tab_brings_the_panel_into_a_window_too_narrow_for_it) {
    Desk desk(describe(), {400, 300, 1});
    EXPECT_FALSE(desk.has("model"));
    desk.key(Key::tab);
    EXPECT_TRUE(desk.has("model"));
    desk.key(Key::tab);
    EXPECT_FALSE(desk.has("model"));
}

TEST(keys, help_opens_and_closes) {
    Desk desk;
    EXPECT_FALSE(desk.has("help"));
    desk.key(Key::f1);
    EXPECT_TRUE(desk.has("help"));
    desk.key(Key::escape);
    EXPECT_FALSE(desk.has("help"));
    desk.key(Key::f1);
    desk.click("help.close");
    EXPECT_FALSE(desk.has("help"));
}

/// The rows of the help that are seen whole.
void note_rows(Desk& desk, std::set<std::string>& seen) {
    constexpr std::string_view prefix = "help/";
    const WidgetRect card = desk.widget("help");
    for (const auto& [name, place] : desk.interface.widgets()) {
        if (!name.starts_with(prefix)) continue;
        EXPECT_GT(place.left, card.left) << name;
        EXPECT_LT(place.right, card.right) << name << " is cut";
        if (place.top >= card.top && place.bottom <= card.bottom) seen.insert(name.substr(prefix.size()));
    }
}

TEST(keys, help_has_all_of_them_in_low_and_narrow_windows_too) {
    for (const Display& display :
         {Display{1280, 800, 1}, {1000, 560, 1}, {800, 600, 1}, {1280, 800, 1.5f}, {1000, 560, 2}, {400, 300, 1}}) {
        Desk desk(describe(), display);
        desk.key(Key::f1);
        std::set<std::string> seen;
        note_rows(desk, seen);
        const bool whole = seen.size() == key_bindings().size() + mouse_bindings().size();
        EXPECT_EQ(whole, display.height == 800 && display.scale == 1) << seen.size() << " at " << display.height;
        for (int page = 0; page < 40; ++page) {
            desk.key(Key::page_down);
            note_rows(desk, seen);
        }
        for (const KeyBinding& binding : key_bindings()) EXPECT_TRUE(seen.contains(std::string(binding.label)));
        for (const MouseBinding& binding : mouse_bindings())
            EXPECT_TRUE(seen.contains(std::string(binding.label))) << binding.label << " at " << display.width;
    }
}

TEST(keys, snapshot_full_screen_and_quit_are_requests) {
    Desk desk;
    desk.key(Key::p, true);
    desk.key(Key::f11);
    desk.key(Key::q, true);
    const auto requests = desk.interface.take_requests();
    ASSERT_EQ(requests.size(), 3u);
    EXPECT_EQ(requests[0].kind, Request::Kind::save_snapshot);
    EXPECT_EQ(requests[1].kind, Request::Kind::full_screen);
    EXPECT_EQ(requests[2].kind, Request::Kind::quit);
    EXPECT_TRUE(desk.interface.take_requests().empty());
}

TEST(keys, letters_without_control_are_not_those_with_it) {
    Desk desk;
    desk.key(Key::o);
    desk.key(Key::q);
    desk.key(Key::space, true);
    EXPECT_TRUE(desk.interface.take_requests().empty());
    EXPECT_THAT(desk.calls(), IsEmpty());
}

TEST(keys, an_entry_keeps_the_keyboard_to_itself) {
    Desk desk;
    desk.click("dt.value");
    ASSERT_TRUE(desk.has("dt.entry"));
    desk.key(Key::left);
    desk.key(Key::backspace);
    desk.key(Key::space);
    EXPECT_THAT(desk.calls(), IsEmpty());
    desk.key(Key::escape);
    desk.frame();
    desk.key(Key::right);
    EXPECT_THAT(desk.calls(), ElementsAre("step forward"));
}

TEST(keys, quit_and_those_of_the_window_act_while_a_value_is_typed) {
    Desk desk(describe("rope"));
    desk.click("dt.value");
    desk.frame();
    desk.type("0.03");
    desk.key(Key::r, true);
    desk.key(Key::f11);
    desk.key(Key::z, true);  // of the text
    desk.key(Key::o, true);
    desk.key(Key::s, true);  // the scene has not got the value yet
    desk.key(Key::q, true);
    std::vector<Request::Kind> kinds;
    for (const Request& request : desk.interface.take_requests()) kinds.push_back(request.kind);
    EXPECT_THAT(kinds, ElementsAre(Request::Kind::record, Request::Kind::full_screen, Request::Kind::quit));
    EXPECT_THAT(desk.calls(), IsEmpty());
}

TEST(keys, home_resets_the_view_and_f_zooms_to_fit) {
    Desk desk;
    const render::Camera home = desk.camera;
    desk.camera.distance *= 7;
    desk.camera.yaw += 50;
    const double yaw = desk.camera.yaw;
    desk.key(Key::f);
    EXPECT_LT(desk.camera.distance, 3 * home.distance);
    EXPECT_EQ(desk.camera.yaw, yaw);
    desk.key(Key::home);
    EXPECT_EQ(desk.camera, home);
}

TEST(keys, every_key_has_a_button_or_menu_entry) {
    // Widgets in the bar, in the menu, and gestures of the panel that do what a key does.
    const std::map<Action, std::string> places = {{Action::pause, "play"},
                                                  {Action::play_back, "play back"},
                                                  {Action::loop, "loop"},
                                                  {Action::step_forward, "step"},
                                                  {Action::step_back, "step back"},
                                                  {Action::restart, "restart"},
                                                  {Action::undo, "menu/undo"},
                                                  {Action::redo, "menu/redo"},
                                                  {Action::bookmark, "menu/bookmark"},
                                                  {Action::turn_round, "turn round"},
                                                  {Action::twin, "twin"},
                                                  {Action::select_box, "selection.box"},
                                                  {Action::next_particle, "menu/next particle"},
                                                  {Action::previous_particle, "menu/previous particle"},
                                                  {Action::reset_view, "menu/reset view"},
                                                  {Action::zoom_to_fit, "menu/zoom to fit"},
                                                  {Action::faster, "menu/faster"},
                                                  {Action::slower, "menu/slower"},
                                                  {Action::previous_scene, "menu/previous scene"},
                                                  {Action::next_scene, "menu/next scene"},
                                                  {Action::open_scene, "menu/open scene"},
                                                  {Action::save_scene, "menu/save scene"},
                                                  {Action::panel, "menu/panel"},
                                                  {Action::help, "menu/help"},
                                                  {Action::snapshot, "menu/snapshot"},
                                                  {Action::record, "menu/record"},
                                                  {Action::larger, "menu/larger"},
                                                  {Action::smaller, "menu/smaller"},
                                                  {Action::usual_scale, "menu/usual scale"},
                                                  {Action::steer, "menu/steer"},
                                                  {Action::full_screen, "menu/full screen"},
                                                  {Action::close, "help.close"},
                                                  {Action::quit, "menu/quit"}};
    Desk desk;
    desk.key(Key::f1);
    desk.click("menu");
    std::set<std::string> found;
    for (const char* const beside : {"menu", "menu/playing", "menu/text size", "menu/particles"}) {
        if (beside != std::string("menu")) desk.click(beside);
        for (const auto& [widget, place] : desk.interface.widgets()) found.insert(widget);
    }
    for (const KeyBinding& binding : key_bindings())
        EXPECT_TRUE(found.contains(places.at(binding.action))) << binding.label;
}

/// The camera after a key with Alt.
render::Camera after(Desk& desk, Key key, bool shift = false) {
    desk.interface.input().push(ModifiersChanged{.shift = shift, .alt = true});
    desk.interface.input().push(KeyChanged{key, true});
    desk.frame();
    desk.interface.input().push(KeyChanged{key, false});
    desk.interface.input().push(ModifiersChanged{});
    desk.frame();
    desk.frame();
    return desk.camera;
}

TEST(keys, of_the_camera_turn_move_and_zoom_it) {
    Desk desk(describe("mesh"));
    desk.frame();
    const render::Camera start = desk.camera;
    const render::Camera turned = after(desk, Key::right);
    EXPECT_NE(turned.yaw, start.yaw);
    EXPECT_EQ(turned.focus, start.focus);
    EXPECT_NEAR(after(desk, Key::left).yaw, start.yaw, 1e-9);  // there and back
    EXPECT_NE(after(desk, Key::up).pitch, start.pitch);
    EXPECT_NEAR(after(desk, Key::down).pitch, start.pitch, 1e-9);
    const render::Camera moved = after(desk, Key::right, true);
    EXPECT_NE(moved.focus, start.focus);
    EXPECT_EQ(moved.yaw, desk.camera.yaw);
    EXPECT_LT(after(desk, Key::equal).distance, start.distance);
    EXPECT_NEAR(after(desk, Key::minus).distance, start.distance, 1e-9 * start.distance);
    EXPECT_THAT(desk.calls(), IsEmpty()) << "no step is taken, and no speed set";
    EXPECT_TRUE(desk.recorder.rates.empty());
}

TEST(keys, with_shift_move_the_edges_of_panel_and_plots) {
    Desk desk;
    const PixelRect usual = desk.interface.scene();
    desk.camera.yaw += 50;
    const render::Camera camera = desk.camera;
    desk.key(Key::right, false, true);
    EXPECT_EQ(desk.interface.scene().x, usual.x + 20) << "the panel is wider";
    desk.key(Key::up, false, true);
    EXPECT_EQ(desk.interface.scene().height, usual.height - 20) << "the plots are higher";
    desk.key(Key::left, false, true);
    desk.key(Key::down, false, true);
    EXPECT_EQ(desk.interface.scene(), usual);
    for (int i = 0; i < 50; ++i) desk.key(Key::right, false, true);
    EXPECT_EQ(desk.interface.scene().x, 520) << "as far as a drag";
    desk.key(Key::home, false, true);
    EXPECT_EQ(desk.interface.scene(), usual);
    EXPECT_EQ(desk.camera, camera) << "the view is not reset";
    EXPECT_THAT(desk.calls(), IsEmpty()) << "no step is taken";
}

TEST(keys, select_particles_one_after_the_other) {
    Desk desk(describe("chain"));
    desk.view.tracked = Tracked{8, {}};
    for (const auto& [key, particle] : {std::pair{Key::n, 9u}, {Key::n, 0u}, {Key::p, 9u}, {Key::p, 8u}}) {
        desk.key(key);
        const auto& sent = std::get<event::Track>(desk.recorder.events.back());
        EXPECT_EQ(sent.particle, particle);
        desk.view.tracked = Tracked{particle, {}};
    }
}

}  // namespace
}  // namespace steplab::ui
