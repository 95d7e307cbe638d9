// Where plots stand, however many are chosen.
#include "ui/plot/plot_places.hpp"

#include "ui/plot/draw_plot.hpp"
#include "ui/plot/recorded.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>

namespace steplab::ui {
namespace {

constexpr Area area{300, 500, 980, 228};

bool overlap(const Area& a, const Area& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

TEST(plot_places, lie_in_their_area_and_nowhere_over_each_other) {
    for (const float unit : {0.75f, 1.0f, 1.25f, 2.0f}) {
        for (const float height : {150.0f, 228.0f, 400.0f, 900.0f}) {
            for (std::size_t columns = 1; columns <= 4; ++columns) {
                for (std::size_t count = 1; count <= 14; ++count) {
                    const Area whole{area.x, area.y, area.width * unit, height * unit};
                    const PlotPlaces places = plot_places(whole, count, columns, 0, unit);
                    ASSERT_GE(places.plots.size(), std::min(count, columns));
                    ASSERT_EQ(places.tabs.empty(), places.plots.size() == count) << "those without room have tabs";
                    std::vector<Area> all = places.plots;
                    if (!places.tabs.empty()) all.push_back(places.tabs);
                    for (std::size_t i = 0; i < all.size(); ++i) {
                        EXPECT_GE(all[i].x, whole.x);
                        EXPECT_GE(all[i].y, whole.y);
                        EXPECT_LE(all[i].right(), whole.right() + 2) << "but for rounding";
                        EXPECT_LE(all[i].bottom(), whole.bottom() + 2);
                        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(all[i], all[j]));
                    }
                }
            }
        }
    }
}

TEST(plot_places, are_in_rows_where_there_is_the_height) {
    const auto rows = [](float height, std::size_t count) {
        const auto plots = plot_places({0, 0, 980, height}, count, 4, 0, 1).plots;
        return 1 + std::count_if(plots.begin() + 1, plots.end(), [&](const Area& a) { return a.x < 20; });
    };
    EXPECT_EQ(rows(228, 4), 1);
    EXPECT_EQ(rows(228, 7), 1) << "the others have tabs";
    EXPECT_EQ(rows(400, 4), 1) << "one row is enough";
    EXPECT_EQ(rows(400, 7), 2);
    EXPECT_EQ(rows(600, 10), 3);
}

TEST(plot_places, show_the_one_that_is_chosen_and_as_many_as_there_is_room_for) {
    const auto first = [](std::size_t from) { return plot_places(area, 7, 3, from, 1).first; };
    EXPECT_EQ(first(0), 0u);
    EXPECT_EQ(first(2), 2u);
    EXPECT_EQ(first(6), 4u) << "no place stays empty at the end";
    EXPECT_EQ(plot_places(area, 2, 3, 6, 1).first, 0u);
}

TEST(plots, of_all_kinds_are_shown_at_once_or_by_their_tabs) {
    Desk desk(describe("chain"), {1920, 1080, 1});
    EXPECT_FALSE(desk.has("energy error.tab")) << "two have room";
    while (desk.has("plots.add")) {
        desk.click("plots.add");
        desk.frame();
    }
    for (const PlotKindInfo& info : plot_kinds) {
        const std::string name(info.id);
        desk.click(name + ".tab");
        desk.frame();
        EXPECT_TRUE(desk.has(name + ".save")) << name;
    }
    desk.click("energy error.tab");
    desk.frame();
    EXPECT_FALSE(desk.has("time against error.save")) << "the last one has no room beside the first";
    for (std::size_t i = 0; i + 4 < plot_kinds.size(); ++i) {
        desk.click("plot 1");
        desk.frame();
        desk.key(Key::escape);
        const auto shown = std::find_if(plot_kinds.begin(), plot_kinds.end(), [&](const PlotKindInfo& info) {
            return desk.has(std::string(info.id) + ".close");
        });
        ASSERT_NE(shown, plot_kinds.end());
        desk.click(std::string(shown->id) + ".close");
        desk.frame();
    }
    EXPECT_FALSE(desk.has("energy error.tab")) << "four have room again";
}

// Where a scale is no whole number, a unit of the layout is none, either.
TEST(plots, lie_below_their_controls_at_any_scale) {
    for (float scale = 0.75f; scale <= 3; scale += 0.25f) {
        Desk desk(describe("chain"), {static_cast<int>(1280 * scale), static_cast<int>(800 * scale), scale});
        for (int i = 0; i < 3; ++i) desk.frame();
        EXPECT_GT(desk.widget("energy error").top, desk.widget("plot 1").bottom) << scale;
    }
}

// A long name of an axis lay over the plot beside it.
TEST(plots, have_names_of_axes_within_their_own_width) {
    for (const PlotKindInfo& info : plot_kinds) {
        Recorded recorded(describe("mesh"), 100, {55});
        Desk& desk = recorded.desk;
        const auto choice = [](PlotKind kind) { return default_choice(kind); };
        const PlotKind other = info.kind == PlotKind::energies ? PlotKind::momentum : PlotKind::energies;
        const PlotKind third = info.kind == PlotKind::displacement ? PlotKind::position : PlotKind::displacement;
        desk.interface.use({.plots = {choice(other), choice(third), choice(info.kind)}}, {});
        for (int i = 0; i < 3; ++i) desk.frame();
        const WidgetRect scale = desk.widget(std::string(info_of(third).id) + ".across");
        const float left = desk.widget("plot 3").left, middle = 0.5f * (scale.top + scale.bottom);
        EXPECT_EQ(desk.vertices_within({scale.right + 1, scale.top, left - 1, middle}), 0) << info.id;
        if (!is_of_particles(info.kind)) continue;  // it may be empty
        EXPECT_GT(desk.vertices_within({left, scale.top, left + 200, middle}), 0) << info.id;
    }
}

}  // namespace
}  // namespace steplab::ui
