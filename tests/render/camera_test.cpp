#include "render/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace steplab::render {
namespace {

const Camera camera{{1, 2, -3}, 20, 35, 25};
const PictureSize window_size{1280, 720};

// Positions in pixels go through some twenty operations of double; 1e-9 of a pixel is far above their rounding.
constexpr double pixel_tolerance = 1e-9;

TEST(Projection, focus_is_in_the_middle_of_the_picture) {
    const auto pixel = Projection(camera, window_size).pixel(camera.focus);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x, 640, pixel_tolerance);
    EXPECT_NEAR(pixel->y, 360, pixel_tolerance);
}

TEST(Projection, without_angles_x_is_right_and_y_up) {
    const Projection projection({{0, 0, 0}, 10, 0, 0}, window_size);
    EXPECT_GT(projection.pixel({1, 0, 0})->x, 640);
    EXPECT_LT(projection.pixel({0, 1, 0})->y, 360);
    EXPECT_LT(projection.depth({0, 0, 1}), projection.depth({0, 0, 0}));
}

TEST(Projection, positive_pitch_views_from_above) {
    EXPECT_GT(Projection({{0, 0, 0}, 10, 0, 30}, window_size).eye().y, 0);
    EXPECT_GT(Projection({{0, 0, 0}, 10, 30, 0}, window_size).eye().x, 0);
}

TEST(Projection, ray_through_a_pixel_meets_the_point_seen_there) {
    const Projection projection(camera, window_size);
    const Vec3 point{3, -1, 2};
    const Ray ray = projection.ray(*projection.pixel(point));
    const double along = dot(point - ray.origin, ray.direction);
    EXPECT_LT(length(ray.origin + along * ray.direction - point), 1e-12);
    EXPECT_NEAR(length(ray.direction), 1, 1e-15);
}

TEST(Projection, point_behind_the_eye_is_not_in_the_picture) {
    const Projection projection(camera, window_size);
    EXPECT_FALSE(projection.pixel(projection.eye() - projection.forward()));
}

TEST(Projection, point_of_the_focus_plane_comes_back) {
    const Projection projection(camera, window_size);
    const auto pixel = projection.pixel(projection.on_focus_plane({100, 650}));
    EXPECT_NEAR(pixel->x, 100, pixel_tolerance);
    EXPECT_NEAR(pixel->y, 650, pixel_tolerance);
}

TEST(Zoom, keeps_the_point_under_the_cursor) {
    const PixelPoint cursor{200, 555};
    const Projection before(camera, window_size);
    const Vec3 point = before.on_focus_plane(cursor);
    const Projection after(zoomed(before, 1.7, cursor), window_size);
    EXPECT_NEAR(after.pixel(point)->x, cursor.x, pixel_tolerance);
    EXPECT_NEAR(after.pixel(point)->y, cursor.y, pixel_tolerance);
    EXPECT_DOUBLE_EQ(after.camera().distance, camera.distance / 1.7);
    // Zooming to the middle instead does not keep it.
    const Projection centred(zoomed(before, 1.7, {640, 360}), window_size);
    EXPECT_GT(std::abs(centred.pixel(point)->x - cursor.x), 100);
}

TEST(Zoom, never_reaches_the_focus) {
    Camera near = camera;
    for (int i = 0; i < 2000; ++i) near = zoomed(Projection(near, window_size), 2, {640, 360});
    EXPECT_GT(near.distance, 0);
}

TEST(Zoom, stays_within_its_limits_and_comes_back_from_beyond) {
    const ZoomLimits limits{2, 50};
    Camera moved = camera;
    for (int i = 0; i < 100; ++i) moved = zoomed(Projection(moved, window_size), 1.5, {640, 360}, limits);
    EXPECT_EQ(moved.distance, 2);
    for (int i = 0; i < 100; ++i) moved = zoomed(Projection(moved, window_size), 0.5, {640, 360}, limits);
    EXPECT_EQ(moved.distance, 50);
    for (const double distance : {1e-16, 1e30}) {
        Camera beyond = camera;
        beyond.distance = distance;
        const Camera back = zoomed(Projection(beyond, window_size), 0.9, {640, 360}, limits);
        EXPECT_TRUE(back.distance == 2 || back.distance == 50) << distance;
    }
}

TEST(Camera, of_any_gestures_is_made_of_numbers) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-99, 99), part(-1, 1);
    for (int run = 0; run < 300; ++run) {
        const auto any = [&] { return part(random) * std::pow(10.0, exponent(random)); };
        Camera moved{{any(), any(), any()}, std::pow(10.0, exponent(random)), 180 * part(random), 90 * part(random)};
        for (int i = 0; i < 50; ++i) {
            const Projection from(moved, window_size);
            const PixelPoint pixel{1280 * part(random), 720 * part(random)};
            switch (random() % 3) {
                case 0:
                    moved = zoomed(from, std::pow(1.15, 40 * part(random)), pixel);
                    break;
                case 1:
                    moved = panned(from, 5000 * part(random), 5000 * part(random));
                    break;
                default:
                    moved = orbited(from, 1e5 * part(random), 1e5 * part(random));
            }
            ASSERT_TRUE(std::isfinite(length(moved.focus)));
            ASSERT_TRUE(moved.distance >= least_distance && moved.distance <= largest_length);
            ASSERT_TRUE(std::abs(moved.pitch) <= 90 && std::abs(moved.yaw) <= 360);
            const Projection to(moved, window_size);
            ASSERT_TRUE(std::isfinite(length(to.eye())));
        }
    }
}

TEST(Pan, moves_the_focus_with_the_cursor) {
    const Projection before(camera, window_size);
    const Projection after(panned(before, 50, -30), window_size);
    EXPECT_NEAR(after.pixel(camera.focus)->x, 690, pixel_tolerance);
    EXPECT_NEAR(after.pixel(camera.focus)->y, 330, pixel_tolerance);
}

TEST(Orbit, keeps_focus_and_distance) {
    const Camera turned = orbited(Projection(camera, window_size), 100, 40);
    EXPECT_EQ(turned.focus, camera.focus);
    EXPECT_EQ(turned.distance, camera.distance);
    EXPECT_NE(turned.yaw, camera.yaw);
    EXPECT_NE(turned.pitch, camera.pitch);
}

TEST(Orbit, stops_straight_above) {
    EXPECT_EQ(orbited(Projection(camera, window_size), 0, 1e6).pitch, 90);
    EXPECT_EQ(orbited(Projection(camera, window_size), 0, -1e6).pitch, -90);
}

TEST(Orbit, drag_to_the_right_turns_the_near_side_to_the_right) {
    const Projection before({{0, 0, 0}, 10, 0, 0}, window_size);
    const Projection after(orbited(before, 60, 0), window_size);
    EXPECT_GT(after.pixel({0, 0, 1})->x, before.pixel({0, 0, 1})->x);
}

}  // namespace
}  // namespace steplab::render
