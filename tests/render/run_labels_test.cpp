#include "render/run_labels.hpp"

#include "render/gl.hpp"
#include "render/overlay.hpp"
#include "render/scenes.hpp"
#include "render/split.hpp"
#include "render/studio.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace steplab::render {
namespace {

using namespace steplab::test;

struct RunLabels : Studio {
    /// So many runs with these names, at rest in the same place.
    static Image draw_runs(const Frame& frame, const std::vector<std::string>& names, PictureSize size, bool legend) {
        std::vector<ShownRun> runs;
        for (const std::string& name : names) runs.push_back({&frame, name});
        Style style = bare();
        style.legend = legend;
        const RenderTarget target(size);
        renderer().draw(runs, style, straight, target);
        return {size, target.read()};
    }
    /// The part of the picture that the lines about the runs take; of width 0 if there are none.
    static PictureArea taken(const Image& with, const Image& without) {
        int left = with.size.width, top = with.size.height, right = 0, bottom = 0;
        for (int y = 0; y < with.size.height; ++y) {
            for (int x = 0; x < with.size.width; ++x) {
                if (difference(with.at(x, y), without.at(x, y)) == 0) continue;
                left = std::min(left, x), top = std::min(top, y);
                right = std::max(right, x + 1), bottom = std::max(bottom, y + 1);
            }
        }
        return {left, top, {std::max(0, right - left), std::max(0, bottom - top)}};
    }
};

const std::vector<PictureSize> sizes{{120, 60},  {170, 128}, {200, 113}, {340, 255},
                                     {400, 226}, {699, 400}, {700, 400}, {1280, 300}};

TEST_F(RunLabels, keep_to_their_area_however_long_the_names_are) {
    const Frame frame = particles_at({{0, 0, 0}});
    const std::string name =
        "stoermer-2008, dt 0.0123 s, double, first parameter 1.234, another parameter 12.5, one more 7";
    for (const PictureSize size : sizes) {
        for (std::size_t runs = 2; runs <= most_shown_runs; ++runs) {
            const std::vector<std::string> names(runs, name);
            const auto is = taken(draw_runs(frame, names, size, true), draw_runs(frame, names, size, false));
            const auto area = run_lines_area(size, RunLayout::ghosts, runs, 1);
            const std::string text = std::to_string(size.width) + ", runs " + std::to_string(runs);
            EXPECT_GT(is.size.width, 60) << text;
            EXPECT_GE(is.left, area.left) << text;
            EXPECT_GE(is.top, std::max(0, area.top)) << text;
            EXPECT_LE(is.left + is.size.width, size.width) << text;
            EXPECT_LE(is.top + is.size.height, area.top + area.size.height) << text;
        }
    }
}

TEST_F(RunLabels, of_short_names_are_whole) {
    const Frame frame = particles_at({{0, 0, 0}});
    const PictureSize size{340, 255};
    const auto width = [&](const std::string& name) {
        const std::vector<std::string> names(2, name);
        return taken(draw_runs(frame, names, size, true), draw_runs(frame, names, size, false)).size.width;
    };
    EXPECT_LT(width("rk4"), width("rk4, dt 0.1 s"));
    EXPECT_LT(width("rk4, dt 0.1 s"), width("rk4, dt 0.1 s, double"));
}

TEST_F(RunLabels, are_not_drawn_over_names_of_axes) {
    const PictureSize size{200, 100};
    const Axes axes{{}, {{"x [m]", {100, 50}, 1}}};
    const auto drawn = [&](const PictureArea& texts) {
        const RenderTarget target(size);
        target.bind_picture();
        glClear(GL_COLOR_BUFFER_BIT);
        Sketch sketch;
        sketch.begin(size, 1);
        sketch_labels(sketch, axes, Occupancy(size), texts, size, palette(Background::dark));
        sketch.finish({size}, size);
        return target.read();
    };
    const auto nothing = drawn({0, 0, size});
    EXPECT_NE(drawn({0, 0, {0, 0}}), nothing);
    EXPECT_EQ(drawn({100, 40, {50, 20}}), nothing) << "half of it";
    EXPECT_NE(drawn({100, 70, {50, 20}}), nothing) << "below it";
    EXPECT_NE(drawn({140, 40, {50, 20}}), nothing) << "right of it";
}

TEST(run_labels, have_a_part_of_their_own_beside_the_read_out_and_the_cross) {
    const auto wide = run_lines_area({1280, 720}, RunLayout::ghosts, 4, 1);
    EXPECT_GE(wide.left, read_out_room);
    EXPECT_LT(wide.top, 20);
    const auto narrow = run_lines_area({699, 720}, RunLayout::ghosts, 4, 1);
    EXPECT_GT(narrow.top, 600);
    EXPECT_GT(run_lines_area({1280, 720}, RunLayout::split, 1, 1).top, 600);
    EXPECT_GT(run_lines_area({1280, 720}, RunLayout::ghosts, 4, 2).top, 500) << "narrow at this scale";
    EXPECT_EQ(run_lines_area({1400, 720}, RunLayout::ghosts, 4, 2).top, 20);
}

}  // namespace
}  // namespace steplab::render
