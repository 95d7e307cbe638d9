#include "ui/desk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace steplab::ui {
namespace {

/// Everything that is drawn, as bytes.
std::string bytes_of(const ImDrawData& data) {
    std::string bytes;
    const auto append = [&](const void* from, std::size_t size) { bytes.append(static_cast<const char*>(from), size); };
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        append(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
        append(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.size_in_bytes()));
    }
    return bytes;
}

TEST(input, a_click_within_one_frame_is_not_lost) {
    Desk desk;
    desk.point_at("play");
    desk.interface.input().push(ButtonChanged{0, true});
    desk.interface.input().push(ButtonChanged{0, false});
    desk.frame();
    EXPECT_EQ(desk.interface.seconds_until_change(), 0) << "the release waits for another frame";
    desk.frame();
    EXPECT_EQ(desk.calls(), std::vector<std::string>{"play"});
}

TEST(input, a_drag_within_one_frame_is_not_lost) {
    Desk desk;
    desk.point_at("dt", 0.3f);
    const WidgetRect place = desk.widget("dt");
    desk.interface.input().push(ButtonChanged{0, true});
    desk.interface.input().push(PointerMoved{place.left + 0.8f * (place.right - place.left), place.top + 5});
    desk.interface.input().push(ButtonChanged{0, false});
    for (int i = 0; i < 4; ++i) desk.frame();
    EXPECT_GT(desk.wanted().dt, 0.5);
}

TEST(input, leaving_the_window_releases_everything) {
    Desk desk;
    desk.point_at("dt");
    desk.press();
    desk.interface.input().push(FocusLost{});
    desk.frame();
    desk.recorder.changes.clear();
    desk.point_at("dt", 0.9f);
    EXPECT_TRUE(desk.recorder.changes.empty());
}

/// How many widgets the keyboard comes to while a key is held for some seconds of 60 frames.
int widgets_reached(Desk& desk, Key key, int seconds) {
    desk.interface.input().push(KeyChanged{key, true});
    int reached = 0;
    std::string at = desk.interface.focused();
    for (int i = 0; i < 60 * seconds; ++i) {
        desk.frame();
        if (std::exchange(at, desk.interface.focused()) != at) ++reached;
    }
    desk.interface.input().push(KeyChanged{key, false});
    desk.frame();
    return reached;
}

TEST(input, a_held_arrow_goes_from_widget_to_widget) {
    Desk desk(describe("chain"));
    desk.key(Key::f6);
    ASSERT_EQ(desk.interface.focused(), "model");
    EXPECT_GT(widgets_reached(desk, Key::down, 1), 3);
}

TEST(input, a_tapped_arrow_goes_one_widget_further_and_a_slow_frame_is_no_second_press) {
    Desk desk(describe("chain"));
    desk.key(Key::f6);
    desk.interface.input().push(KeyChanged{Key::down, true});
    for (int i = 0; i < 2; ++i)
        desk.interface.draw(desk.session, desk.recorder, {desk.camera, desk.style}, {.since_last_frame = 0.2});
    desk.interface.input().push(KeyChanged{Key::down, false});
    for (int i = 0; i < 3; ++i) desk.frame();
    EXPECT_EQ(desk.interface.focused(), "scene.n");
}

TEST(input, enter_that_is_held_presses_once) {
    Desk desk(describe("chain"));
    desk.key(Key::f6);
    for (const char* const widget : {"scene.n", "scene.L", "scene.k", "scene.m", "scene.c", "scene.fixed"}) {
        desk.key(Key::down);
        EXPECT_EQ(desk.interface.focused(), widget);
    }
    desk.interface.input().push(KeyChanged{Key::enter, true});
    for (int i = 0; i < 120; ++i) desk.frame();
    EXPECT_EQ(desk.recorder.changes.size(), 1u) << "the check box is not switched to and fro";
}

TEST(interface, a_paused_window_without_input_does_not_change) {
    Desk desk;
    for (int i = 0; i < 5; ++i) desk.frame();
    EXPECT_TRUE(std::isinf(desk.interface.seconds_until_change()));
    const std::string before = bytes_of(desk.interface.draw_data());
    desk.frame();
    EXPECT_EQ(bytes_of(desk.interface.draw_data()), before);
    desk.point_at("play");
    EXPECT_NE(bytes_of(desk.interface.draw_data()), before) << "the pointer is shown";
}

TEST(interface, still_pictures_of_one_view_are_the_same) {
    const SessionView view{.leading = view_of(Simulation(describe("rope")), 4), .followers = {}, .line = {}};
    const auto still = [&] {
        render::Camera camera;
        render::Style style;
        Interface interface({1280, 720, 1});
        interface.record(view.leading);
        interface.draw_still(view, {camera, style});
        EXPECT_EQ(camera, render::Camera{}) << "the camera of a snapshot belongs to the caller";
        return bytes_of(interface.draw_data());
    };
    EXPECT_EQ(still(), still());
}

TEST(interface, still_picture_shows_no_measured_value) {
    SessionView view{.leading = view_of(Simulation(describe("rope"))), .followers = {}, .line = {}};
    render::Camera camera;
    render::Style style;
    const auto drawn = [&] {
        Interface interface({1280, 720, 1});
        interface.draw_still(view, {camera, style});
        return bytes_of(interface.draw_data());
    };
    const std::string without = drawn();
    EXPECT_FALSE(view.leading.steps_per_second);
    view.leading.steps_per_second = 1e6;
    EXPECT_NE(drawn(), without);
}

// A picture that takes long is drawn coarse then; a click is no reason for it.
TEST(interface, knows_when_the_pointer_draws_something_along) {
    Desk desk;
    desk.point_at("dt", 0.5f);
    desk.press();
    EXPECT_FALSE(desk.interface.is_dragging()) << "pressed only";
    desk.point_at("dt", 0.75f);
    EXPECT_TRUE(desk.interface.is_dragging());
    desk.release();
    EXPECT_FALSE(desk.interface.is_dragging());
}

TEST(interface, a_notice_goes_by_itself) {
    Desk desk;
    desk.interface.notify("saved");
    for (int i = 0; i < 3; ++i) desk.frame();  // until it has its size
    EXPECT_GT(desk.interface.seconds_until_change(), 0);
    EXPECT_LT(desk.interface.seconds_until_change(), 10);
    for (int i = 0; i < 60 * 10; ++i) desk.frame();
    EXPECT_TRUE(std::isinf(desk.interface.seconds_until_change()));
}

TEST(interface, two_interfaces_do_not_disturb_each_other) {
    Desk one(describe("mesh"));
    Desk two(describe("rope"));
    one.click("play");
    two.click("step");
    EXPECT_EQ(one.calls(), std::vector<std::string>{"play"});
    EXPECT_EQ(two.calls(), std::vector<std::string>{"step forward"});
}

TEST(interface, fonts_are_rebuilt_only_for_another_scale) {
    Desk desk;
    EXPECT_FALSE(desk.interface.resize({800, 600, 1}));
    desk.frame();
    EXPECT_TRUE(desk.interface.resize({1600, 1200, 2}));
    desk.frame();
    desk.frame();
    EXPECT_TRUE(desk.has("play"));
}

TEST(fonts, letters_that_the_interface_needs_are_there) {
    ImFontAtlas atlas;
    const Fonts fonts = load_fonts(atlas, 1, render::find_font_files());
    ASSERT_NE(fonts.source, "built in") << "fonts-inter or fonts-dejavu-core is on the list of packages";
    for (const ImWchar letter : std::u16string_view(u"·ω²³½∞Δ–üöő×")) {
        for (const ImFont* font : {fonts.body, fonts.strong, fonts.small, fonts.heading}) {
            EXPECT_NE(font->FindGlyphNoFallback(letter), nullptr) << std::hex << letter;
        }
    }
}

TEST(fonts, digits_are_all_of_one_width) {
    ImFontAtlas atlas;
    const Fonts fonts = load_fonts(atlas, 1.5f, render::find_font_files());
    for (const ImFont* font : {fonts.body, fonts.small}) {
        for (ImWchar digit = '1'; digit <= '9'; ++digit) {
            EXPECT_FLOAT_EQ(font->FindGlyph(digit)->AdvanceX, font->FindGlyph('0')->AdvanceX);
        }
    }
}

TEST(fonts, without_any_font_file_the_built_in_one_is_used) {
    ImFontAtlas atlas;
    const Fonts fonts = load_fonts(atlas, 1, {});
    EXPECT_EQ(fonts.source, "built in");
    EXPECT_NE(fonts.body->FindGlyphNoFallback('a'), nullptr);
}

}  // namespace
}  // namespace steplab::ui
