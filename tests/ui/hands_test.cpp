#include "ui/hands_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace steplab::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST_F(WithHands, shift_click_adds_particles_and_takes_them_away) {
    hold_keys({.shift = true});
    click(7);
    click(3);
    EXPECT_THAT(others(), ElementsAre(3, 7));
    desk.frame();
    EXPECT_THAT(desk.calls(), ElementsAre("also track 7", "also track 3 7")) << "the first one stays it";
    click(3);
    EXPECT_THAT(others(), ElementsAre(7));
    click(5);
    EXPECT_EQ(desk.recorder.tracked, 7u) << "the first one was taken away";
    EXPECT_THAT(others(), IsEmpty());
    hold_keys({});
    click(2);
    EXPECT_EQ(desk.recorder.tracked, 2u);
    EXPECT_THAT(others(), IsEmpty()) << "a click selects one";
}

TEST_F(WithHands, alt_drag_selects_what_is_in_the_box) {
    const render::Camera before = desk.camera;
    hold_keys({.alt = true});
    drag_box(3, 6);
    EXPECT_THAT(others(), ElementsAre(3, 4, 6));
    EXPECT_FALSE(desk.recorder.tracked) << "particle 5 is in it";
    drag_box(7, 8);
    EXPECT_EQ(desk.recorder.tracked, 7u);
    desk.show(view_of(simulation, 7));
    EXPECT_THAT(others(), ElementsAre(8));
    hold_keys({.shift = true, .alt = true});
    drag_box(2, 2);
    EXPECT_THAT(others(), ElementsAre(2, 8)) << "with Shift, they are added";
    EXPECT_EQ(desk.camera, before);
}

TEST_F(WithHands, what_differs_among_the_selected_is_not_shown_as_that_of_the_first) {
    RunView view = view_of(simulation, 5);
    Shape shape = *view.frame.shape;
    shape.roles[5] = Role::fixed;
    view.frame.shape = std::make_shared<const Shape>(shape);
    desk.show(view);
    hold_keys({.shift = true});
    click(7);
    hold_keys({});
    desk.frame();
    desk.click("selection.fixed");
    ASSERT_FALSE(desk.recorder.changes.empty());
    EXPECT_EQ(desk.wanted().alterations.of(7).fixed, true) << "one is fixed and one is not: a click fixes both";
    EXPECT_EQ(desk.wanted().alterations.of(5).fixed, true);
}

TEST_F(WithHands, the_mass_of_the_first_is_not_given_to_others_unasked) {
    RunDescription description = describe("chain");
    description = with_alterations(description, std::vector<Alteration>{{.particle = 7, .mass = 4}});
    desk.show(view_of(Simulation(description), 5));
    hold_keys({.shift = true});
    click(7);
    hold_keys({});
    desk.click("selection.mass.value");
    desk.key(Key::enter);
    EXPECT_THAT(desk.recorder.changes, IsEmpty()) << "the entry of a mixed selection is empty";
    EXPECT_TRUE(desk.has("refusal"));
}

TEST_F(WithHands, an_empty_box_leaves_the_first_one_alone) {
    hold_keys({.alt = true});
    drag_box(3, 6);
    const PixelRect scene = desk.interface.scene();
    const auto x = static_cast<float>(scene.x + 5), y = static_cast<float>(scene.y + scene.height - 60);
    desk.move_to(x, y);
    desk.press();
    desk.move_to(x + 20, y + 30);
    desk.release();
    EXPECT_THAT(others(), IsEmpty());
    EXPECT_FALSE(desk.recorder.tracked);
}

TEST_F(WithHands, s_makes_the_next_drag_a_box) {
    desk.key(Key::s);
    drag_box(3, 6);
    EXPECT_THAT(others(), ElementsAre(3, 4, 6));
    const render::Camera before = desk.camera;
    drag_box(7, 8);
    EXPECT_NE(desk.camera, before) << "the next one orbits again";
    EXPECT_THAT(others(), ElementsAre(3, 4, 6));
    desk.camera = before;
    desk.key(Key::s);
    desk.key(Key::escape);
    drag_box(7, 8);
    EXPECT_THAT(others(), ElementsAre(3, 4, 6));
}

TEST_F(WithHands, another_scene_has_no_selection) {
    hold_keys({.alt = true});
    drag_box(3, 6);
    desk.show(view_of(Simulation(describe("rope"))));
    desk.frame();
    EXPECT_THAT(others(), IsEmpty());
}

TEST_F(WithHands, selected_particles_are_pulled_together_while_the_run_stands) {
    hold_keys({.alt = true});
    drag_box(0, 6);
    hold_keys({.control = true});
    const DisplayPoint place = place_of(desk, 4);
    desk.move_to(place.x, place.y);
    desk.press();
    EXPECT_THAT(desk.calls(), ElementsAre("also track 0 1 2 3 4 6")) << "it is selected already";
    desk.move_to(place.x, place.y - 40);
    const Pull pull = last_act<Pull>();
    EXPECT_EQ(pull.particle, 4u);
    EXPECT_EQ(pull.others, ParticleList({1, 2, 3, 5, 6})) << "particle 0 is fixed";
    desk.release();
    desk.calls();
    const DisplayPoint other = place_of(desk, 8);
    desk.move_to(other.x, other.y);
    desk.press();
    EXPECT_EQ(desk.recorder.tracked, 8u);
    desk.move_to(other.x, other.y - 40);
    EXPECT_EQ(last_act<Pull>().particle, 8u);
    EXPECT_TRUE(last_act<Pull>().others.empty());
}

TEST_F(WithHands, a_magnified_particle_is_pulled_kicked_and_tugged_to_where_it_is_drawn) {
    const auto pulled_with = [&](double magnified, bool playing) {
        RunView view = view_of(simulation, 5);
        view.frame.magnified = magnified;
        view.playing = playing;
        desk.show(view);
        const DisplayPoint place = place_of(desk, 5);
        hold_keys({.control = true});
        desk.move_to(place.x, place.y);
        desk.press();
        desk.move_to(place.x + 20, place.y - 40);
        const Vec3 position = playing ? last_act<Tug>().position : last_act<Pull>().position;
        desk.release();
        return position - view.frame.shape->rest[5];
    };
    for (const bool playing : {false, true}) {
        const Vec3 usual = pulled_with(1, playing), small = pulled_with(64, playing);
        EXPECT_GT(length(usual), 0.01);
        EXPECT_LT(length(64.0 * small - usual), 1e-12) << "at rest it is drawn at the same place: some roundings";
    }
}

TEST_F(WithHands, while_the_run_plays_a_particle_is_tugged_once_a_step) {
    play_a_step();
    const DisplayPoint place = place_of(desk, 5);
    hold_keys({.control = true});
    desk.move_to(place.x, place.y);
    desk.press();
    desk.move_to(place.x, place.y - 40);
    const Tug first = last_act<Tug>();
    EXPECT_EQ(first.particle, 5u);
    EXPECT_FALSE(first.goes_on);
    EXPECT_GT(first.position.y, 0);
    EXPECT_GT(first.rate, 1);
    desk.calls();
    for (int i = 0; i < 3; ++i) desk.frame();
    EXPECT_THAT(desk.calls(), IsEmpty()) << "no time has passed for the run";
    for (int i = 0; i < 3; ++i) {
        play_a_step();
        EXPECT_TRUE(last_act<Tug>().goes_on);
        EXPECT_THAT(desk.calls(), ElementsAre("act")) << "the pointer rests, the spring pulls";
    }
    desk.release();
    desk.calls();
    play_a_step();
    EXPECT_THAT(desk.calls(), IsEmpty());
    desk.move_to(place.x, place.y);
    desk.press();
    desk.move_to(place.x, place.y - 60);
    EXPECT_FALSE(last_act<Tug>().goes_on) << "another hold";
}

TEST_F(WithHands, a_slower_run_is_tugged_more_strongly) {
    std::vector<double> rates;
    for (const double speed : {1.0, 0.1}) {
        simulation.advance(1);
        RunView view = view_of(simulation, 5);
        view.playing = true;
        view.rate.seconds_per_second = speed;
        desk.show(view);
        const DisplayPoint place = place_of(desk, 5);
        hold_keys({.control = true});
        desk.move_to(place.x, place.y);
        desk.press();
        desk.move_to(place.x, place.y - 40);
        rates.push_back(last_act<Tug>().rate);
        desk.release();
    }
    EXPECT_NEAR(rates[1], 10 * rates[0], 1e-9);
}

TEST_F(WithHands, control_right_drag_kicks_along_its_arrow) {
    const render::Camera before = desk.camera;
    const DisplayPoint place = place_of(desk, 5);
    const auto kick_up = [&](float pixels) {
        hold_keys({.control = true});
        desk.move_to(place.x, place.y);
        desk.press(1);
        desk.move_to(place.x, place.y - pixels);
        EXPECT_THAT(desk.calls(), IsEmpty()) << "it is aimed";
        desk.release(1);
    };
    kick_up(50);
    const Kick half = last_act<Kick>();
    EXPECT_EQ(half.particle, 5u);
    EXPECT_GT(half.velocity.y, 0);
    EXPECT_THAT(desk.calls(), ElementsAre("act"));
    kick_up(100);
    // the pointer is on whole pixels, of 50
    EXPECT_NEAR(length(last_act<Kick>().velocity), 2 * length(half.velocity), 0.04 * length(half.velocity));
    desk.calls();
    kick_up(2);
    EXPECT_THAT(desk.calls(), IsEmpty()) << "no arrow, no kick";
    EXPECT_EQ(desk.camera, before);
    hold_keys({.control = true});
    desk.move_to(place.x, place.y - 150);
    desk.press(1);
    desk.move_to(place.x + 50, place.y - 180);
    desk.release(1);
    EXPECT_THAT(desk.calls(), IsEmpty());
    EXPECT_NE(desk.camera, before) << "beside particles it pans";
}

TEST_F(WithHands, a_kick_of_a_selected_particle_kicks_all) {
    hold_keys({.shift = true});
    click(7);
    hold_keys({.control = true});
    const DisplayPoint place = place_of(desk, 7);
    desk.move_to(place.x, place.y);
    desk.press(1);
    desk.move_to(place.x, place.y - 50);
    desk.release(1);
    EXPECT_EQ(last_act<Kick>().particle, 7u);
    EXPECT_EQ(last_act<Kick>().others, ParticleList({5}));
}

TEST_F(WithHands, the_panel_fixes_particles_and_changes_their_mass) {
    hold_keys({.shift = true});
    click(7);
    hold_keys({});
    desk.frame();
    desk.click("selection.fixed");
    const auto wanted = [&](std::size_t particle) { return desk.wanted().alterations.of(particle); };
    EXPECT_EQ(wanted(5).fixed, true);
    EXPECT_EQ(wanted(7).fixed, true);
    EXPECT_EQ(wanted(6).fixed, std::nullopt);
    desk.click("selection.mass.value");
    desk.type("2.5");
    desk.key(Key::enter);
    EXPECT_EQ(wanted(7).mass, 2.5);
    EXPECT_EQ(wanted(7).fixed, true) << "that stays";
    const std::size_t changes = desk.recorder.changes.size();
    desk.click("selection.mass.value");
    desk.type("0");
    desk.key(Key::enter);
    EXPECT_EQ(desk.recorder.changes.size(), changes) << "a mass must be > 0";
}

TEST_F(WithHands, the_panel_kicks_by_numbers) {
    desk.calls();
    const auto kick_by = [&](const char* text) {
        desk.click("selection.velocity");
        desk.key(Key::a, true);
        desk.type(text);
        desk.click("selection.kick");
        return desk.calls();
    };
    EXPECT_THAT(kick_by("0.5, -2,1e-1"), ElementsAre("act"));
    EXPECT_EQ(last_act<Kick>(), (Kick{5, {0.5, -2, 0.1}}));
    for (const char* wrong : {"1, 2", "1 2 3", "1, 2, x", "", "1, 2, 3, 4"})
        EXPECT_THAT(kick_by(wrong), IsEmpty()) << wrong;
}

}  // namespace
}  // namespace steplab::ui
