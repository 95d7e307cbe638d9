#include "ui/plot/recorded.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

/// Everything that is drawn, as bytes.
std::string drawn(const Desk& desk) {
    std::string bytes;
    const ImDrawData& data = desk.interface.draw_data();
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const auto& vertices = data.CmdLists[i]->VtxBuffer;
        bytes.append(reinterpret_cast<const char*>(vertices.Data), static_cast<std::size_t>(vertices.size_in_bytes()));
    }
    return bytes;
}

/// A desk with a run of some steps, so that its plots have curves.
struct RecordedPictures {
    explicit RecordedPictures(const Display& display = {1280, 1200, 1}) : desk(describe("chain"), display) {
        Simulation simulation(describe("chain"));
        for (int i = 0; i < 20; ++i) {
            simulation.advance(1);
            desk.show(view_of(simulation, 3));
        }
        desk.recorder = {};
    }
    std::string picture() {
        desk.picture();
        return drawn(desk);
    }
    Desk desk;
};

TEST(picture, holds_nothing_of_the_pointer) {
    RecordedPictures recorded;
    Desk& desk = recorded.desk;
    const std::string clean = recorded.picture();
    for (const char* widget : {"displacement", "energy error", "dt", "play", "displacement.save"}) {
        desk.frame();
        desk.point_at(widget);
        desk.frame();
        EXPECT_NE(drawn(desk), clean) << widget << " is highlighted in the window";
        EXPECT_EQ(recorded.picture(), clean) << widget;
    }
}

TEST(picture, holds_no_ring_around_the_particle_under_the_pointer) {
    RecordedPictures recorded;
    Desk& desk = recorded.desk;
    const std::string clean = recorded.picture();
    const PixelRect rect = desk.interface.scene();
    const auto pixel = render::Projection(desk.camera, {rect.width, rect.height}).pixel(desk.view.frame.positions[4]);
    desk.move_to(static_cast<float>(rect.x + pixel->x), static_cast<float>(rect.y + pixel->y));
    const std::string with_ring = drawn(desk);
    desk.move_to(static_cast<float>(rect.x + 4), static_cast<float>(rect.y + 4));
    EXPECT_NE(with_ring, drawn(desk));
    desk.move_to(static_cast<float>(rect.x + pixel->x), static_cast<float>(rect.y + pixel->y));
    EXPECT_EQ(recorded.picture(), clean);
}

TEST(picture, holds_no_notice_and_no_menu) {
    RecordedPictures recorded;
    Desk& desk = recorded.desk;
    const std::string clean = recorded.picture();
    desk.interface.notify("saved something else");
    for (const char* menu : {"menu", "method", "displacement.save"}) {
        desk.frame();
        desk.click(menu);
        ASSERT_NE(drawn(desk), clean);
        EXPECT_EQ(recorded.picture(), clean) << menu;
        desk.key(Key::escape);
    }
    desk.frame();
    EXPECT_TRUE(desk.has("notice")) << "in the window it is still there";
}

// A tile of a small window has room for little: the picture says all the same what it is of.
TEST(picture, of_a_plot_is_the_same_whatever_the_size_of_the_window_and_of_its_tile) {
    std::set<int> vertices;
    Recorded recorded("chain");
    for (const Display& display : {Display{640, 480, 1}, Display{1000, 600, 1}, Display{900, 900, 1}}) {
        recorded.desk.interface.resize(display);
        recorded.desk.frame();
        const WidgetRect place = recorded.desk.plot_picture("energy error");
        EXPECT_GE(place.left, static_cast<float>(display.width)) << "it does not lie over the window";
        EXPECT_EQ(place.right - place.left, 960);
        EXPECT_EQ(place.bottom - place.top, 540);
        vertices.insert(recorded.desk.vertices_within(place));
    }
    EXPECT_EQ(vertices.size(), 1u);
    EXPECT_GT(*vertices.begin(), 500) << "with axes and their numbers, a curve, a legend and a caption";
}

TEST(picture, of_a_plot_holds_no_card_that_lies_over_it_in_the_window) {
    RecordedPictures recorded;
    const int clean = recorded.desk.vertices_within(recorded.desk.plot_picture("displacement"));
    const std::string window = recorded.picture();
    recorded.desk.frame();
    recorded.desk.key(Key::f1);
    EXPECT_EQ(recorded.desk.vertices_within(recorded.desk.plot_picture("displacement")), clean);
    EXPECT_NE(recorded.picture(), window);
}

TEST(picture, of_a_plot_leaves_its_tile_as_it_is) {
    RecordedPictures recorded({640, 480, 1});
    recorded.desk.frame();
    const std::string window = recorded.picture();
    recorded.desk.plot_picture("energy error");
    EXPECT_EQ(recorded.picture(), window);
    EXPECT_EQ(recorded.desk.vertices_within({641, 0, 3000, 3000}), 0) << "nothing is left beside the window";
}

TEST(picture, holds_no_button_that_saves_plots) {
    RecordedPictures recorded;
    Desk& desk = recorded.desk;
    desk.frame();
    const WidgetRect button = desk.widget("displacement.save");
    EXPECT_GT(desk.vertices_within(button), 0);
    desk.picture();
    EXPECT_EQ(desk.vertices_within(button), 0);
}

TEST(picture, changes_nothing_in_the_window) {
    RecordedPictures recorded;
    Desk& desk = recorded.desk;
    desk.point_at("dt", 0.3f);
    desk.press();
    desk.point_at("dt", 0.4f);
    const double before = desk.wanted().dt;
    const std::size_t changes = desk.recorder.changes.size();
    desk.picture();
    desk.frame();
    EXPECT_EQ(desk.recorder.changes.size(), changes) << "the picture moved the slider";
    desk.point_at("dt", 0.6f);
    EXPECT_GT(desk.wanted().dt, before) << "the drag goes on";
    desk.release();
    desk.click("dt.value");
    ASSERT_TRUE(desk.has("dt.entry"));
    desk.picture();
    desk.type("0.25");
    desk.key(Key::enter);
    EXPECT_EQ(desk.wanted().dt, 0.25) << "the text entry goes on";
}

// As in a film of the window: a picture after each frame.
TEST(picture, leaves_menus_open_and_their_items_at_work) {
    RecordedPictures recorded;
    Desk& desk = recorded.desk;
    const auto then_pictures = [&](auto act) {
        act();
        for (int i = 0; i < 3; ++i) {
            desk.picture();
            desk.frame();
        }
    };
    then_pictures([&] { desk.click("menu"); });
    then_pictures([&] { desk.point_at("menu/pictures"); });
    ASSERT_TRUE(desk.has("menu/caption"));
    desk.point_at("menu/caption");
    then_pictures([&] { desk.press(); });
    then_pictures([&] { desk.release(); });
    EXPECT_TRUE(desk.interface.picture_choice().caption);
    EXPECT_FALSE(desk.has("menu/caption"));
}

TEST(picture, leaves_the_places_of_what_is_on_the_screen) {
    RecordedPictures recorded;
    Desk& desk = recorded.desk;
    desk.interface.show_film(FilmStatus{3, 0.1});
    for (int i = 0; i < 3; ++i) desk.frame();
    const WidgetRect wide = desk.widget("record");
    desk.picture();
    EXPECT_EQ(desk.widget("record"), wide) << "in the picture the button tells nothing of the film";
    EXPECT_EQ(desk.interface.seconds_until_change(), std::numeric_limits<double>::infinity());
}

TEST(notice, of_a_saved_file_has_its_whole_path_and_a_click_copies_it) {
    Desk desk;
    desk.interface.notify_saved("steplab-chain-1.png");
    for (int i = 0; i < 2; ++i) desk.frame();
    desk.point_at("notice");
    desk.frame();
    EXPECT_TRUE(desk.has("tooltip"));
    desk.click("notice");
    const auto requests = desk.interface.take_requests();
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(requests[0].kind, Request::Kind::copy_text);
    EXPECT_EQ(requests[0].text, (std::filesystem::current_path() / "steplab-chain-1.png").string());
}

TEST(notice, stays_while_the_pointer_is_over_it_and_goes_afterwards) {
    Desk desk;
    desk.interface.notify_saved("steplab-chain-1.png");
    for (int i = 0; i < 2; ++i) desk.frame();
    desk.point_at("notice");
    for (int i = 0; i < 60 * 20; ++i) desk.frame();
    EXPECT_TRUE(desk.has("notice"));
    desk.move_to(-100, -100);
    for (int i = 0; i < 60 * 3; ++i) desk.frame();
    EXPECT_FALSE(desk.has("notice"));
}

TEST(notice, of_a_long_path_stays_within_the_scene) {
    Desk desk;
    desk.interface.notify_saved("/" + std::string(400, 'x') + "/a.png");
    for (int i = 0; i < 3; ++i) desk.frame();
    const WidgetRect notice = desk.widget("notice");
    const PixelRect scene = desk.interface.scene();
    EXPECT_GE(notice.left, static_cast<float>(scene.x));
    EXPECT_LE(notice.right, static_cast<float>(scene.x + scene.width));
    EXPECT_GT(notice.bottom - notice.top, 60) << "it is wrapped";
}

}  // namespace
}  // namespace steplab::ui
