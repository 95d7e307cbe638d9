#include "ui/hands_test.hpp"

#include <gmock/gmock.h>

namespace steplab::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST_F(WithHands, keys_pull_the_selected_particle_in_the_plane_of_the_view) {
    const render::Camera before = desk.camera;
    const render::Projection projection(desk.camera, {desk.interface.scene().width, desk.interface.scene().height});
    const Vec3 seen = desk.view.frame.seen(5);
    const auto by = [&](Key key, bool shift) {
        desk.key(key, true, shift);
        EXPECT_THAT(desk.calls(), ElementsAre("pull")) << "no step is taken";
        EXPECT_EQ(last_act<Pull>().particle, 5u);
        return last_act<Pull>().position - seen;
    };
    const Vec3 up = by(Key::up, false), right = by(Key::right, false);
    EXPECT_GT(dot(up, projection.up()), 0);
    EXPECT_NEAR(dot(up, projection.right()), 0, 1e-6 * length(up));
    EXPECT_NEAR(dot(up, projection.forward()), 0, 1e-6 * length(up));
    EXPECT_GT(dot(right, projection.right()), 0);
    EXPECT_LT(dot(by(Key::left, false), projection.right()), 0);
    EXPECT_LT(dot(by(Key::down, false), projection.up()), 0);
    EXPECT_GT(length(by(Key::up, true)), 3 * length(up)) << "with Shift, by larger steps";
    EXPECT_EQ(desk.camera, before);
}

TEST_F(WithHands, keys_pull_on_from_where_they_pulled_to_while_control_is_held) {
    const auto press_up = [&] {
        desk.interface.input().push(KeyChanged{Key::up, true});
        desk.frame();
        desk.interface.input().push(KeyChanged{Key::up, false});
        desk.frame();
        return last_act<Pull>().position.y;
    };
    hold_keys({.control = true});
    const double once = press_up();
    EXPECT_NEAR(press_up(), 2 * once, 0.01 * once) << "though the view is of the moment before";
    hold_keys({});
    desk.frame();
    hold_keys({.control = true});
    EXPECT_NEAR(press_up(), once, 1e-9) << "a new hold begins where the particle is seen";
}

TEST_F(WithHands, keys_tug_once_a_step_until_control_is_let_go) {
    play_a_step();
    hold_keys({.control = true});
    desk.interface.input().push(KeyChanged{Key::up, true});
    desk.frame();
    const Tug first = last_act<Tug>();
    EXPECT_EQ(first.particle, 5u);
    EXPECT_FALSE(first.goes_on);
    EXPECT_GT(first.position.y, 0);
    desk.interface.input().push(KeyChanged{Key::up, false});
    desk.frame();
    desk.calls();
    for (int i = 0; i < 3; ++i) {
        play_a_step();
        EXPECT_TRUE(last_act<Tug>().goes_on);
        EXPECT_THAT(desk.calls(), ElementsAre("act")) << "the key is up, the spring pulls";
        EXPECT_EQ(last_act<Tug>().position, first.position);
    }
    EXPECT_TRUE(desk.interface.is_dragging());
    hold_keys({});
    play_a_step();
    EXPECT_THAT(desk.calls(), IsEmpty());
    EXPECT_FALSE(desk.interface.is_dragging());
}

TEST_F(WithHands, keys_pull_all_selected_particles) {
    hold_keys({.shift = true});
    click(7);
    desk.calls();
    hold_keys({});
    desk.key(Key::up, true);
    EXPECT_EQ(last_act<Pull>().particle, 5u);
    EXPECT_EQ(last_act<Pull>().others, ParticleList({7}));
}

}  // namespace
}  // namespace steplab::ui
