#include "sim/catalogue.hpp"
#include "ui/desk.hpp"
#include "ui/widgets/widgets.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace steplab::ui {
namespace {

bool overlap(const WidgetRect& a, const WidgetRect& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

TEST(tooltip, lies_on_the_display_beside_its_item_wherever_that_is) {
    const ImVec2 display{400, 300}, size{120, 60};
    for (float x = 0; x < 380; x += 19) {
        for (float y = 0; y < 280; y += 13) {
            for (const Beside side : {Beside::below, Beside::right}) {
                const WidgetRect item{x, y, x + 20, y + 20};
                const ImVec2 place = place_beside(item, size, display, 6, side);
                const WidgetRect box{place.x, place.y, place.x + size.x, place.y + size.y};
                EXPECT_FALSE(overlap(box, item));
                EXPECT_TRUE(box.left >= 0 && box.top >= 0 && box.right <= display.x && box.bottom <= display.y);
            }
        }
    }
}

TEST(tooltip, is_on_the_display_even_where_no_side_has_room) {
    const ImVec2 place = place_beside({10, 10, 390, 290}, {200, 100}, {400, 300}, 6, Beside::below);
    EXPECT_TRUE(place.x >= 0 && place.x + 200 <= 400 && place.y >= 0 && place.y + 100 <= 300);
}

TEST(tooltip, of_the_window_does_not_cover_what_it_explains) {
    for (const Display& display : {Display{1280, 800, 1}, Display{1000, 640, 1}, Display{2560, 1600, 2}}) {
        Desk desk(describe("chain"), display);
        std::size_t seen = 0;
        const WidgetMap widgets = desk.interface.widgets();
        for (const auto& [name, place] : widgets) {
            if (name == "displacement" || name == "energy error" || place.bottom > static_cast<float>(display.height))
                continue;
            desk.point_at(name);
            desk.frame();
            if (!desk.has("tooltip")) continue;
            ++seen;
            EXPECT_FALSE(overlap(desk.widget("tooltip"), place)) << name;
        }
        EXPECT_GT(seen, 10u);
    }
}

TEST(tooltip, of_a_method_lies_beside_the_menu) {
    Desk desk(describe("chain"));
    desk.click("method");
    for (const Method& entry : methods()) {
        const std::string item = "method/" + std::string(entry.info.id);
        desk.point_at(item);
        desk.frame();
        ASSERT_TRUE(desk.has("tooltip")) << item;
        for (const Method& other : methods())
            EXPECT_FALSE(overlap(desk.widget("tooltip"), desk.widget("method/" + std::string(other.info.id)))) << item;
    }
}

TEST(tooltip, of_a_plot_does_not_cover_the_curves) {
    Desk desk(describe("chain"));
    desk.view.frame.step = 1;
    desk.view.frame.time = 0.1;
    desk.view.tracked = Tracked{3, {0.1, 0, 0}, {}};
    desk.view.series.samples = {sample_of(desk.view)};
    desk.interface.record(desk.view);
    desk.frame();
    desk.point_at("displacement");
    desk.frame();
    ASSERT_TRUE(desk.has("tooltip"));
    EXPECT_FALSE(overlap(desk.widget("tooltip"), desk.widget("displacement")));
}

// A number is not torn apart at its decimal point.
TEST(tooltip, breaks_its_lines_at_blanks_alone) {
    Desk desk;
    desk.frame();
    const std::string text = "stability limit 1.43 s, ω_max 1.97 rad/s; at rest: 0.5 (2.5e-3)";
    const auto width_of = [](const std::string& part) { return ImGui::CalcTextSize(part.c_str()).x; };
    for (float width = 5; width < width_of(text) + 20; width += 7) {
        std::istringstream lines(in_words(text, width));
        std::string joined;
        for (std::string line; std::getline(lines, line);) {
            EXPECT_TRUE(width_of(line) <= width || line.find(' ') == std::string::npos) << line;
            joined += (joined.empty() ? "" : " ") + line;
        }
        EXPECT_EQ(joined, text) << width;
    }
}

// The words that an item shows are explained below what its tooltip says.
TEST(tooltip, of_a_term_explains_it) {
    Desk desk(describe("chain"));
    desk.point_at("precision/float");
    desk.frame();
    const WidgetRect with_terms = desk.widget("tooltip");
    desk.point_at("snapshot");
    desk.frame();
    const WidgetRect without = desk.widget("tooltip");
    EXPECT_GT(with_terms.bottom - with_terms.top, 2 * (without.bottom - without.top));
}

/// How high the tooltip is at a place; 0: there is none.
float height_of_tooltip(Desk& desk, float x, float y) {
    desk.move_to(x, y);
    desk.frame();
    if (!desk.has("tooltip")) return 0;
    const WidgetRect tooltip = desk.widget("tooltip");
    return tooltip.bottom - tooltip.top;
}

TEST(tooltip, of_the_read_out_and_of_dt_explains_their_words) {
    Desk desk(describe("chain"));
    desk.frame();
    const auto left = static_cast<float>(desk.interface.scene().x + 40),
               top = static_cast<float>(desk.interface.scene().y);
    EXPECT_EQ(height_of_tooltip(desk, left, top + 35), 0) << "time and step";
    float highest = 0;
    for (float y = 40; y < 110; y += 2) highest = std::max(highest, height_of_tooltip(desk, left, top + y));
    EXPECT_GT(highest, 20) << "energy error";
    EXPECT_EQ(height_of_tooltip(desk, left + 500, top + 60), 0) << "beside it";
    desk.point_at("snapshot");
    desk.frame();
    const WidgetRect one_line = desk.widget("tooltip");
    desk.point_at("dt", 0.3f);
    desk.frame();
    const WidgetRect explained = desk.widget("tooltip");
    EXPECT_GT(explained.bottom - explained.top, 3 * (one_line.bottom - one_line.top));
}

}  // namespace
}  // namespace steplab::ui
