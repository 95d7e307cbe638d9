#include "render/picking.hpp"

#include "render/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace steplab::render {
namespace {

const PictureSize window_of_picks{800, 600};
const Projection projection({{0, 0, 0}, 10, 0, 0}, window_of_picks);

/// As picking.hpp says, with a tolerance of 6 pixels unless another is given.
std::optional<std::size_t> particle_at(const Frame& frame, const Projection& from, PixelPoint pixel,
                                       double tolerance = 6) {
    return render::particle_at(frame, DrawnSizes(*frame.shape), from, pixel, tolerance);
}

TEST(Picking, finds_the_particle_under_the_pixel) {
    const Frame frame = test::particles_at({{-1, 0, 0}, {1, 0, 0}});
    EXPECT_EQ(particle_at(frame, projection, *projection.pixel({1, 0.1, 0})), 1u);
    EXPECT_EQ(particle_at(frame, projection, *projection.pixel({-1, 0, 0})), 0u);
}

TEST(Picking, takes_the_nearest_to_the_eye) {
    const Frame frame = test::particles_at({{0, 0, 0}, {0, 0, 2}, {0, 0, -2}});
    EXPECT_EQ(particle_at(frame, projection, {400, 300}), 1u);
}

TEST(Picking, finds_nothing_where_nothing_is) {
    const Frame frame = test::particles_at({{-1, 0, 0}, {1, 0, 0}});
    EXPECT_FALSE(particle_at(frame, projection, {400, 300}));
}

TEST(Picking, a_far_particle_is_hit_within_reach) {
    const Frame frame = test::particles_at({{0, 0, -1000}});
    EXPECT_EQ(particle_at(frame, projection, {405, 300}, 6), 0u);
    EXPECT_FALSE(particle_at(frame, projection, {405, 300}, 4));
}

TEST(Picking, prefers_the_particle_under_the_pixel_to_a_nearer_one_beside_it) {
    const Frame frame = test::particles_at({{0, 0, 0}, {0.27, 0, 2}});
    const PixelPoint pixel = *projection.pixel({0.02, 0, 0});
    EXPECT_EQ(particle_at(frame, projection, pixel, 30), 0u);
    const Frame alone = test::particles_at({{-3, 0, 0}, {0.27, 0, 2}});
    EXPECT_EQ(particle_at(alone, projection, pixel, 30), 1u) << "within the tolerance";
}

TEST(Picking, takes_the_one_whose_edge_is_nearest) {
    const Frame frame = test::particles_at({{-0.5, 0, 0}, {0.6, 0, 0}});
    EXPECT_EQ(particle_at(frame, projection, {400, 300}, 100), 0u);
    EXPECT_FALSE(particle_at(frame, projection, {400, 300}, 4));
}

// Most are ruled out before their discs are computed: none that would be found.
TEST(Picking, finds_what_lies_within_reach_of_any_pixel_in_a_crowd) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-6, 6), across(-40, 840), down(-40, 640);
    std::vector<Vec3> places(300);
    for (Vec3& each : places) each = {place(random), place(random), place(random)};
    const Frame frame = test::particles_at(places);
    const DrawnSizes sizes(*frame.shape);
    const Projection oblique({{1, 0.5, -0.3}, 5, 35, 20}, window_of_picks);  // some are behind the eye
    for (int i = 0; i < 2000; ++i) {
        const PixelPoint pixel{across(random), down(random)};
        bool within = false;
        for (const Vec3& each : places) {
            const auto centre = oblique.pixel(each);
            if (!centre) continue;
            const double radius = sizes.radius(Role::moving) * oblique.pixels_per_unit(oblique.depth(each));
            within = within || std::hypot(centre->x - pixel.x, centre->y - pixel.y) <= radius + 6;
        }
        EXPECT_EQ(particle_at(frame, oblique, pixel).has_value(), within) << pixel.x << ", " << pixel.y;
    }
}

TEST(InView, is_a_particle_or_its_edge_in_front_of_the_camera) {
    const auto seen = [](Vec3 place) {
        const Frame frame = test::particles_at({place});
        return any_in_view(frame, DrawnSizes(*frame.shape), projection);
    };
    EXPECT_TRUE(seen({0, 0, 0}));
    EXPECT_TRUE(seen({3.3, 0, 0}));
    EXPECT_TRUE(seen({3.4, 0, 0})) << "its edge";
    EXPECT_FALSE(seen({3.9, 0, 0}));
    EXPECT_FALSE(seen({0, 3, 0}));
    EXPECT_FALSE(seen({0, 0, 11})) << "behind the camera";
    EXPECT_FALSE(seen({std::numeric_limits<double>::quiet_NaN(), 0, 0}));
    EXPECT_FALSE(seen({0, 0, -1e200}));
}

TEST(Picking, finds_a_particle_of_a_periodic_scene_where_it_is_seen) {
    const Frame frame = test::periodic({{1 + 3 * 4, -8, 4}}, 4, {-2, -2, -2});
    EXPECT_EQ(particle_at(frame, projection, *projection.pixel({1, 0, 0})), 0u);
    EXPECT_FALSE(particle_at(frame, projection, *projection.pixel({-1, 0, 0}))) << "half a period beside it";
}

TEST(Picking, passes_over_what_is_behind_the_eye_or_not_finite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(particle_at(test::particles_at({{0, 0, 20}, {nan, nan, nan}}), projection, {400, 300}));
}

}  // namespace
}  // namespace steplab::render
