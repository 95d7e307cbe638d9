#include "ui/desk.hpp"
#include "ui/trail.hpp"

#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

RunView moved(RunView view, Vec3 way) {
    ++view.frame.step;
    for (Vec3& position : view.frame.positions) position = position + way;
    return view;
}

TEST(follow, camera_goes_with_the_centre) {
    Desk desk(describe("free"));
    const render::Camera start = desk.camera;
    desk.show(moved(desk.view, {1, 0, 0}));
    EXPECT_EQ(desk.camera, start) << "it stays unless it is to follow";
    desk.click("follow/centre");
    desk.show(moved(desk.view, {0, 2, 0}));
    EXPECT_NEAR(desk.camera.focus.y, start.focus.y + 2, 1e-12);  // rounding of a mean of ten numbers of size 10
    EXPECT_EQ(desk.camera.distance, start.distance);
    desk.click("follow/nothing");
    const render::Camera there = desk.camera;
    desk.show(moved(desk.view, {0, 0, 5}));
    EXPECT_EQ(desk.camera, there);
}

TEST(follow, selecting_another_particle_does_not_move_the_camera) {
    Desk desk(describe("free"));
    desk.view.tracked = Tracked{2, {}, {}};
    desk.show(desk.view);
    desk.click("follow/particle");
    const render::Camera before = desk.camera;
    desk.view.tracked = Tracked{5, {}, {}};
    ++desk.view.frame.step;
    desk.show(desk.view);
    EXPECT_EQ(desk.camera, before);
    RunView next = moved(desk.view, {0, 0, 0});
    next.frame.positions[5].x += 3;
    desk.show(next);
    EXPECT_DOUBLE_EQ(desk.camera.focus.x, before.focus.x + 3);
}

TEST(trail, is_of_one_particle_in_one_run) {
    RunView view = view_of(Simulation(describe("free")), 3);
    Trail trail;
    trail.record(view);
    EXPECT_FALSE(trail.places());
    view.frame.step = 1;
    view.tracked->displacement = {0, 1, 0};
    trail.record(view);
    trail.record(view);
    ASSERT_TRUE(trail.places());
    EXPECT_EQ(trail.places()->size(), 2u);
    EXPECT_EQ(trail.places()->back(), (view.frame.shape->rest[3] + Vec3{0, 1, 0}));
    view.run = 7;
    trail.record(view);
    EXPECT_FALSE(trail.places());
}

TEST(trail, is_drawn_where_it_is_wanted) {
    Desk desk(describe("free"));
    RunView next = moved(desk.view, {});
    next.tracked = desk.view.tracked = Tracked{3, {}, {}};
    desk.show(desk.view);
    desk.show(next);
    EXPECT_FALSE(desk.style.trail);
    desk.click("trail");
    EXPECT_TRUE(desk.style.trail);
    desk.click("velocities");
    EXPECT_TRUE(desk.style.velocities);
}

}  // namespace
}  // namespace steplab::ui
