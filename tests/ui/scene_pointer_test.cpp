#include "render/drawn_sizes.hpp"
#include "render/split.hpp"
#include "ui/desk.hpp"
#include "ui/view_keeper.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::ui {
namespace {

struct Point {
    float x, y;
};

Point middle(const PixelRect& rect) {
    return {static_cast<float>(rect.x) + 0.5f * static_cast<float>(rect.width),
            static_cast<float>(rect.y) + 0.5f * static_cast<float>(rect.height)};
}

/// Where a particle is on the display.
Point on_display(const Desk& desk, std::size_t particle) {
    const PixelRect rect = desk.interface.scene();
    const render::Projection projection(desk.camera, {rect.width, rect.height});
    const auto pixel = projection.pixel(desk.view.frame.seen(particle)).value();
    return {static_cast<float>(rect.x + pixel.x), static_cast<float>(rect.y + pixel.y)};
}

void drag_scene(Desk& desk, int button, float dx, float dy) {
    const Point centre = middle(desk.interface.scene());
    desk.move_to(centre.x, centre.y);
    desk.press(button);
    desk.move_to(centre.x + 0.5f * dx, centre.y + 0.5f * dy);
    desk.move_to(centre.x + dx, centre.y + dy);
    desk.release(button);
}

TEST(scene_pointer, left_drag_orbits) {
    Desk desk;
    const render::Camera before = desk.camera;
    drag_scene(desk, 0, 100, 40);
    EXPECT_NE(desk.camera.yaw, before.yaw);
    EXPECT_NE(desk.camera.pitch, before.pitch);
    EXPECT_EQ(desk.camera.focus, before.focus);
    EXPECT_TRUE(desk.calls().empty()) << "a drag picks nothing";
}

TEST(scene_pointer, in_split_layout_picks_in_the_part_of_the_leading_run) {
    Desk desk;
    desk.session.followers = {desk.view};
    desk.style.layout = render::RunLayout::split;
    desk.frame();
    desk.calls();
    const PixelRect scene = desk.interface.scene();
    const render::PictureSize part = render::leading_size({scene.width, scene.height}, desk.style.layout, 2);
    const auto pixel = render::Projection(desk.camera, part).pixel(desk.view.frame.seen(60)).value();
    const Point place{static_cast<float>(scene.x + pixel.x), static_cast<float>(scene.y + pixel.y)};
    const auto click_at = [&](float x) {
        desk.move_to(x, place.y);
        desk.press();
        desk.release();
        return desk.calls();
    };
    EXPECT_FALSE(click_at(place.x).empty());
    EXPECT_EQ(desk.recorder.tracked, 60u);
    EXPECT_TRUE(click_at(place.x + static_cast<float>(part.width)).empty()) << "a particle of the other run";
}

TEST(scene_pointer, in_split_layout_zooms_about_the_pointer_in_every_part) {
    const auto zoomed_at = [](bool second) {
        Desk desk;
        desk.session.followers = {desk.view};
        desk.style.layout = render::RunLayout::split;
        desk.frame();
        const PixelRect scene = desk.interface.scene();
        const int width = render::leading_size({scene.width, scene.height}, desk.style.layout, 2).width;
        desk.move_to(static_cast<float>(scene.x + 200 + (second ? width : 0)), static_cast<float>(scene.y + 150));
        desk.wheel(2);
        return desk.camera;
    };
    EXPECT_EQ(zoomed_at(true), zoomed_at(false));
}

TEST(scene_pointer, right_drag_and_shift_drag_pan) {
    Desk right;
    drag_scene(right, 1, 100, 40);
    Desk shift;
    shift.interface.input().push(ModifiersChanged{.shift = true});
    drag_scene(shift, 0, 100, 40);
    for (const Desk* desk : {&right, &shift}) {
        EXPECT_NE(desk->camera.focus, Desk().camera.focus);
        EXPECT_EQ(desk->camera.yaw, Desk().camera.yaw);
    }
    EXPECT_EQ(right.camera, shift.camera);
}

TEST(scene_pointer, wheel_zooms) {
    Desk desk;
    const Point centre = middle(desk.interface.scene());
    const double before = desk.camera.distance;
    desk.move_to(centre.x + 50, centre.y);
    desk.wheel(3);
    EXPECT_LT(desk.camera.distance, before);
    desk.wheel(-6);
    EXPECT_GT(desk.camera.distance, before);
}

TEST(scene_pointer, wheel_over_the_panel_is_not_the_scenes) {
    Desk desk;
    const render::Camera before = desk.camera;
    desk.point_at("dt");
    desk.wheel(3);
    EXPECT_EQ(desk.camera, before);
}

TEST(scene_pointer, a_drag_that_begins_on_a_slider_leaves_the_camera_alone) {
    Desk desk;
    const render::Camera before = desk.camera;
    desk.point_at("dt");
    desk.press();
    const Point centre = middle(desk.interface.scene());
    desk.move_to(centre.x, centre.y);
    desk.move_to(centre.x + 60, centre.y);
    desk.release();
    EXPECT_EQ(desk.camera, before);
}

TEST(scene_pointer, click_picks_the_particle_under_it) {
    Desk desk(describe("chain"));
    for (const std::size_t particle : {2u, 7u}) {
        const Point place = on_display(desk, particle);
        desk.move_to(place.x, place.y);
        desk.press();
        desk.release();
        EXPECT_EQ(desk.recorder.tracked, particle);
    }
}

TEST(scene_pointer, click_beside_a_particle_within_some_pixels_picks_it) {
    Desk desk(describe("chain"), {2560, 1600, 2});
    const Point place = on_display(desk, 4);
    const PixelRect rect = desk.interface.scene();
    const render::Projection projection(desk.camera, {rect.width, rect.height});
    const double scale = projection.pixels_per_unit(projection.depth(desk.view.frame.positions[4]));
    const double radius = scale * render::DrawnSizes(*desk.view.frame.shape).radius(Role::moving);
    const auto edge = static_cast<float>(radius);
    for (const float beyond : {10.0f, 60.0f}) {  // pixels at scale 2: inside the tolerance and outside
        desk.recorder.tracked.reset();
        desk.move_to(place.x, place.y + edge + beyond);
        desk.press();
        desk.release();
        EXPECT_EQ(desk.recorder.tracked.has_value(), beyond < 20) << beyond;
    }
}

TEST(scene_pointer, a_pulled_particle_is_selected) {
    Desk desk(describe("chain"));
    const Point place = on_display(desk, 5);
    desk.interface.input().push(ModifiersChanged{.control = true});
    desk.move_to(place.x, place.y);
    desk.press();
    EXPECT_EQ(desk.recorder.tracked, 5u);
    desk.release();
}

TEST(scene_pointer, a_scene_out_of_view_is_reported_and_f_brings_it_back) {
    Desk desk(describe("chain"));
    EXPECT_FALSE(desk.has("lost"));
    for (const bool by_key : {true, false}) {
        for (const Vec3 focus : {Vec3{1000, 0, 0}, Vec3{0, 0, -1e30}, Vec3{0, 1e99, 0}}) {
            desk.camera.focus = focus;
            for (int i = 0; i < 2; ++i) desk.frame();
            ASSERT_TRUE(desk.has("lost")) << focus.x;
            by_key ? desk.key(Key::f) : desk.click("lost.fit");
            EXPECT_FALSE(desk.has("lost"));
            EXPECT_LT(length(desk.camera.focus), 100);
        }
    }
}

TEST(scene_pointer, the_wheel_keeps_any_scene_in_reach) {
    for (const double length : {1e-30, 1.0, 1e30}) {
        RunDescription description = describe("chain");
        description.scene.set("L", length);
        description.scene.set("v0", 0);  // otherwise the kick, not the chain, sets the size of the scene
        Desk desk(description);
        const Point centre = middle(desk.interface.scene());
        desk.move_to(centre.x, centre.y);
        const render::Camera home = desk.camera;
        for (const float lines : {1.0f, -1.0f, 400.0f, -800.0f}) {
            desk.wheel(lines);
            EXPECT_GT(desk.camera.distance, 1e-4 * home.distance) << lines;
            EXPECT_LT(desk.camera.distance, 1e4 * home.distance) << lines;
        }
        desk.key(Key::f);
        EXPECT_NEAR(desk.camera.distance / home.distance, 1, 0.5);
    }
}

TEST(scene_pointer, click_beside_every_particle_picks_none) {
    Desk desk(describe("chain"));
    const PixelRect rect = desk.interface.scene();
    desk.move_to(static_cast<float>(rect.x + 5), static_cast<float>(rect.y + rect.height - 5));
    desk.press();
    desk.release();
    EXPECT_TRUE(desk.calls().empty());
}

TEST(scene_pointer, control_drag_pulls_the_particle_under_it) {
    Desk desk(describe("chain"));
    const render::Camera before = desk.camera;
    const Point place = on_display(desk, 5);
    desk.interface.input().push(ModifiersChanged{.control = true});
    desk.move_to(place.x, place.y);
    desk.press();
    desk.move_to(place.x, place.y - 40);
    ASSERT_TRUE(desk.recorder.pulled);
    EXPECT_EQ(desk.recorder.pulled->particle, 5u);
    const Vec3 start = desk.view.frame.positions[5];
    EXPECT_GT(desk.recorder.pulled->position.y, start.y);
    const render::Projection projection(desk.camera, {100, 100});
    // It moves in the plane that faces the eye; the pointer's place is a float, 7 digits of the distance.
    EXPECT_NEAR(projection.depth(desk.recorder.pulled->position), projection.depth(start), 1e-4);
    desk.release();
    desk.calls();
    desk.move_to(place.x, place.y - 80);
    EXPECT_TRUE(desk.calls().empty());
    EXPECT_EQ(desk.camera, before);
}

TEST(scene_pointer, what_is_pulled_in_a_periodic_scene_is_where_it_is_seen) {
    Desk desk(describe("crystal"));
    const std::size_t particle = desk.view.frame.positions.size() - 1;
    // It has left the box: another image of it is seen.
    desk.view.frame.positions[particle].z -= 3 * desk.view.frame.shape->box.z;
    const Vec3 seen = desk.view.frame.seen(particle);
    ASSERT_NE(seen, desk.view.frame.positions[particle]);
    const Point place = on_display(desk, particle);
    desk.interface.input().push(ModifiersChanged{.control = true});
    desk.move_to(place.x, place.y);
    desk.press();
    desk.move_to(place.x, place.y - 40);
    ASSERT_TRUE(desk.recorder.pulled);
    const std::size_t pulled = desk.recorder.pulled->particle;
    const render::Projection projection(desk.camera, {100, 100});
    // The pointer's place is a float, 7 digits of the distance.
    EXPECT_NEAR(projection.depth(desk.recorder.pulled->position), projection.depth(desk.view.frame.seen(pulled)), 1e-4);
    EXPECT_EQ(pulled, particle);
}

TEST(scene_pointer, another_scene_is_shown_whole_and_one_of_its_particles_followed) {
    Desk desk(describe("mesh"));
    const render::Camera before = desk.camera;
    desk.view = view_of(Simulation(describe("rope")));
    desk.view.run = 1;
    desk.interface.record(desk.view);
    desk.frame();
    EXPECT_NE(desk.camera, before);
    EXPECT_EQ(desk.recorder.tracked, first_followed(*desk.view.frame.shape));
}

TEST(scene_pointer, another_scene_is_drawn_with_displacements_as_they_are) {
    Desk desk(describe("chain"));
    desk.style.displacements = 1000;
    desk.show(view_of(Simulation(describe("chain", "verlet"))));
    EXPECT_EQ(desk.style.displacements, 1000) << "another method";
    desk.show(view_of(Simulation(describe("rope"))));
    EXPECT_EQ(desk.style.displacements, 1);
    EXPECT_EQ(std::get<event::Magnify>(desk.recorder.events.back()).factor, 1);
}

TEST(scene_pointer, a_camera_that_was_moved_stays_when_the_scene_changes_its_size) {
    Desk desk(describe("chain"));
    drag_scene(desk, 0, 80, 0);
    const render::Camera moved = desk.camera;
    RunDescription longer = describe("chain");
    longer.scene.set("n", 20);
    desk.view = view_of(Simulation(longer));
    desk.view.run = 1;
    desk.frame();
    EXPECT_EQ(desk.camera, moved);
}

TEST(scene_pointer, the_kicked_particle_is_followed_first) {
    const RunView mesh = view_of(Simulation(describe("mesh")));
    EXPECT_EQ(mesh.frame.shape->roles[first_followed(*mesh.frame.shape)], Role::kicked);
    const RunView morse = view_of(Simulation(describe("morse")));
    EXPECT_EQ(morse.frame.shape->roles[first_followed(*morse.frame.shape)], Role::bullet);
    const RunView rope = view_of(Simulation(describe("rope")));
    EXPECT_EQ(first_followed(*rope.frame.shape), rope.frame.shape->roles.size() - 1);
}

}  // namespace
}  // namespace steplab::ui
