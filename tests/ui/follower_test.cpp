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

class TrailsTest : public testing::Test {
protected:
    /// A step later `particle` is selected, and all lie `height` above where they were.
    void record(std::size_t particle, double height, bool shown = true) {
        ++view_.frame.step;
        view_.tracked->particle = particle;
        for (std::size_t i = 0; i < start_.size(); ++i) view_.frame.positions[i] = start_[i] + Vec3{0, height, 0};
        trails_.record(view_, shown);
    }

    RunView view_ = view_of(Simulation(describe("free")), 3);
    std::vector<Vec3> start_ = view_.frame.positions;
    Trails trails_;
};

TEST_F(TrailsTest, are_of_one_run) {
    trails_.record(view_, true);
    EXPECT_FALSE(trails_.places());
    record(3, 1);
    trails_.record(view_, true);  // the same moment
    ASSERT_TRUE(trails_.places());
    ASSERT_EQ(trails_.places()->size(), 1u);
    EXPECT_EQ(trails_.places()->front(), (std::vector<Vec3>{start_[3], start_[3] + Vec3{0, 1, 0}}));
    view_.run = 7;
    record(3, 2);
    EXPECT_FALSE(trails_.places());
}

TEST_F(TrailsTest, of_particles_selected_before_go_on_while_they_are_shown) {
    record(3, 1);
    record(3, 2);
    record(5, 3);
    record(5, 4);
    ASSERT_EQ(trails_.places()->size(), 2u);
    EXPECT_EQ(trails_.places()->front().size(), 4u);
    EXPECT_EQ(trails_.places()->front().back(), (start_[3] + Vec3{0, 4, 0}));
    EXPECT_EQ(trails_.places()->back().size(), 2u);
    record(5, 5, false);
    ASSERT_EQ(trails_.places()->size(), 1u);
    EXPECT_EQ(trails_.places()->front().back(), (start_[5] + Vec3{0, 5, 0}));
}

TEST_F(TrailsTest, of_too_many_particles_lose_the_first) {
    for (std::size_t i = 0; i <= Trails::most_particles; ++i) record(i, static_cast<double>(i));
    record(0, 20);
    record(0, 21);
    ASSERT_EQ(trails_.places()->size(), Trails::most_particles);
    EXPECT_EQ(trails_.places()->back().size(), 2u) << "it was forgotten, and selected again";
}

TEST(trail, is_drawn_where_it_is_wanted) {
    Desk desk(describe("free"));
    RunView next = moved(desk.view, {});
    next.tracked = desk.view.tracked = Tracked{3, {}, {}};
    desk.show(desk.view);
    desk.show(next);
    EXPECT_FALSE(desk.style.trails);
    desk.click("trail");
    EXPECT_TRUE(desk.style.trails);
    desk.click("velocities");
    EXPECT_TRUE(desk.style.velocities);
    desk.click("forces");
    EXPECT_TRUE(desk.style.forces);
    EXPECT_TRUE(desk.recorder.with_forces) << "the worker has to compute them";
}

}  // namespace
}  // namespace steplab::ui
