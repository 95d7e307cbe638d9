#include "render/bounds.hpp"

#include "render/scenes.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace steplab::render {
namespace {

using testing::ElementsAre;

TEST(AxesBox, holds_rest_and_expected_places) {
    Frame frame = test::particles_at({{0, 0, 0}, {10, 0, 0}});
    auto shape = std::make_shared<Shape>(*frame.shape);
    shape->expected = {{5, -4, 0}};
    frame.shape = shape;
    const AxesBox box = axes_box(frame);
    EXPECT_LE(box.bounds.low.y, -4);
    EXPECT_GE(box.bounds.high.x, 10);
}

TEST(AxesBox, stands_still_while_the_scene_moves_in_it) {
    Frame frame = test::particles_at({{0, 0, 0}, {10, 0, 0}});
    const AxesBox before = axes_box(frame);
    frame.positions[1].y = 0.5;
    EXPECT_EQ(axes_box(frame).bounds, before.bounds);
}

TEST(AxesBox, grows_by_whole_steps) {
    Frame frame = test::particles_at({{0, 0, 0}, {10, 0, 0}});
    const AxesBox before = axes_box(frame);
    frame.positions[1].x = 12.3;
    const AxesBox after = axes_box(frame);
    EXPECT_GE(after.bounds.high.x, 12.3);
    const double steps = (after.bounds.high.x - before.bounds.high.x) / after.step;
    EXPECT_NEAR(steps, std::round(steps), 1e-12);
}

TEST(AxesBox, of_a_periodic_scene_stays_where_everything_is_seen) {
    const AxesBox within = axes_box(test::periodic({{0, 0, 0}}, 4, {-2, -2, -2}));
    const AxesBox far = axes_box(test::periodic({{400, -800, 0}}, 4, {-2, -2, -2}));
    EXPECT_EQ(far.bounds, within.bounds);
    EXPECT_EQ(far.step, within.step);
    EXPECT_GT(axes_box(test::particles_at({{0, 0, 0}, {400, -800, 0}})).bounds.high.x, 399);
}

TEST(PeriodicScene, is_seen_in_its_box) {
    Shape shape;
    shape.box = {4, 4, 4};
    shape.corner = {-1, 0, 2};
    const Vec3 inside{0.5, 3.25, 5.5};
    EXPECT_EQ(shape.seen(inside), inside);
    EXPECT_EQ(shape.seen(shape.corner), shape.corner);
    EXPECT_EQ(shape.seen(shape.corner + Vec3{4, 4, 4}), shape.corner) << "the far side is the near one's image";
    for (const double periods : {-3.0, -1.0, 1.0, 7.0}) {
        EXPECT_EQ(shape.seen(inside + Vec3{4 * periods, 0, 0}), inside);
        EXPECT_EQ(shape.seen(inside + Vec3{0, 4 * periods, 0}), inside);
        EXPECT_EQ(shape.seen(inside + Vec3{0, 0, -4 * periods}), inside);
    }
    shape.box = {4, 0, 2};
    EXPECT_EQ(shape.seen({100, -100, 7}), (Vec3{0, -100, 3})) << "open along y";
    EXPECT_EQ(shape.nearest({3, 9, -1.5}), (Vec3{-1, 9, 0.5}));
    shape.box = {};
    EXPECT_EQ(shape.seen({100, -100, 7}), (Vec3{100, -100, 7}));
}

TEST(Bounds, pass_over_what_cannot_be_drawn) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3> points{{nan, 0, 0}, {1, 1, 1}, {2, 0, 1}, {0, 1e300, 0}};
    EXPECT_EQ(bounds_of(points), (Bounds{{1, 0, 1}, {2, 1, 1}}));
    EXPECT_EQ(bounds_of(std::span(points).first(1)), Bounds{});
}

}  // namespace
}  // namespace steplab::render
