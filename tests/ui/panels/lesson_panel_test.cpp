#include "core/terms.hpp"
#include "session/lesson.hpp"
#include "ui/desk.hpp"
#include "ui/gallery.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace steplab::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A desk with a lesson open.
struct Opened {
    explicit Opened(const std::string& id = "one-step", const Display& display = {1280, 1200, 1})
        : desk(describe(), display) {
        desk.interface.open_lesson(find_lesson(id));
        desk.frame();
        desk.frame();
        desk.calls();
    }
    Desk desk;
};

TEST(lesson_panel, does_the_part_of_its_page) {
    Opened opened;
    opened.desk.click("lesson.do");
    EXPECT_THAT(opened.desk.calls(), ElementsAre("rate", "part"));
    ASSERT_EQ(opened.desk.recorder.parts.size(), 1u);
    const FilmPart& part = opened.desk.recorder.parts[0];
    EXPECT_EQ(part.from, 0u);
    EXPECT_EQ(part.to, 1u);
    EXPECT_EQ(opened.desk.recorder.rates.back().seconds_per_second, 3);
    EXPECT_TRUE(opened.desk.has("energy error.save")) << "the plots of the page";
}

TEST(lesson_panel, turns_pages_without_doing_anything) {
    Opened opened;
    Desk& desk = opened.desk;
    EXPECT_EQ(desk.interface.lesson(), "one-step 1");
    desk.click("lesson.next");
    desk.click("lesson.next");
    EXPECT_EQ(desk.interface.lesson(), "one-step 3");
    EXPECT_FALSE(desk.has("lesson.next")) << "the last page leads to the list";
    desk.click("lesson.back");
    EXPECT_EQ(desk.interface.lesson(), "one-step 2");
    EXPECT_THAT(desk.recorder.parts, IsEmpty());
    desk.click("lesson.do");
    ASSERT_EQ(desk.recorder.parts.size(), 1u);
    EXPECT_EQ(desk.recorder.parts[0].from, 1u);
}

TEST(lesson_panel, is_closed_by_its_cross_and_by_escape) {
    Opened by_cross;
    by_cross.desk.click("lesson.close");
    by_cross.desk.frame();
    EXPECT_EQ(by_cross.desk.interface.lesson(), "");
    EXPECT_FALSE(by_cross.desk.has("lesson"));
    EXPECT_TRUE(by_cross.desk.has("method"));
    Opened by_key;
    by_key.desk.key(Key::escape);
    EXPECT_EQ(by_key.desk.interface.lesson(), "");
}

// "one-step" shows the error and the displacement, at a speed of its own.
TEST(lesson_panel, that_ends_puts_back_plots_and_speed) {
    for (const bool by_key : {true, false}) {
        Opened opened("one-step", {1900, 1200, 1});  // with room for a third plot
        Desk& desk = opened.desk;
        desk.click("plots.add");
        const ViewChoices before = desk.interface.choices(desk.style);
        ASSERT_EQ(before.plots.size(), 3u);
        desk.click("lesson.do");
        desk.view.rate = desk.recorder.rates.back();
        desk.interface.record(desk.view);
        desk.frame();
        EXPECT_TRUE(desk.has("plot 2"));
        EXPECT_FALSE(desk.has("plot 3"));
        EXPECT_EQ(desk.interface.choices(desk.style).plots, before.plots) << "what the lesson shows is not remembered";
        by_key ? desk.key(Key::escape) : desk.click("lesson.close");
        desk.frame();
        EXPECT_TRUE(desk.has("plot 3"));
        EXPECT_EQ(desk.recorder.rates.back(), Rate{});
    }
}

TEST(lesson_panel, that_ends_leaves_what_was_chosen_since) {
    Opened opened;
    Desk& desk = opened.desk;
    desk.click("lesson.do");
    desk.view.rate = {false, 7};  // as a person set it
    desk.interface.record(desk.view);
    for (int i = 0; i < 4; ++i) desk.show(desk.view);
    desk.click("energy error.scale");
    const auto chosen = desk.interface.choices(desk.style).plots;
    const std::size_t rates = desk.recorder.rates.size();
    desk.click("lesson.close");
    EXPECT_EQ(desk.interface.choices(desk.style).plots, chosen);
    EXPECT_EQ(desk.recorder.rates.size(), rates) << "the speed stays";
}

TEST(lesson_panel, is_over_with_its_last_page) {
    Opened opened;
    Desk& desk = opened.desk;
    desk.click("lesson.next");
    desk.click("lesson.next");
    desk.click("lesson.end");
    EXPECT_EQ(desk.interface.lesson(), "");
    EXPECT_TRUE(desk.interface.shows_scenes());
}

TEST(lesson_panel, leaves_the_other_panels_as_they_are) {
    Opened opened;
    for (const char* const widget : {"method", "dt", "play", "add run", "lesson.do"})
        EXPECT_TRUE(opened.desk.has(widget)) << widget;
    opened.desk.click("step");
    EXPECT_THAT(opened.desk.calls(), ElementsAre("step forward"));
    EXPECT_EQ(opened.desk.interface.lesson(), "one-step 1");
}

// The panel at the left has no room beside it there; Tab shows it.
TEST(lesson_panel, stands_beside_the_scene_in_a_small_window) {
    Opened opened("one-step", {800, 600, 1});
    EXPECT_FALSE(opened.desk.has("method"));
    const WidgetRect lesson = opened.desk.widget("lesson"), button = opened.desk.widget("lesson.next");
    EXPECT_EQ(lesson.right, 800);
    EXPECT_LE(button.bottom, 600);
    EXPECT_LE(opened.desk.interface.scene().x + opened.desk.interface.scene().width, lesson.left);
    opened.desk.key(Key::tab);
    opened.desk.frame();
    EXPECT_TRUE(opened.desk.has("method"));
    EXPECT_TRUE(opened.desk.has("lesson.do"));
}

// Two plots with the legends of several runs could not be read there.
TEST(lesson_panel, shows_one_plot_in_a_small_window_and_two_in_a_usual_one) {
    Opened small("one-step", {800, 600, 1}), usual("one-step", {1280, 720, 1});
    for (Desk* const desk : {&small.desk, &usual.desk}) {
        desk->click("lesson.do");
        desk->frame();
        EXPECT_TRUE(desk->has("energy error.save"));
    }
    EXPECT_FALSE(small.desk.has("displacement.save"));
    EXPECT_TRUE(usual.desk.has("displacement.save"));
}

TEST(lesson_panel, explains_its_words) {
    Opened opened;
    opened.desk.point_at("lesson.term/dt");
    opened.desk.frame();
    EXPECT_TRUE(opened.desk.has("tooltip"));
}

// Whatever is on a page of a shipped lesson, its buttons are in the window.
TEST(lesson_panel, draws_every_page_of_every_lesson) {
    for (const Lesson& lesson : shipped_lessons()) {
        Opened opened(lesson.id, {800, 600, 1});
        for (std::size_t page = 1; page < lesson.pages.size(); ++page) opened.desk.click("lesson.next");
        EXPECT_EQ(opened.desk.interface.lesson(), lesson.id + " " + std::to_string(lesson.pages.size()));
        EXPECT_TRUE(opened.desk.has("lesson.end")) << lesson.id;
    }
}

TEST(lesson_list, opens_a_lesson_by_its_name) {
    Desk desk;
    desk.interface.show_lessons(lesson_titles());
    desk.click("menu");
    desk.frame();
    desk.click("menu/try");
    desk.frame();
    EXPECT_TRUE(desk.interface.shows_scenes());
    EXPECT_FALSE(desk.has("model/chain"));
    desk.click("lesson/one-step");
    const std::vector<Request> requests = desk.interface.take_requests();
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(requests[0].kind, Request::Kind::open_lesson);
    EXPECT_EQ(requests[0].text, "one-step");
    desk.interface.open_lesson(find_lesson("one-step"));
    desk.frame();
    EXPECT_FALSE(desk.interface.shows_scenes());
}

TEST(lesson_list, is_a_sheet_of_the_page_of_scenes) {
    Desk desk;
    desk.interface.show_lessons(lesson_titles());
    desk.click("model");
    desk.frame();
    EXPECT_TRUE(desk.has("model/chain"));
    EXPECT_FALSE(desk.has("lesson/one-step"));
    desk.click("sheet/lessons");
    desk.frame();
    for (const LessonTitle& title : lesson_titles()) EXPECT_TRUE(desk.has("lesson/" + title.id)) << title.id;
    desk.click("sheet/scenes");
    desk.frame();
    EXPECT_TRUE(desk.has("model/chain"));
}

TEST(lesson_list, has_a_scene_for_every_picture) {
    const Gallery gallery = whole_gallery();
    for (const LessonTitle& title : lesson_titles())
        EXPECT_LT(place_in(gallery, title.scene), gallery.size()) << title.id;
}

TEST(Lessons, know_the_plots_of_the_window) {
    for (const std::string_view plot : lesson_plots) {
        const bool known = std::any_of(plot_kinds.begin(), plot_kinds.end(),
                                       [&](const PlotKindInfo& info) { return info.id == plot; });
        EXPECT_TRUE(known) << plot;
    }
}

}  // namespace
}  // namespace steplab::ui
