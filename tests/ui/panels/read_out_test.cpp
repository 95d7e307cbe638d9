#include "render/run_labels.hpp"
#include "render/split.hpp"
#include "ui/desk.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

/// What is drawn behind all panels: the read-out and nothing else.
std::optional<WidgetRect> read_out(const Desk& desk) {
    const ImDrawData& data = desk.interface.draw_data();
    if (data.CmdListsCount == 0) return std::nullopt;
    std::optional<WidgetRect> around;
    for (const ImDrawVert& vertex : data.CmdLists[0]->VtxBuffer) {
        const auto [x, y] = vertex.pos;
        if (!around) around = WidgetRect{x, y, x, y};
        around = WidgetRect{std::min(around->left, x), std::min(around->top, y), std::max(around->right, x),
                            std::max(around->bottom, y)};
    }
    return around;
}

struct Shown {
    Display display;
    std::size_t runs;
    render::RunLayout layout;
    std::string text() const {
        return std::to_string(display.width) + "x" + std::to_string(display.height) + ", " + std::to_string(runs) +
               " runs, " + std::string(id(layout));
    }
};

std::vector<Shown> all_shown() {
    std::vector<Shown> all;
    for (const auto& [width, height, scale] : {Display{400, 300, 1},
                                               {480, 360, 1},
                                               {640, 480, 1},
                                               {700, 400, 1},
                                               {800, 600, 1},
                                               {1000, 300, 1},
                                               {1000, 700, 1},
                                               {1024, 768, 1},
                                               {1280, 720, 1},
                                               {1280, 720, 2},
                                               {1920, 1080, 1},
                                               {3840, 2160, 1},
                                               {3840, 2160, 2}}) {
        for (std::size_t runs = 1; runs <= render::most_shown_runs; ++runs) {
            for (const auto layout : {render::RunLayout::ghosts, render::RunLayout::split})
                all.push_back({{width, height, scale}, runs, layout});
        }
    }
    return all;
}

/// A desk that shows so many runs, with all lines in its read-out: that of the ensemble is one of them.
struct ComparedRuns : Desk {
    explicit ComparedRuns(const Shown& shown) : Desk(describe("mesh"), shown.display) {
        style.layout = shown.layout;
        view.baseline_step = 5;
        view.frame.ensemble.resize(3);
        for (std::size_t i = 1; i < shown.runs; ++i) session.followers.push_back(view);
        for (int i = 0; i < 3; ++i) frame();
    }
    PixelRect tile(const Shown& shown) const {
        const PixelRect scene = interface.scene();
        const auto tile = render::areas_of({scene.width, scene.height}, shown.layout, shown.runs).front();
        return {scene.x + tile.left, scene.y + tile.top, tile.size.width, tile.size.height};
    }
};

TEST(read_out, keeps_to_the_picture_of_the_leading_run_in_windows_of_any_size) {
    for (const Shown& shown : all_shown()) {
        const ComparedRuns desk(shown);
        const auto place = read_out(desk);
        const PixelRect tile = desk.tile(shown);
        ASSERT_TRUE(place) << shown.text();
        EXPECT_GE(place->left, static_cast<float>(tile.x)) << shown.text();
        EXPECT_GE(place->top, static_cast<float>(tile.y)) << shown.text();
        EXPECT_LE(place->right, static_cast<float>(tile.x + tile.width)) << shown.text();
        EXPECT_LE(place->bottom, static_cast<float>(tile.y + tile.height)) << shown.text();
    }
}

TEST(read_out, leaves_the_lines_about_the_runs_their_place) {
    for (const Shown& shown : all_shown()) {
        ComparedRuns desk(shown);
        desk.style.displacements = 100;
        desk.frame();
        const auto place = read_out(desk);
        const PixelRect tile = desk.tile(shown);
        ASSERT_TRUE(place) << shown.text();
        const std::size_t lines =
            shown.runs == 1 || shown.layout == render::RunLayout::split ? (shown.runs == 1 ? 1 : 2) : shown.runs + 1;
        const auto area = render::run_lines_area({tile.width, tile.height}, shown.layout, lines,
                                                 static_cast<double>(shown.display.scale));
        const bool beside = place->right <= static_cast<float>(tile.x + area.left);
        const bool above = place->bottom <= static_cast<float>(tile.y + area.top);
        EXPECT_TRUE(beside || above) << shown.text();
        EXPECT_GE(area.left, 0) << shown.text();
        EXPECT_GE(area.top, 0) << shown.text();
        EXPECT_LE(area.top + area.size.height, tile.height) << shown.text();
    }
}

TEST(read_out, has_all_its_lines_where_there_is_room) {
    const Shown small{{400, 300, 1}, 4, render::RunLayout::split}, large{{1280, 720, 1}, 4, render::RunLayout::split};
    const auto height = [](const Shown& shown) {
        const auto place = read_out(ComparedRuns(shown));
        return place ? place->bottom - place->top : 0;
    };
    EXPECT_LT(height(small), 40) << "one line";
    EXPECT_GT(height(large), 80) << "five lines";
}

/// The places and glyphs of what is drawn behind all panels.
std::vector<std::array<float, 4>> glyphs(const Desk& desk) {
    std::vector<std::array<float, 4>> all;
    for (const ImDrawVert& vertex : desk.interface.draw_data().CmdLists[0]->VtxBuffer)
        all.push_back({vertex.pos.x, vertex.pos.y, vertex.uv.x, vertex.uv.y});
    return all;
}

TEST(read_out, says_of_what_moment_the_picture_is) {
    Desk desk(describe("mesh"), {1280, 720, 1});
    const auto before = glyphs(desk);
    const SessionView pictured = desk.session;
    desk.view.frame.step = 12345;
    desk.interface.draw(desk.session, desk.recorder, {desk.camera, desk.style, &pictured});
    EXPECT_EQ(glyphs(desk), before) << "a picture that takes long";
    desk.frame();
    EXPECT_NE(glyphs(desk), before) << "the picture of the newest moment";
}

TEST(read_out, says_nothing_of_a_picture_of_another_run) {
    Desk desk(describe("mesh"), {1280, 720, 1});
    SessionView pictured = desk.session;
    desk.view.frame.step = 12345;
    desk.frame();
    const auto newest = glyphs(desk);
    pictured.leading.run += 1;
    desk.interface.draw(desk.session, desk.recorder, {desk.camera, desk.style, &pictured});
    EXPECT_EQ(glyphs(desk), newest);
}

}  // namespace
}  // namespace steplab::ui
