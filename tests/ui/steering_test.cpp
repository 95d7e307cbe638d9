// The keyboard in place of the pointer.
#include "session/lesson.hpp"
#include "ui/desk.hpp"
#include "ui/gallery.hpp"

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
        for (const Key key : {Key::down, Key::right, Key::down, Key::left}) {
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

}  // namespace
}  // namespace steplab::ui
