#include "core/appearance.hpp"
#include "io/scene_file.hpp"
#include "sim/catalogue.hpp"
#include "ui/desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace steplab::ui {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// A desk whose page of scenes has the shipped ones, too, and is open.
struct Page {
    explicit Page(const RunDescription& run = describe("mesh"), const Display& display = {1280, 1200, 1})
        : desk(run, display) {
        desk.interface.show_gallery(whole_gallery());
        desk.click("model");
    }
    Desk desk;
};

std::string opened(Desk& desk) {
    for (const Request& request : desk.interface.take_requests()) {
        if (request.kind == Request::Kind::open_scene) return request.text;
    }
    return "none";
}

TEST(scenes_page, has_every_model_and_every_shipped_scene_by_topic) {
    const Gallery gallery = whole_gallery();
    for (const Model& model : models()) EXPECT_LT(place_in(gallery, model.info.id), gallery.size()) << model.info.id;
    for (const std::string& name : shipped_scenes()) EXPECT_LT(place_in(gallery, name), gallery.size()) << name;
    const auto rank = [](const Exhibit& e) { return std::find(topic_ids.begin(), topic_ids.end(), e.topic); };
    EXPECT_TRUE(std::is_sorted(gallery.begin(), gallery.end(),
                               [&](const auto& a, const auto& b) { return rank(a) < rank(b); }));
}

TEST(scenes_page, covers_the_panels_until_it_is_closed) {
    Page page;
    EXPECT_TRUE(page.desk.interface.shows_scenes());
    EXPECT_FALSE(page.desk.has("method"));
    EXPECT_TRUE(page.desk.has("play"));
    page.desk.click("scenes.close");
    EXPECT_FALSE(page.desk.interface.shows_scenes());
    EXPECT_TRUE(page.desk.has("method"));
}

TEST(scenes_page, opens_a_shipped_scene_by_its_name) {
    Page page;
    page.desk.click("model/two-planets");
    EXPECT_EQ(opened(page.desk), "two-planets");
    EXPECT_TRUE(page.desk.interface.shows_scenes());  // until it is read
    page.desk.interface.open(describe(find_scene("two-planets")), page.desk.recorder);
    page.desk.frame();
    EXPECT_FALSE(page.desk.interface.shows_scenes());
    EXPECT_EQ(page.desk.wanted().origin->given, "two-planets");
}

TEST(scenes_page, stays_over_a_scene_that_cannot_be_read) {
    Page page;
    page.desk.click("model/two-planets");
    page.desk.interface.report_error("a.toml:3:1: no");
    page.desk.frame();
    page.desk.frame();
    EXPECT_TRUE(page.desk.interface.shows_scenes());
    EXPECT_TRUE(page.desk.has("refusal"));
    page.desk.key(Key::escape);
    EXPECT_FALSE(page.desk.has("refusal"));
    page.desk.key(Key::escape);
    EXPECT_FALSE(page.desk.interface.shows_scenes());
}

TEST(scenes_page, takes_a_path) {
    Page page;
    page.desk.click("scenes.path");
    page.desk.type("/tmp/my scene.toml");
    page.desk.key(Key::enter);
    EXPECT_EQ(opened(page.desk), "/tmp/my scene.toml");
    page.desk.click("scenes.open");
    EXPECT_EQ(opened(page.desk), "/tmp/my scene.toml");
}

TEST(scenes_page, opens_ready_to_type_by_its_key) {
    Desk desk(describe("mesh"));
    desk.key(Key::o, true);
    ASSERT_TRUE(desk.interface.shows_scenes());
    desk.frame();
    desk.type("a.toml");
    desk.key(Key::enter);
    EXPECT_EQ(opened(desk), "a.toml");
}

TEST(scenes_page, keys_of_the_run_do_nothing_behind_it) {
    Page page;
    page.desk.calls();
    for (const Key key : {Key::space, Key::right, Key::backspace, Key::equal, Key::bracket_right, Key::home})
        page.desk.key(key);
    EXPECT_THAT(page.desk.calls(), IsEmpty());
    EXPECT_THAT(page.desk.interface.take_requests(), IsEmpty());
}

// Brackets go through the page, also where scenes are not read as fast as they are asked for.
TEST(scenes_page, brackets_go_through_its_scenes) {
    const Gallery gallery = whole_gallery();
    const auto first = std::find_if(gallery.begin(), gallery.end(), [](const Exhibit& e) { return !e.is_model; });
    ASSERT_NE(first, gallery.begin());
    Desk desk(describe((first - 1)->id));
    desk.interface.show_gallery(gallery);
    desk.key(Key::bracket_right);
    EXPECT_EQ(opened(desk), first->id);
    desk.key(Key::bracket_right);
    if ((first + 1)->is_model) {
        EXPECT_EQ(desk.wanted().model, (first + 1)->id);
    } else {
        EXPECT_EQ(opened(desk), (first + 1)->id);
    }
}

// Every tile can be reached: the page scrolls where the window is low.
TEST(scenes_page, scrolls_where_the_window_is_low) {
    Page page(describe("mesh"), {1280, 500, 1});
    const std::string last = "model/" + whole_gallery().back().id;
    EXPECT_FALSE(page.desk.has(last));
    page.desk.move_to(640, 300);
    for (int i = 0; i < 40; ++i) page.desk.wheel(-5);
    page.desk.frame();
    EXPECT_TRUE(page.desk.has(last));
}

TEST(scenes_page, saving_a_scene_is_asked_of_the_program) {
    Desk desk(describe("chain"));
    desk.key(Key::s, true);
    const auto requests = desk.interface.take_requests();
    ASSERT_THAT(requests, SizeIs(1));
    EXPECT_EQ(requests.front().kind, Request::Kind::save_scene);
}

TEST(menu, saving_a_session_is_asked_of_the_program) {
    Desk desk(describe("chain"));
    desk.click("menu");
    desk.click("menu/save session");
    const auto requests = desk.interface.take_requests();
    ASSERT_THAT(requests, SizeIs(1));
    EXPECT_EQ(requests.front().kind, Request::Kind::save_session);
}

}  // namespace
}  // namespace steplab::ui
