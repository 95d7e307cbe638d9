// The keyboard in place of the pointer.
#include "session/lesson.hpp"
#include "session/run_name.hpp"
#include "ui/gallery.hpp"
#include "ui/plot/recorded.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <string>

namespace steplab::ui {
namespace {

/// Whether F6 and the arrows lead there.
bool leads_to(Desk& desk, const std::string& widget) {
    for (int panel = 0; panel < 8; ++panel) {
        desk.key(Key::f6);
        for (const Key key : {Key::down, Key::right, Key::down, Key::left, Key::up, Key::right, Key::up, Key::left}) {
            for (int i = 0; i < 30; ++i) {
                if (desk.interface.focused() == widget) return true;
                desk.key(key);
            }
        }
    }
    return false;
}

TEST(steering, leads_to_what_is_offered_after_a_divergence) {
    Desk desk(describe("chain"));
    desk.view.divergence.emplace().message = "it diverged";
    for (int i = 0; i < 3; ++i) desk.frame();
    ASSERT_TRUE(desk.has("divergence.close"));
    EXPECT_TRUE(leads_to(desk, "divergence.close"));
    EXPECT_TRUE(leads_to(desk, "method")) << "and back to the panel";
}

TEST(steering, leads_through_a_lesson) {
    Desk desk;
    desk.interface.open_lesson(find_lesson("one-step"));
    for (int i = 0; i < 3; ++i) desk.frame();
    EXPECT_TRUE(leads_to(desk, "lesson.do"));
    EXPECT_TRUE(leads_to(desk, "lesson.next"));
    EXPECT_TRUE(leads_to(desk, "lesson.close"));
}

TEST(steering, leads_to_every_scene_and_opens_it) {
    Desk desk(describe("mesh"));
    desk.interface.show_gallery(whole_gallery());
    desk.click("model");
    desk.frame();
    desk.key(Key::f6);
    EXPECT_FALSE(desk.interface.focused().empty());
    ASSERT_TRUE(leads_to(desk, "model/chain"));
    desk.key(Key::enter);
    desk.frame();
    EXPECT_EQ(desk.wanted().model, "chain") << "it is opened";
}

/// What is drawn of a plot, as a drawing that is saved.
std::string drawing_of(Desk& desk, const std::string& kind) {
    desk.click(kind + ".save");
    desk.click(kind + ".svg");
    desk.frame();
    const std::string file = "steplab-" + kind + "-1.svg", text = text_of_file(file);
    std::filesystem::remove(file);
    return text;
}

TEST(steering, zooms_and_moves_a_plot_by_keys) {
    const OwnFolder folder;
    Recorded recorded("chain");
    Desk& desk = recorded.desk;
    const std::string whole = drawing_of(desk, "displacement");
    for (const bool up : {false, true}) {
        const auto after = [&](Key key) {
            EXPECT_TRUE(leads_to(desk, "displacement.scale"));
            desk.key(key, false, up);
            return drawing_of(desk, "displacement");
        };
        const std::string nearer = after(Key::equal);
        EXPECT_TRUE(nearer != whole) << up;
        const std::string later = after(Key::bracket_right);
        EXPECT_TRUE(later != nearer && later != whole) << up;
        EXPECT_TRUE(after(Key::bracket_left) == nearer) << up;
        EXPECT_TRUE(after(Key::home) == whole) << up;
    }
    const auto calls = desk.calls();
    EXPECT_EQ(std::count(calls.begin(), calls.end(), "rate"), 0) << "the speed of the run is as it was";
}

TEST(steering, leads_to_the_points_of_the_diagram_and_adds_their_runs) {
    Desk desk(describe("chain"));
    CostsView costs{.time = 60, .done = 1, .complete = true, .how = "exact"};
    RunDescription run = describe("chain", "verlet");
    run.dt = 0.25;
    costs.points = {{run, 100, 1e-3, 1e-3}, {describe("chain", "rk4"), 1000, 1e-6, 1e-2}};
    desk.session.costs = std::make_shared<const CostsView>(costs);
    choose(desk, 1, "speed against error");
    desk.frame();
    const std::string point = "speed against error.point/" + run_name(run, desk.view.description);
    EXPECT_FALSE(desk.has(point)) << "the pointer has the whole plot";
    ASSERT_TRUE(leads_to(desk, point));
    desk.key(Key::enter);
    desk.frame();
    const auto* const added = std::get_if<event::AddRun>(&desk.recorder.events.back());
    ASSERT_TRUE(added);
    EXPECT_EQ(added->description.method, "verlet");
    EXPECT_EQ(added->description.dt, 0.25);
}

TEST(steering, scrolls_long_pages_by_keys) {
    Desk desk(describe(), {1280, 460, 1});
    desk.interface.open_lesson(find_lesson("one-step"));
    for (int i = 0; i < 3; ++i) desk.frame();
    const std::string term = "lesson.term/" + find_lesson("one-step").pages[0].terms.at(0);
    const auto top_of = [&](const std::string& widget) {
        for (int i = 0; i < 3; ++i) desk.frame();
        return desk.widget(widget).top;
    };
    const float at_first = top_of(term);
    desk.key(Key::page_down);
    EXPECT_LT(top_of(term), at_first);
    desk.key(Key::page_up);
    EXPECT_EQ(top_of(term), at_first);
}

TEST(steering, scrolls_the_panel_that_it_is_in_by_keys) {
    Desk desk(describe("chain"), {1280, 620, 1});
    const auto top = [&] {
        for (int i = 0; i < 3; ++i) desk.frame();
        return desk.widget("model").top;
    };
    const float at_first = top();
    desk.key(Key::page_down);
    EXPECT_LT(top(), at_first) << "the only panel that scrolls";
    desk.key(Key::page_up);
    EXPECT_EQ(top(), at_first);
    ASSERT_TRUE(leads_to(desk, "displacement.scale"));
    const float before = top();
    desk.key(Key::page_down);
    EXPECT_EQ(top(), before) << "the keyboard is in another one";
}

/// The box around what is drawn over all else: the frame about a widget.
WidgetRect frame_of(Desk& desk) {
    const ImDrawData& data = desk.interface.draw_data();
    const ImDrawList& list = *data.CmdLists[data.CmdListsCount - 1];
    WidgetRect box{1e9f, 1e9f, -1e9f, -1e9f};
    for (const ImDrawVert& vertex : list.VtxBuffer) {
        box.left = std::min(box.left, vertex.pos.x), box.right = std::max(box.right, vertex.pos.x);
        box.top = std::min(box.top, vertex.pos.y), box.bottom = std::max(box.bottom, vertex.pos.y);
    }
    return box;
}

TEST(steering, frames_the_widget_also_where_its_panel_is_scrolled) {
    Desk desk(describe("chain"), {1280, 500, 1});
    desk.key(Key::f6);
    for (int i = 0; i < 26; ++i) {
        for (int frame = 0; frame < 3; ++frame) desk.frame();
        const std::string name = desk.interface.focused();
        ASSERT_FALSE(name.empty());
        const WidgetRect widget = desk.widget(name), box = frame_of(desk);
        constexpr float about = 5;  // the frame lies outside, with its soft edge
        EXPECT_NEAR(box.left, widget.left, about) << name;
        EXPECT_NEAR(box.right, widget.right, about) << name;
        EXPECT_NEAR(box.top, widget.top, about) << name;
        EXPECT_NEAR(box.bottom, widget.bottom, about) << name;
        desk.key(Key::down);
    }
}

// The widget at which the keyboard enters a panel was out of view where the panel had been scrolled.
TEST(steering, scrolls_a_panel_to_where_it_enters_it) {
    Desk desk(describe("mesh"), {1280, 600, 1});
    for (int i = 0; i < 3; ++i) desk.frame();
    const auto enter = [&] {
        for (int panel = 0; panel < 8; ++panel) {
            desk.key(Key::f6);
            desk.frame();
            desk.frame();
            if (desk.interface.focused() == "model") return true;
        }
        return false;
    };
    ASSERT_TRUE(enter());
    const WidgetRect before = desk.widget("model");
    for (int i = 0; i < 3; ++i) desk.key(Key::page_down);
    desk.frame();
    ASSERT_LT(desk.widget("model").top, before.top - 100) << "out of view";
    ASSERT_TRUE(enter());
    EXPECT_GE(desk.widget("model").top, desk.widget("play").bottom);
}

}  // namespace
}  // namespace steplab::ui
