#include "render/drawn_sizes.hpp"
#include "render/scenes.hpp"
#include "render/studio.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace steplab::render {
namespace {

using test::bare;
using test::difference;
using test::differing_pixels;
using test::Image;
using test::place_of;
using test::small_size;
using test::something;
using test::straight;

/// A ball in the middle, and an ensemble in which it is elsewhere.
class LiveEnsembles : public test::Studio {
protected:
    static Image picture(std::vector<Vec3> ensemble, const Style& style = bare()) {
        Frame frame = test::particles_at({{0, 0, 0}});
        frame.ensemble = std::move(ensemble);
        return draw(frame, straight, style);
    }
    /// Pixels that an ensemble changes.
    static int changed(const std::vector<Vec3>& ensemble) { return differing_pixels(picture(ensemble), picture({})); }
};

TEST_F(LiveEnsembles, are_seen_where_they_are_and_nowhere_else) {
    for (const Background background : {Background::dark, Background::light}) {
        Style style = bare();
        style.background = background;
        const Image with = picture({{0.5, 0.3, 0}}, style), without = picture({}, style);
        const PixelPoint place = place_of({0.5, 0.3, 0}), mirrored = place_of({-0.5, 0.3, 0});
        EXPECT_GT(difference(with.at(place), without.at(place)), something);
        EXPECT_EQ(with.at(mirrored), without.at(mirrored));
        // A dot is smaller than the ball.
        const Frame ball = test::particles_at({{0, 0, 0}});
        const double radius =
            DrawnSizes(*ball.shape).radius(Role::moving) * Projection(straight, small_size).pixels_per_unit(4);
        EXPECT_LT(differing_pixels(with, without), 3.14 * radius * radius / 2);
    }
}

TEST_F(LiveEnsembles, are_hidden_within_the_particles_and_behind_them) {
    const double radius = DrawnSizes(*test::particles_at({{0, 0, 0}}).shape).radius(Role::moving);
    EXPECT_EQ(changed({{0, 0, 0}}), 0);
    EXPECT_EQ(changed({{0.3 * radius, 0.3 * radius, 0.3 * radius}}), 0);
    EXPECT_EQ(changed({{0, 0, -2 * radius}}), 0);
    EXPECT_GT(changed({{0, 0, 2 * radius}}), 0);
    EXPECT_GT(changed({{1.5 * radius, 0, 0}}), 0);
}

TEST_F(LiveEnsembles, outside_the_picture_change_nothing_of_it) {
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(changed({{100, 0, 0}}), 0);
    EXPECT_EQ(changed({{0, 0, 10}}), 0) << "behind the eye";
    EXPECT_EQ(changed({{no_number, no_number, no_number}}), 0);
    EXPECT_GT(changed({{0, 0, -50}, {15, 8, -50}}), 0) << "far behind the particles";
}

TEST_F(LiveEnsembles, of_a_periodic_scene_are_seen_in_its_box) {
    const auto seen = [](Vec3 place) {
        Frame frame = test::periodic({{0, 0, 0}}, 2, {-1, -1, -1});
        frame.ensemble = {place};
        return draw(frame, straight, bare());
    };
    EXPECT_EQ(seen({0.5 + 6, 0.25 - 4, 2}).rgba, seen({0.5, 0.25, 0}).rgba);
    EXPECT_NE(seen({0.5 - 1, 0.25, 0}).rgba, seen({0.5, 0.25, 0}).rgba) << "by half a period";
}

TEST_F(LiveEnsembles, are_cut_where_the_picture_ends) {
    // The middle of the dot is half a pixel beyond the edge: the part of it that reaches into the picture is there.
    const Projection projection(straight, small_size);
    const double edge = (0.5 * small_size.width + 0.5) / projection.pixels_per_unit(4);
    EXPECT_GT(changed({{edge, 0, 0}}), 0);
    EXPECT_EQ(changed({{1.2 * edge, 0, 0}}), 0);
}

TEST_F(LiveEnsembles, have_the_colours_of_the_particles) {
    Frame frame = test::particles_at({{-1, 0, 0}, {1, 0, 0}}, {Role::moving, Role::bullet});
    frame.ensemble = {{-1, 0.6, 0}, {1, 0.6, 0}};
    const Image image = draw(frame, straight, bare());
    const Rgb blue = image.at(place_of(frame.ensemble[0])), red = image.at(place_of(frame.ensemble[1]));
    EXPECT_GT(blue.blue, blue.red + something);
    EXPECT_GT(red.red, red.blue + something);
}

TEST_F(LiveEnsembles, are_denser_where_there_are_more_of_them) {
    const std::vector<Vec3> one(16, {9, 9, 9});
    std::vector<Vec3> two = one, many(16, {0.5, 0.3, 0});
    two[0] = {0.5, 0.3, 0};
    const PixelPoint place = place_of({0.5, 0.3, 0});
    const Rgb background = picture(one).at(place);
    EXPECT_GT(difference(picture(many).at(place), background),
              difference(picture(two).at(place), background) + something);
}

}  // namespace
}  // namespace steplab::render
