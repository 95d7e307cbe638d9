#include "models/scene/planner.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace steplab {
namespace {

ParticleBlock line_of(std::size_t count, double step, const std::string& group = "") {
    return {.group = group, .arrangement = LineArrangement{count, {step, 0, 0}}};
}

TEST(SceneShape, has_masses_where_they_differ) {
    Scene scene;
    scene.particles = {line_of(2, 1, "a"), line_of(1, 1, "b")};
    EXPECT_TRUE(shape_of(scene).masses.empty());
    scene.particles[1].mass = 3;
    EXPECT_EQ(shape_of(scene).masses, (std::vector<double>{1, 1, 3}));
    scene.particles[1].fixed = true;
    EXPECT_EQ(shape_of(scene).masses, (std::vector<double>{1, 1, 3})) << "files hold that of a fixed particle too";
}

TEST(SceneShape, numbers_groups_as_they_first_appear) {
    Scene scene;
    scene.particles = {line_of(2, 1, "a"), line_of(1, 1), line_of(1, 1, "b"), line_of(1, 1)};
    EXPECT_EQ(shape_of(scene).groups, (std::vector<std::uint16_t>{0, 0, 1, 2, 1}));
    scene.particles.resize(1);
    EXPECT_TRUE(shape_of(scene).groups.empty());
}

TEST(SceneShape, has_a_box_of_unequal_sides) {
    Scene scene;
    scene.particles = {line_of(3, 1)};
    scene.box = {4, 0, 2};
    const Shape shape = shape_of(scene);
    EXPECT_EQ(shape.box, (Vec3{4, 0, 2}));
    EXPECT_EQ(shape.corner, (Vec3{-1, 0, -1})) << "particles are in its middle";
    EXPECT_EQ(shape.expected, (std::vector<Vec3>{{-1, 0, -1}, {3, 0, 1}}));
}

// From the last particle to the first, the nearest image is one step away.
TEST(SceneShape, springs_through_a_side_of_the_box_have_the_length_of_their_nearest_image) {
    Scene scene;
    scene.particles = {line_of(4, 1, "ring")};
    scene.springs.resize(1);
    scene.springs[0].pairs = {{"ring[3]", "ring[0]"}};
    scene.springs[0].k = 1;
    scene.box = {4, 0, 0};
    EXPECT_EQ(shape_of(scene).springs.front().rest_length, 1);
    EXPECT_EQ(shape_of(scene).spacing, 1);
}

}  // namespace
}  // namespace steplab
