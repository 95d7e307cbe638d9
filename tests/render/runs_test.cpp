#include "render/drawn_sizes.hpp"
#include "render/ghosts.hpp"
#include "render/run_labels.hpp"
#include "render/scenes.hpp"
#include "render/split.hpp"
#include "render/studio.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace steplab::render {
namespace {

using test::bare;
using test::difference;
using test::differing_pixels;
using test::Image;
using test::particles_at;
using test::place_of;
using test::small_size;
using test::something;
using test::straight;

class Runs : public test::Studio {
protected:
    static Image picture(const std::vector<Frame>& frames, const Style& style = bare(), PictureSize of = small_size,
                         const std::optional<Tile>& tile = std::nullopt) {
        const std::vector<std::size_t> usual{0, 1, 2, 3};
        return picture(frames, usual, style, of, tile);
    }
    static Image picture(const std::vector<Frame>& frames, const std::vector<std::size_t>& swatches,
                         const Style& style = bare(), PictureSize of = small_size,
                         const std::optional<Tile>& tile = std::nullopt) {
        std::vector<ShownRun> runs;
        for (const Frame& frame : frames) runs.push_back({&frame, "rk4, dt 0.1 s, double", swatches[runs.size()]});
        const RenderTarget target(of);
        renderer().draw(runs, style, straight, target, tile);
        return {of, target.read()};
    }
    /// A ball in the middle, and the same ball in other runs.
    static Image ghosts(const std::vector<Vec3>& places, const Style& style = bare()) {
        std::vector<Frame> frames{particles_at({{0, 0, 0}})};
        for (const Vec3 place : places) {
            frames.push_back(frames.front());
            frames.back().positions = {place};
        }
        return picture(frames, style);
    }
    static double ball() { return DrawnSizes(*particles_at({{0, 0, 0}}).shape).radius(Role::moving); }
};

TEST_F(Runs, one_run_has_the_same_bytes_as_its_frame) {
    const Frame frame = test::string_of({{-1, 0, 0}, {0, 0.2, 0}, {1, 0, 0}});
    Style style;
    const Image alone = draw(frame, straight, style);
    ghosts({{0.5, 0.3, 0}});  // leaves nothing behind
    style.layout = RunLayout::split;
    style.magnify = 7;
    EXPECT_EQ(picture({frame}, style).rgba, alone.rgba);
    EXPECT_EQ(draw(frame, straight, {}).rgba, alone.rgba);
}

TEST_F(Runs, ghosts_are_where_the_other_runs_are) {
    for (const Background background : {Background::dark, Background::light}) {
        Style style = bare();
        style.background = background;
        const Image with = ghosts({{0.7, 0.4, 0}}, style), without = ghosts({}, style);
        const PixelPoint centre = place_of({0.7, 0.4, 0}), mirrored = place_of({-0.7, 0.4, 0});
        EXPECT_GT(difference(with.at(centre), without.at(centre)), something);
        EXPECT_EQ(with.at(mirrored), without.at(mirrored));
        // Translucent: its outline has more of the colour than its middle.
        const Rgb outline = with.at(place_of({0.7 + 0.9 * ball(), 0.4, 0}));
        const Rgb colour = palette(background).runs[1];
        EXPECT_LT(difference(outline, colour), difference(with.at(centre), colour));
    }
}

TEST_F(Runs, magnification_moves_ghosts_away_from_the_leading_run) {
    Style style = bare();
    style.magnify = 100;
    const Image near = ghosts({{0.007, 0.004, 0}}), far = ghosts({{0.007, 0.004, 0}}, style);
    EXPECT_EQ(near.rgba, ghosts({}).rgba) << "it is hidden in its twin";
    const PixelPoint place = place_of({0.7, 0.4, 0});
    EXPECT_GT(difference(far.at(place), near.at(place)), something);
}

TEST_F(Runs, magnification_is_written_in_the_picture) {
    Style style = bare();
    const Frame frame = particles_at({{0, 0, 0}});
    style.magnify = 1000;
    EXPECT_EQ(picture({frame}, style).rgba, picture({frame}).rgba) << "without other runs";
    const Image usual = picture({frame, frame}), magnified = picture({frame, frame}, style);
    EXPECT_GT(differing_pixels(usual, magnified), 50);
    const int text = run_lines_area(small_size, RunLayout::ghosts, 1, 1).top;
    for (int y = 0; y < text; ++y) {
        for (int x = 0; x < small_size.width; ++x) ASSERT_EQ(usual.at(x, y), magnified.at(x, y)) << "above the text";
    }
}

TEST_F(Runs, ghosts_are_hidden_within_their_twins) {
    const Image alone = ghosts({});
    EXPECT_EQ(ghosts({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).rgba, alone.rgba);
    EXPECT_EQ(ghosts({{0.1 * ball(), 0, 0}}).rgba, alone.rgba);
    EXPECT_GT(differing_pixels(ghosts({{1.5 * ball(), 0, 0}}), alone), 10);
}

TEST_F(Runs, ghosts_are_told_apart_by_their_outlines) {
    const Vec3 place{0.7, 0.4, 0}, in_the_twin{0, 0, 0};
    const Image circle = ghosts({place}), square = ghosts({in_the_twin, place}),
                triangle = ghosts({in_the_twin, in_the_twin, place}), none = ghosts({});
    const auto changed = [&](const Image& image, double x, double y) {
        const PixelPoint at = place_of({place.x + x * ball(), place.y + y * ball(), 0});
        return difference(image.at(at), none.at(at)) > something;
    };
    EXPECT_TRUE(changed(circle, 0.9, 0));
    EXPECT_FALSE(changed(square, 0.9, 0));
    EXPECT_FALSE(changed(triangle, 0.9, 0));
    EXPECT_TRUE(changed(square, 0.6, -0.6));
    EXPECT_FALSE(changed(triangle, 0.55, 0.3));
    EXPECT_TRUE(changed(triangle, 0.6, -0.38));
}

// The leading run, too, has the colour of its line in plots, and the first run beside another an outline of its own.
TEST_F(Runs, have_their_own_colours_and_outlines_whichever_leads) {
    const Frame leading = particles_at({{0, 0, 0}});
    Frame other = leading;
    other.positions = {{0.7, 0.4, 0}};
    const Image usual = picture({leading, other}, {0, 1}), exchanged = picture({leading, other}, {1, 0});
    const PixelPoint ball_middle = place_of({0, 0, 0}), edge = place_of({0.7 + 0.9 * ball(), 0.4, 0}),
                     between_corners = place_of({0.7 + 0.64 * ball(), 0.4 + 0.64 * ball(), 0});
    EXPECT_GT(exchanged.at(ball_middle).red, exchanged.at(ball_middle).blue + something) << "orange";
    EXPECT_GT(usual.at(ball_middle).blue, usual.at(ball_middle).red + something) << "blue";
    EXPECT_GT(exchanged.at(edge).blue, exchanged.at(edge).red + something) << "blue";
    const Image without = ghosts({});
    EXPECT_GT(difference(usual.at(between_corners), without.at(between_corners)), something) << "a circle";
    EXPECT_EQ(exchanged.at(between_corners), without.at(between_corners)) << "a diamond";
    EXPECT_EQ(picture({leading}, {1}).rgba, picture({leading}, {0}).rgba) << "alone";
}

TEST_F(Runs, a_line_joins_a_particle_with_its_ghost) {
    const Image with = ghosts({{1, 0, 0}}), without = ghosts({});
    int changed = 0, all = 0;
    const int row = static_cast<int>(place_of({0, 0, 0}).y);
    for (int x = static_cast<int>(place_of({1.5 * ball(), 0, 0}).x);
         x < static_cast<int>(place_of({1 - 1.5 * ball(), 0, 0}).x); ++x) {
        ++all;
        // Lines of a pixel may fall between two rows.
        changed += difference(with.at(x, row), without.at(x, row)) > 5 ||
                   difference(with.at(x, row - 1), without.at(x, row - 1)) > 5;
    }
    EXPECT_GT(changed, all / 4) << "dashes";
    EXPECT_LT(changed, all) << "and gaps";
}

TEST_F(Runs, ghosts_that_cannot_be_drawn_are_left_out) {
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(ghosts({{no_number, 0, 0}}).rgba, ghosts({}).rgba);
    EXPECT_EQ(ghosts({{0, 0, 10}, {1e200, 0, 0}}).rgba, ghosts({}).rgba) << "behind the eye";
}

TEST_F(Runs, springs_of_ghosts_have_their_colour) {
    const Frame leading = test::string_of({{-1, 0, 0}, {1, 0, 0}});
    Frame other = leading;
    other.positions = {{-1, 0.6, 0}, {1, 0.6, 0}};
    Style style = bare(), with_springs = bare();
    with_springs.springs = true;
    const PixelPoint middle = place_of({0, 0.6, 0});
    const Rgb spring = picture({leading, other}, with_springs).at(middle);
    EXPECT_GT(difference(spring, picture({leading, other}, style).at(middle)), something);
    EXPECT_GT(spring.red, spring.blue + something) << "orange";
}

TEST(GhostPlaces, of_periodic_scenes_are_by_the_nearest_image) {
    const Frame leading = test::periodic({{0.9, 0, 0}}, 2, {-1, -1, -1});
    Frame other = leading;
    other.positions = {{-0.9, 0.1, 0}};  // 0.2 away, through the side
    const auto places = ghost_places(leading, other, 3);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].x, 1.5, 1e-12);  // rounding of three sums
    EXPECT_NEAR(places[0].y, 0.3, 1e-12);
}

/// The part of an image.
Image cut(const Image& image, const PictureArea& area) {
    Image part{area.size, {}};
    for (int y = area.top; y < area.top + area.size.height; ++y) {
        const auto begin = image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.size.width + area.left);
        part.rgba.insert(part.rgba.end(), begin, begin + 4 * static_cast<std::ptrdiff_t>(area.size.width));
    }
    return part;
}

std::vector<Frame> four_runs() {
    std::vector<Frame> frames;
    for (const double y : {0.0, 0.3, 0.6, -0.4}) {
        frames.push_back(test::string_of({{-0.8, y, 0}, {0, -y, 0}, {0.8, y, 0}}));
        frames.back().shape = frames.front().shape;
    }
    return frames;
}

// Parts that are too small for texts: they are drawn in the middle of the picture, else.
TEST_F(Runs, in_split_layout_each_part_shows_what_a_picture_of_the_run_shows) {
    Style style;
    style.layout = RunLayout::split;
    const std::vector<Frame> frames = four_runs();
    const PictureSize tiny{190, 96};
    const Image whole = picture(frames, style, tiny);
    const auto areas = split_areas(tiny, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        const Image alone = draw(frames[i], straight, {}, areas[i].size);
        // The line between the parts is one pixel; outlines may round to another of the 4 samples of a pixel.
        EXPECT_LE(differing_pixels(cut(whole, areas[i]), alone, 64), areas[i].size.width + areas[i].size.height) << i;
        EXPECT_GT(differing_pixels(cut(whole, areas[i]), draw(frames[(i + 1) % 4], straight, {}, areas[i].size), 64),
                  areas[i].size.width + areas[i].size.height);
    }
}

TEST_F(Runs, in_split_layout_parts_name_their_runs) {
    Style style = bare();
    style.layout = RunLayout::split;
    const PictureSize large{640, 360};
    const std::vector<Frame> frames(2, particles_at({{0, 0, 0}}));
    const Image both = picture(frames, style, large);
    const auto areas = split_areas(large, 2);
    const Image first = cut(both, areas[0]), second = cut(both, areas[1]);
    EXPECT_GT(differing_pixels(first, draw(frames[0], straight, style, areas[0].size)), 200) << "a text";
    EXPECT_GT(differing_pixels(first, second, something), 20) << "another number and mark";
}

TEST_F(Runs, a_split_picture_drawn_in_tiles_is_the_whole_one) {
    Style style;
    style.layout = RunLayout::split;
    const std::vector<Frame> frames = four_runs();
    const Image whole = picture(frames, style);
    const PictureArea part{100, 50, {90, 80}};  // of all four
    const Image tile = picture(frames, style, part.size, Tile{small_size, part.left, part.top});
    EXPECT_LE(differing_pixels(cut(whole, part), tile, 64), 90 * 80 / 200);  // outlines round differently
}

TEST_F(Runs, in_split_layout_colours_mean_the_same_everywhere) {
    std::vector<Frame> frames(2, particles_at({{0, 0, 0}}));
    frames[0].velocities = {{1, 0, 0}};
    frames[1].velocities = {{10, 0, 0}};
    Style style = bare();
    style.layout = RunLayout::split;
    style.colouring = Colouring::speed;
    const Image both = picture(frames, style);
    const Rgb slow = both.at(80, 90), fast = both.at(240, 90);
    EXPECT_GT(fast.red, slow.red + something) << "yellow and dark blue";
}

TEST(SplitAreas, are_beside_each_other_or_in_two_rows) {
    EXPECT_EQ(split_areas({300, 200}, 1), (std::vector<PictureArea>{{0, 0, {300, 200}}}));
    EXPECT_EQ(split_areas({301, 200}, 2), (std::vector<PictureArea>{{0, 0, {150, 200}}, {150, 0, {151, 200}}}));
    EXPECT_EQ(split_areas({200, 301}, 2), (std::vector<PictureArea>{{0, 0, {200, 150}}, {0, 150, {200, 151}}}));
    const std::vector<PictureArea> four{
        {0, 0, {150, 100}}, {150, 0, {150, 100}}, {0, 100, {150, 100}}, {150, 100, {150, 100}}};
    EXPECT_EQ(split_areas({300, 200}, 4), four);
    EXPECT_EQ(split_areas({300, 200}, 3), (std::vector<PictureArea>{four[0], four[1], four[2]}));
    EXPECT_EQ(areas_of({300, 200}, RunLayout::ghosts, 4).size(), 1u);
}

TEST(SplitAreas, are_never_empty) {
    for (const PictureSize tiny : {PictureSize{1, 1}, {1, 2}, {2, 1}, {3, 3}}) {
        for (std::size_t runs = 1; runs <= most_shown_runs; ++runs) {
            const auto areas = split_areas(tiny, runs);
            EXPECT_EQ(areas.size(), runs);
            for (const PictureArea& area : areas) EXPECT_TRUE(area.size.width > 0 && area.size.height > 0);
        }
    }
}

/// Relative luminance (WCAG 2).
double luminance(Rgb colour) {
    const auto linear = [](std::uint8_t value) {
        const double part = value / 255.0;
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

TEST(RunColours, stand_out_from_the_background) {
    constexpr double of_shapes = 3;  // WCAG 2, level AA
    for (const Background background : {Background::dark, Background::light}) {
        const Palette& colours = palette(background);
        for (const Rgb run : colours.runs) {
            for (const Rgb ground : {colours.top, colours.bottom}) {
                const double a = luminance(run), b = luminance(ground);
                EXPECT_GE((std::max(a, b) + 0.05) / (std::min(a, b) + 0.05), of_shapes);
            }
        }
    }
}

}  // namespace
}  // namespace steplab::render
