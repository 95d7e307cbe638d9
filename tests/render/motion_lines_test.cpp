#include "render/motion_lines.hpp"

#include "render/following.hpp"
#include "render/known_shape.hpp"
#include "render/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace steplab::render {
namespace {

const PictureSize size_of_lines{320, 200};

/// What the lines are made of.
struct Scene {
    explicit Scene(Frame given) : frame(std::move(given)), known(frame.shape) {}
    Shot shot() const { return {frame, known, style, scale, projection, tile, size_of_lines}; }

    Frame frame;
    KnownShape known;
    Style style;
    std::optional<ColourScale> scale;
    Projection projection{Camera{{0, 0, 0}, 10, 0, 0}, size_of_lines};
    Tile tile{size_of_lines};
};

TEST(MotionArrows, are_as_long_as_velocities_to_one_scale) {
    Scene scene(test::particles_at({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
    scene.frame.velocities = {{0, 2, 0}, {0, 1, 0}, {0, 0, 0}};
    EXPECT_TRUE(motion_arrows(scene.shot()).empty()) << "nobody asked for them";
    scene.style.velocities = true;
    const std::vector<Rod> lines = motion_arrows(scene.shot());
    ASSERT_EQ(lines.size(), 6u) << "three lines each, none for a particle at rest";
    const auto reach = [&](std::size_t i) { return glm::length(lines[i].end - lines[i].start); };
    EXPECT_FLOAT_EQ(reach(0), 2 * reach(3));
}

TEST(MotionArrows, of_a_scene_at_rest_or_beyond_numbers_are_none) {
    Scene scene(test::particles_at({{0, 0, 0}}));
    scene.style.velocities = scene.style.forces = true;
    EXPECT_TRUE(motion_arrows(scene.shot()).empty());
    scene.frame.velocities = {{NAN, 0, 0}};
    EXPECT_TRUE(motion_arrows(scene.shot()).empty());
}

TEST(MotionArrows, of_forces_have_a_scale_and_a_colour_of_their_own) {
    Scene scene(test::particles_at({{0, 0, 0}, {1, 0, 0}}));
    scene.frame.velocities = {{0, 3, 0}, {0, 0, 0}};
    scene.frame.forces = {{0, 100, 0}, {0, -50, 0}};
    scene.style.forces = true;
    ASSERT_EQ(motion_arrows(scene.shot()).size(), 6u) << "those of two forces alone";
    scene.style.velocities = true;
    const std::vector<Rod> lines = motion_arrows(scene.shot());
    ASSERT_EQ(lines.size(), 9u);
    EXPECT_NE(lines[0].colour.green, lines[3].colour.green);
    const auto reach = [&](std::size_t i) { return glm::length(lines[i].end - lines[i].start); };
    EXPECT_FLOAT_EQ(reach(3), 2 * reach(6));
}

TEST(TrailLines, join_the_places_and_fade_with_age) {
    Scene scene(test::particles_at({{0, 0, 0}}));
    scene.style.trails =
        std::make_shared<const Trails>(Trails{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{5, 0, 0}, {5, 1, 0}}});
    const std::vector<Rod> lines = trail_lines(scene.shot());
    ASSERT_EQ(lines.size(), 3u) << "of one particle two, of another one";
    EXPECT_EQ(lines[0].end, lines[1].start);
    EXPECT_LT(lines[0].colour.alpha, lines[1].colour.alpha);
}

TEST(TrailLines, do_not_cross_the_periodic_box) {
    Scene scene(test::periodic({{0, 0, 0}}, 4, {-2, -2, -2}));
    scene.style.trails = std::make_shared<const Trails>(Trails{{{1, 0, 0}, {1.9, 0, 0}, {2.1, 0, 0}}});
    EXPECT_EQ(trail_lines(scene.shot()).size(), 1u);
}

TEST(Sizes, go_by_mass_within_a_range) {
    Frame frame = test::particles_at({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},
                                     {Role::moving, Role::moving, Role::moving, Role::fixed});
    auto shape = std::make_shared<Shape>(*frame.shape);
    shape->masses = {1, 0.343, 1e-9, 1000};
    const KnownShape known(shape);
    EXPECT_FLOAT_EQ(known.part(0), 1);
    EXPECT_FLOAT_EQ(known.part(1), 0.7F) << "the cube root of the mass";
    EXPECT_GT(known.part(2), 0.3F) << "still seen";
    EXPECT_EQ(known.part(3), 1) << "fixed particles keep their size";
    EXPECT_EQ(known.largest_radius(Role::fixed), known.sizes.radius(Role::fixed));
    EXPECT_GT(known.largest_radius(Role::moving), known.sizes.radius(Role::moving));
}

TEST(FollowedPoint, is_the_particle_or_the_centre_of_mass) {
    Frame frame = test::particles_at({{0, 0, 0}, {4, 0, 0}, {0, 9, 0}}, {Role::moving, Role::moving, Role::fixed});
    EXPECT_FALSE(followed_point(frame, Following::nothing, 1));
    EXPECT_EQ(followed_point(frame, Following::particle, 1), (Vec3{4, 0, 0}));
    EXPECT_FALSE(followed_point(frame, Following::particle, std::nullopt));
    EXPECT_EQ(followed_point(frame, Following::centre, std::nullopt), (Vec3{2, 0, 0}));
    auto shape = std::make_shared<Shape>(*frame.shape);
    shape->masses = {1, 3, 50};
    frame.shape = shape;
    EXPECT_EQ(followed_point(frame, Following::centre, std::nullopt), (Vec3{3, 0, 0}));
}

}  // namespace
}  // namespace steplab::render
