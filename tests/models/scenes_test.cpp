#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::test {
namespace {

Shape shape_of(std::string_view id, Settings settings = {}) {
    return model(id).shape(run_of(id, "rk4", Precision::double_, 0.1, settings).scene);
}

Plan scene_of(std::string_view id, Settings settings = {}) {
    return model(id).plan(run_of(id, "rk4", Precision::double_, 0.1, settings).scene);
}

Vec3 start_position(const Plan& scene, std::size_t i) { return scene.reference.at(i) + scene.start[i].displacement; }

TEST(Scenes, have_a_shape_that_agrees_with_their_start) {
    for (const Model& model : models()) {
        const ParameterValues defaults(model.info.parameters);
        const Shape shape = model.shape(defaults);
        const Plan scene = model.plan(defaults);
        const std::size_t n = static_cast<std::size_t>(model.particles(defaults));
        ASSERT_EQ(shape.rest.size(), n) << model.info.id;
        ASSERT_EQ(shape.roles.size(), n) << model.info.id;
        ASSERT_EQ(scene.reference.count, n) << model.info.id;
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_EQ(shape.rest[i], start_position(scene, i)) << model.info.id << " " << i;
        EXPECT_GT(shape.spacing, 0) << model.info.id;
    }
}

TEST(Scenes, kick_one_particle_only_and_mark_it) {
    const auto is_cold = [](const Model& it) { return it.info.id != "crystal"; };  // there all move
    for (const Model* const model : models_where(is_cold)) {
        const ParameterValues defaults(model->info.parameters);
        const Shape shape = model->shape(defaults);
        const Plan scene = model->plan(defaults);
        for (std::size_t i = 0; i < shape.roles.size(); ++i) {
            const bool moves = !(scene.start[i].velocity == Vec3{});
            EXPECT_EQ(moves, shape.roles[i] == Role::kicked || shape.roles[i] == Role::bullet)
                << model->info.id << " " << i;
        }
    }
}

TEST(Scenes, are_laid_out_as_documented) {
    EXPECT_EQ(shape_of("mesh").rest[23], (Vec3{6, 0, -4}));  // row 2, column 3
    EXPECT_EQ(shape_of("mesh").roles[55], Role::kicked);     // row = column = dim / 2
    EXPECT_EQ(shape_of("mesh", {{"kick", 1}}).roles[11], Role::kicked);
    EXPECT_EQ(shape_of("mesh", {{"dim", 7}}).roles[3 * 7 + 3], Role::kicked);
    EXPECT_EQ(shape_of("morse").rest[1], (Vec3{0.5, 0, 0}));
    EXPECT_EQ(shape_of("morse").rest[3], (Vec3{0, 0.5, 0}));
    EXPECT_EQ(shape_of("morse").rest[9], (Vec3{0, 0, 0.5}));
    EXPECT_EQ(shape_of("morse").rest[27], (Vec3{-10, 0, 0}));
    EXPECT_EQ(shape_of("morse", {{"edge", 1}}).rest.size(), 2u);
    EXPECT_EQ(shape_of("chain").rest[9], (Vec3{18, 0, 0}));
    EXPECT_EQ(scene_of("chain").start[9].velocity, (Vec3{2, 0, 0}));
    EXPECT_EQ(shape_of("free").rest[9], (Vec3{9, 0, 0}));
}

TEST(Scenes, fix_the_border_of_a_mesh_and_the_first_particle_of_a_line) {
    const Shape mesh = shape_of("mesh", {{"dim", 4}});
    for (std::size_t i = 0; i < 16; ++i) {
        const bool border = i / 4 == 0 || i / 4 == 3 || i % 4 == 0 || i % 4 == 3;
        EXPECT_EQ(mesh.roles[i] == Role::fixed, border) << i;
    }
    EXPECT_EQ(shape_of("chain").roles[0], Role::fixed);
    EXPECT_EQ(shape_of("chain", {{"fixed", 0}}).roles[0], Role::moving);
    EXPECT_EQ(shape_of("rope").roles[0], Role::fixed);
    EXPECT_EQ(shape_of("oscillator").roles[0], Role::fixed);
}

TEST(Scenes, list_every_spring_at_its_rest_length) {
    for (const char* id : {"chain", "mesh", "rope", "oscillator"}) {
        const Shape shape = shape_of(id);
        for (const Spring& spring : shape.springs) {
            // one rounding of the square root of 2
            EXPECT_NEAR(length(shape.rest[spring.second] - shape.rest[spring.first]), spring.rest_length, 1e-14) << id;
        }
    }
    EXPECT_EQ(shape_of("mesh").springs.size(), 2u * 10 * 9 + 2u * 9 * 9);
    EXPECT_EQ(shape_of("chain").springs.size(), 9u);
    EXPECT_TRUE(shape_of("morse").springs.empty());
}

}  // namespace
}  // namespace steplab::test
