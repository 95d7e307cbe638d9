// Displacements that are drawn larger than they are.
#include "render/ghosts.hpp"
#include "render/picking.hpp"
#include "render/run_labels.hpp"
#include "render/scenes.hpp"
#include "render/studio.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace steplab::render {
namespace {

using test::Image;
using test::small_size;
using test::straight;

constexpr double factor = 1024;  // a power of two: products and quotients are not rounded
const std::vector<Vec3> rest{{-1, 0, 0}, {0, 0.25, 0}, {1, 0, 0}};
const std::vector<Vec3> moved{{0.25, 0.125, 0}, {-0.125, 0.5, 0.25}, {0.0625, -0.25, 0}};

/// A string whose particles, and those of an ensemble of two runs, are displaced by `part` of what `moved` says.
Frame displaced(double part) {
    Frame frame = test::string_of(rest);
    for (std::size_t i = 0; i < rest.size(); ++i) frame.positions[i] = rest[i] + part * moved[i];
    for (std::size_t i = 0; i < 2 * rest.size(); ++i)
        frame.ensemble.push_back(rest[i % rest.size()] + part * moved[(i + 1) % rest.size()]);
    return frame;
}

Frame magnified() {
    Frame frame = displaced(1 / factor);
    frame.magnified = factor;
    return frame;
}

class Magnified : public test::Studio {
protected:
    /// The rows of a picture above the line that says how much is magnified.
    static std::vector<std::uint8_t> picture(const std::vector<Frame>& frames, const Style& style = {}) {
        std::vector<ShownRun> runs;
        for (const Frame& frame : frames) runs.push_back({&frame, "rk4, dt 0.1 s, double"});
        const RenderTarget target(small_size);
        renderer().draw(runs, style, straight, target);
        const Image image{small_size, target.read()};
        const auto rows = run_lines_area(small_size, RunLayout::ghosts, 2 + frames.size(), 1).top;
        return {image.rgba.begin(), image.rgba.begin() + 4L * small_size.width * rows};
    }
};

TEST_F(Magnified, a_frame_is_drawn_as_one_whose_displacements_are_larger) {
    for (const bool springs : {false, true}) {
        Style style;
        style.springs = springs;
        style.colouring = Colouring::role;
        EXPECT_EQ(picture({magnified()}, style), picture({displaced(1)}, style));
        EXPECT_NE(picture({magnified()}, style), picture({displaced(1 / factor)}, style)) << "it is seen";
    }
}

TEST_F(Magnified, ghosts_are_too) {
    Frame other = magnified(), large = displaced(1);
    for (Frame* const frame : {&other, &large}) frame->positions[1] = rest[1];
    EXPECT_EQ(picture({magnified(), other}), picture({displaced(1), large}));
    EXPECT_NE(picture({magnified(), other}), picture({displaced(1), displaced(1)})) << "the ghost is seen";
}

TEST_F(Magnified, the_factor_is_written_in_the_picture) {
    Frame frame = displaced(0);
    const Image usual = draw(frame, straight);
    frame.magnified = 1000;
    EXPECT_GT(test::differing_pixels(draw(frame, straight), usual), 50) << "the text alone: nothing is displaced";
}

TEST_F(Magnified, pictures_of_several_runs_have_one_line_more) {
    Frame frame = displaced(0);
    Style style;
    const auto lines = [&](std::size_t count) {
        const std::vector<ShownRun> runs(count, {&frame, "rk4"});
        return std::pair(lines_of_runs(runs, style), lines_of_tile(runs[0], 0));
    };
    for (const std::size_t runs : {1U, 2U, 4U}) {
        frame.magnified = 1;
        const auto [together, tile] = lines(runs);
        frame.magnified = 20;
        const auto [together_magnified, tile_magnified] = lines(runs);
        EXPECT_EQ(together.size(), runs == 1 ? 0 : runs);
        ASSERT_EQ(together_magnified.size(), together.size() + 1);
        ASSERT_EQ(tile_magnified.size(), tile.size() + 1);
        EXPECT_EQ(together_magnified.back().text, "displacements \u00d7 20");
        EXPECT_EQ(tile_magnified.back().text, "displacements \u00d7 20");
    }
}

TEST(magnified_places, a_particle_is_picked_where_it_is_drawn) {
    const Projection projection(straight, small_size);
    const Frame frame = magnified();
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const PixelPoint place = *projection.pixel(rest[i] + moved[i]);
        EXPECT_EQ(particle_at(frame, DrawnSizes(*frame.shape), projection, place, 1), i);
    }
}

TEST(magnified_places, lead_back_to_positions) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-9, 12), place(-1, 1);
    Frame frame = displaced(1);
    for (int i = 0; i < 1000; ++i) {
        frame.magnified = std::pow(10, exponent(random));
        const Vec3 position{place(random), place(random), place(random)};
        const Vec3 back = frame.position_drawn_at(1, frame.drawn_at(1, position));
        // sums of numbers below 1, and below the factor where it is larger, some roundings each
        const double roundings = 1e-15 * std::max(1.0, 1 / frame.magnified);
        EXPECT_NEAR(length(back - position), 0, roundings) << frame.magnified;
    }
}

TEST(magnified_places, in_a_periodic_box_are_those_of_the_image_that_is_drawn) {
    Frame frame = test::periodic({{0.5, 0.5, 0.5}}, 1, {0, 0, 0});
    frame.magnified = 2;
    const Vec3 rest_there = frame.shape->rest[0];
    EXPECT_EQ(frame.seen(0), frame.seen_at(rest_there + 2.0 * (frame.positions[0] - rest_there)));
}

}  // namespace
}  // namespace steplab::render
