#include "render/framing.hpp"

#include "core/error.hpp"
#include "render/drawn_sizes.hpp"
#include "render/picking.hpp"
#include "render/scenes.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "support/extreme_doubles.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace steplab::render {
namespace {

using testing::HasSubstr;

constexpr PictureSize sizes[] = {{1280, 720}, {400, 300}, {3840, 2160}, {300, 900}};

/// Largest part of the half picture, to the side or up and down, that the balls of the frame reach; 1 is the edge.
double filled(const Frame& frame, const Camera& camera, PictureSize size) {
    const Projection projection(camera, size);
    const DrawnSizes drawn(*frame.shape);
    double largest = 0;
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const auto pixel = projection.pixel(frame.positions[i]);
        if (!pixel) return 2;
        const double scale = projection.pixels_per_unit(projection.depth(frame.positions[i]));
        const double radius = scale * drawn.radius(frame.shape->roles[i]);
        largest = std::max({largest, (std::abs(pixel->x - size.width / 2.0) + radius) / (size.width / 2.0),
                            (std::abs(pixel->y - size.height / 2.0) + radius) / (size.height / 2.0)});
    }
    return largest;
}

class EveryModel : public testing::TestWithParam<std::string> {};

TEST_P(EveryModel, opens_with_every_particle_in_the_picture) {
    Simulation simulation(describe(GetParam()));
    for (const PictureSize size : sizes) {
        const double part = filled(simulation.frame(), default_camera(simulation.frame(), size), size);
        EXPECT_LT(part, 1) << size.width << "x" << size.height;
        // Well placed: the scene is not lost in the middle. The oscillator's two particles start in one place.
        if (GetParam() != "oscillator") {
            EXPECT_GT(part, 0.4) << size.width << "x" << size.height;
        }
    }
}

TEST_P(EveryModel, is_whole_again_after_framing_a_later_moment) {
    Simulation simulation(describe(GetParam()));
    simulation.advance(200);
    const Frame frame = simulation.frame();
    for (const PictureSize size : sizes) EXPECT_LT(filled(frame, framed(frame, 70, 10, size), size), 1);
}

INSTANTIATE_TEST_SUITE_P(Framing, EveryModel, testing::ValuesIn(test::model_ids()),
                         [](const auto& test) { return test.param; });

TEST(Framing, mesh_stays_in_the_picture_while_it_swings) {
    Simulation simulation(describe("mesh"));
    const Camera camera = default_camera(simulation.frame(), sizes[0]);
    for (int i = 0; i < 20; ++i) {
        simulation.advance(5);
        EXPECT_LT(filled(simulation.frame(), camera, sizes[0]), 1);
    }
}

TEST(Framing, morse_opens_on_its_cluster_with_the_bullet_in_view) {
    const Frame frame = Simulation(describe("morse")).frame();
    const DrawnSizes drawn(*frame.shape);
    const std::size_t bullet = frame.positions.size() - 1;
    for (const PictureSize size : sizes) {
        const Projection projection(default_camera(frame, size), size);
        const auto pixel = projection.pixel(frame.positions[bullet]);
        ASSERT_TRUE(pixel);
        const double scale = projection.pixels_per_unit(projection.depth(frame.positions[bullet]));
        EXPECT_GT(scale * drawn.radius(Role::bullet), 2) << "large enough to be seen";
        EXPECT_EQ(particle_at(frame, drawn, projection, *pixel, 0), bullet) << "no other particle hides it";
    }
    const Projection projection(default_camera(frame, sizes[0]), sizes[0]);
    double top = INFINITY, bottom = -INFINITY;
    for (std::size_t i = 0; i < bullet; ++i) {
        const double y = projection.pixel(frame.positions[i])->y;
        top = std::min(top, y);
        bottom = std::max(bottom, y);
    }
    EXPECT_GT(bottom - top, 0.4 * sizes[0].height) << "the cluster fills the picture";
}

TEST(ZoomLimits, are_those_of_the_scene) {
    for (const double length : {1e-30, 1.0, 1e30}) {
        const Frame frame = test::particles_at({{0, 0, 0}, {length, 0, 0}}, {}, length);
        const ZoomLimits limits = zoom_limits(frame);
        const Camera whole = default_camera(frame, sizes[0]);
        EXPECT_LT(limits.nearest, 0.1 * length);
        EXPECT_GT(limits.farthest, 10 * whole.distance);
        // At the far end the scene is still some pixels across, at the near end a ball fills the picture.
        Camera far = whole;
        far.distance = limits.farthest;
        EXPECT_GT(Projection(far, sizes[0]).pixels_per_unit(far.distance) * length, 2);
        Camera near = whole;
        near.distance = limits.nearest;
        const double radius = DrawnSizes(*frame.shape).radius(Role::moving);
        EXPECT_GT(Projection(near, sizes[0]).pixels_per_unit(near.distance) * radius, sizes[0].width);
    }
}

TEST(ZoomLimits, are_limits_for_any_positions) {
    for (const auto& [a, b] : extreme_pairs(500)) {
        const Frame frame = test::particles_at({{a, 0, b}, {b, a, 1}});
        const ZoomLimits limits = zoom_limits(frame);
        ASSERT_GE(limits.nearest, least_distance) << a << " " << b;
        ASSERT_LE(limits.nearest, limits.farthest) << a << " " << b;
        ASSERT_LE(limits.farthest, largest_length) << a << " " << b;
        const Camera camera = default_camera(frame, sizes[0]);
        ASSERT_TRUE(std::isfinite(length(camera.focus)) && camera.distance <= largest_length) << a << " " << b;
        ASSERT_EQ(camera_of(view_text(camera), frame, sizes[0]), camera) << "a view that is copied can be opened";
    }
}

TEST(Framing, one_particle_does_not_fill_the_picture) {
    const Frame frame = test::particles_at({{5, 5, 5}});
    const double part = filled(frame, default_camera(frame, sizes[0]), sizes[0]);
    EXPECT_LT(part, 0.5);
    EXPECT_GT(part, 0.05);
}

TEST(Framing, ignores_positions_that_are_not_finite) {
    Frame frame = test::particles_at({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    const Camera expected = default_camera(frame, sizes[0]);
    frame.positions[1] = {std::numeric_limits<double>::quiet_NaN(), 1e300, 0};
    EXPECT_EQ(default_camera(frame, sizes[0]), expected);
}

TEST(ViewText, reads_back_exactly) {
    const Frame frame = test::particles_at({{0, 0, 0}});
    const Camera camera{{1e-7, -2.0 / 3, 1e20}, 0.1 + 0.2, -179.99999999999997, 1.0 / 3};
    EXPECT_EQ(camera_of(view_text(camera), frame, sizes[0]), camera);
}

TEST(ViewText, is_yaw_pitch_distance_and_focus) {
    EXPECT_EQ(view_text({{1, 2, -3}, 20, 35, 25.5}), "35,25.5,20,1,2,-3");
}

TEST(ViewText, words_stand_for_directions) {
    const Frame frame = test::particles_at({{0, 0, 0}, {3, 1, 2}});
    EXPECT_EQ(camera_of("default", frame, sizes[0]), default_camera(frame, sizes[0]));
    EXPECT_EQ(camera_of("front", frame, sizes[0]).yaw, 0);
    EXPECT_EQ(camera_of("side", frame, sizes[0]).yaw, 90);
    EXPECT_EQ(camera_of("top", frame, sizes[0]).pitch, 90);
}

TEST(ViewText, refusals_describe_the_valid_forms) {
    const Frame frame = test::particles_at({{0, 0, 0}});
    for (const char* text : {"", "left", "1,2,3", "1,2,3,4,5,6,7", "1,2,3,4,5,six", "1,2,nan,4,5,6", "1,2,-3,4,5,6",
                             "1,2,0,4,5,6", "1,91,3,4,5,6", "1,2,3,4,5,", "1,2,3,4,5,6 ", "1,2,inf,4,5,6"}) {
        try {
            camera_of(text, frame, sizes[0]);
            ADD_FAILURE() << "'" << text << "' was taken for a view";
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), HasSubstr("yaw,pitch,distance,x,y,z"));
            EXPECT_THAT(error.what(), HasSubstr("\"" + std::string(text) + "\""));
        }
    }
}

TEST(ViewText, lengths_that_no_picture_can_hold_are_refused) {
    const Frame frame = test::particles_at({{0, 0, 0}});
    for (const char* text : {"0,0,1e-100,0,0,0", "0,0,1e300,0,0,0", "0,0,1,1e103,0,0", "0,0,1,0,-1e200,0"})
        EXPECT_THROW(camera_of(text, frame, sizes[0]), UsageError) << text;
    EXPECT_EQ(camera_of("0,0,1e-16,4,0,-4", frame, sizes[0]).distance, 1e-16);
}

}  // namespace
}  // namespace steplab::render
