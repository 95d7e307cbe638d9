#include "ui/widgets/layout.hpp"

#include "ui/desk.hpp"
#include "ui/widgets/widgets.hpp"

#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

TEST(shortened, text_ends_in_an_ellipsis_where_it_has_no_room) {
    Desk desk;
    desk.frame();
    const std::string text = "velocity-verlet, dt 0.00123 s, double, \u03c9 3.21";
    const auto width = [](const std::string& t) { return ImGui::CalcTextSize(t.c_str()).x; };
    EXPECT_EQ(shortened(text, width(text)), text);
    for (float room = width("…"); room < width(text); room += 3) {
        const std::string shorter = shortened(text, room);
        EXPECT_LE(width(shorter), room);
        ASSERT_TRUE(shorter.ends_with("…"));
        const std::string kept = shorter.substr(0, shorter.size() - std::string("…").size());
        EXPECT_TRUE(text.starts_with(kept));
        EXPECT_TRUE(kept.empty() || (static_cast<unsigned char>(text[kept.size()]) & 0xc0) != 0x80)
            << "no character is cut in two";
    }
}

bool overlap(const Area& a, const Area& b) {
    return !a.empty() && !b.empty() && a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

void expect_tiling(const Layout& layout, const Display& display) {
    const Area areas[] = {layout.bar,       layout.panel_tabs,  layout.panel, layout.plots,
                          layout.time_line, layout.run_buttons, layout.scene};
    float covered = 0;
    for (const Area& a : areas) {
        if (!a.empty()) covered += a.width * a.height;
        EXPECT_GE(a.x, 0);
        EXPECT_GE(a.y, 0);
        EXPECT_LE(a.right(), static_cast<float>(display.width));
        EXPECT_LE(a.bottom(), static_cast<float>(display.height));
        for (const Area& b : areas) EXPECT_FALSE(&a != &b && overlap(a, b));
    }
    EXPECT_FLOAT_EQ(covered, static_cast<float>(display.width) * static_cast<float>(display.height));
    EXPECT_GT(layout.scene.width, 0);
    EXPECT_GT(layout.scene.height, 0);
}

TEST(layout, panels_fill_any_window_and_never_cover_the_scene) {
    for (const auto& [width, height] :
         {std::pair{400, 300}, {640, 480}, {1280, 720}, {1280, 800}, {3840, 2160}, {300, 1600}, {5000, 300}}) {
        for (const float scale : {1.0f, 1.5f, 2.0f, 3.0f}) {
            for (const std::optional<bool> panel : {std::optional<bool>(), std::optional(true), std::optional(false)}) {
                SCOPED_TRACE(testing::Message() << width << "x" << height << " scale " << scale);
                const Display display{width, height, scale};
                Layout layout = arrange(display, panel);
                expect_tiling(layout, display);
                put_plots_into_panel(layout);
                expect_tiling(layout, display);
            }
        }
    }
}

TEST(layout, a_small_window_is_all_scene_until_the_panel_is_asked_for) {
    const Layout small = arrange({400, 300, 1});
    EXPECT_TRUE(small.panel.empty());
    EXPECT_TRUE(small.plots.empty());
    EXPECT_FALSE(arrange({400, 300, 1}, true).panel.empty());
}

TEST(layout, the_panel_can_be_hidden_in_a_large_one) {
    EXPECT_FALSE(arrange({1280, 800, 1}).panel.empty());
    const Layout hidden = arrange({1280, 800, 1}, false);
    EXPECT_TRUE(hidden.panel.empty());
    EXPECT_TRUE(hidden.plots.empty());
}

TEST(layout, twice_the_scale_is_twice_the_size) {
    const Layout one = arrange({1280, 800, 1});
    const Layout two = arrange({2560, 1600, 2});
    EXPECT_FLOAT_EQ(two.panel.width, 2 * one.panel.width);
    EXPECT_FLOAT_EQ(two.bar.height, 2 * one.bar.height);
    EXPECT_NEAR(two.plots.height, 2 * one.plots.height, 1) << "lengths are whole pixels";
}

TEST(layout, every_widget_of_the_bar_is_inside_the_window) {
    for (const int width : {400, 500, 640, 800, 1280, 3840}) {
        Desk desk(describe(), {width, 700, 1});
        std::size_t of_the_bar = 0;
        for (const auto& [name, place] : desk.interface.widgets()) {
            if (place.bottom > 40) continue;
            ++of_the_bar;
            EXPECT_GE(place.left, 0) << name << " at width " << width;
            EXPECT_LE(place.right, static_cast<float>(width)) << name << " at width " << width;
        }
        EXPECT_GE(of_the_bar, 5u) << width;
    }
}

TEST(layout, widgets_of_the_bar_do_not_overlap) {
    for (const int width : {400, 500, 620, 640, 700, 800, 820, 1000, 1280}) {
        Desk desk(describe(), {width, 700, 1});
        std::vector<std::pair<std::string, WidgetRect>> bar;
        for (const auto& [name, place] : desk.interface.widgets()) {
            if (place.bottom < 40) bar.emplace_back(name, place);
        }
        EXPECT_GE(bar.size(), 5u);
        for (const auto& [a, first] : bar) {
            for (const auto& [b, second] : bar) {
                EXPECT_FALSE(a != b && first.left < second.right - 0.5f && second.left < first.right - 0.5f)
                    << a << " and " << b << " at width " << width;
            }
        }
    }
}

}  // namespace
}  // namespace steplab::ui
